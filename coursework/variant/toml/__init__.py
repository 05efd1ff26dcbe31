"""A TOML file with the line and column of every key, and the same file with other values."""
