"""A chain of groups that nobody has drawn yet: names, dimensions in which it closes, and the file that says so."""
