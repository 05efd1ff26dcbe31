"""A sheet in millimetres: lines, symbols, and words that do not cover each other."""
