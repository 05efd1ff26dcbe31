"""The live part of a page: the functions of the mechanism as JavaScript, its numbers as JSON, one script with its hash."""
