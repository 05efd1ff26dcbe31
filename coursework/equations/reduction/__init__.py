"""Mechanism -> velocity equations A(q, t) u = b(q, t) (`equations`) -> ordered blocks, each with its determinant (`blocks`)."""
