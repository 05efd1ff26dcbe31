"""The check by drawing: one row on a sheet, what is read from it, and what that comes to."""
