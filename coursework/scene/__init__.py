"""One variant, lazily: the way to its motion, what follows from it, and what can be asked for."""
