"""Expressions in the author's order and in the compact form of a textbook."""
