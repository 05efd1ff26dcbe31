"""Expressions: one immutable tree in one canonical form, calculus on it, and its SymPy object on demand."""
