"""A sheet in millimetres: lines, signs, words that keep out of each other's way."""
