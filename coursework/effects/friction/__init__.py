"""Friction: of pins, guides and wheels in the rows of a motion, of a state that forces move, and where it stops everything."""
