"""The cells of a table: right in any way or wrong, and what explains those that are wrong."""
