"""A(q, t)·u = b(q, t): velocity equations, the blocks in which they are solved, and the programs made from them."""
