"""Drafts of chains of groups that nobody has drawn yet: names, dimensions with which the chain closes, and the file."""
