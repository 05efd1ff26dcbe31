"""One variant, computed lazily: the way to its motion, its results, and what can be asked for."""
