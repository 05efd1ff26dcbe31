"""Expressions: one immutable tree in one canonical form, calculus on it, and SymPy's object of it when asked for."""
