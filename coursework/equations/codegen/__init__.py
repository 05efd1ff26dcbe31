"""THE door between symbols and numbers: SymPy expressions -> straight-line Python over `math` or NumPy (`programs`)."""
