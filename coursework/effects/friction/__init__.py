"""Friction: of pins, guides and wheels in the rows of a motion, in a state moved by forces, and where it stops everything."""
