"""The velocities of a block as a textbook writes them, by Cramer's rule or one after the other."""
