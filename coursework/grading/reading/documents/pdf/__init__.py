"""A PDF -> its letters, lines and tables."""
