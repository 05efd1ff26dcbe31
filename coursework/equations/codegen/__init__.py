"""THE door between symbols and numbers: expressions -> straight-line Python over `math` or NumPy (`programs`)."""
