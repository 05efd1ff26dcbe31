"""Mechanism -> velocity equations A(q, t) u = b(q, t) (`equations`) -> blocks in order, each with its determinant (`blocks`)."""
