"""The part of a page that moves: the mechanism's functions as JavaScript, its numbers as JSON, one script with its hash."""
