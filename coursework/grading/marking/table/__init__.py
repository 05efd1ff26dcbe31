"""The cells of a table: each right in some way or wrong, and the causes that explain wrong ones."""
