"""A(q, t)·u = b(q, t): velocity equations, their blocks in order, and the programs made of them."""
