"""Constructions with ruler and compasses, and what is read from them."""
