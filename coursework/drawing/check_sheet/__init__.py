"""The check by drawing: one row on a sheet, what is read off it, and the values that follow."""
