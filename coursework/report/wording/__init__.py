"""What a page says in sentences that several sections share."""
