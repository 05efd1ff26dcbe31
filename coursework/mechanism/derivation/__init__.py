"""Velocity equations from the points of a mechanism alone, as a student derives them; records, without sentences."""
