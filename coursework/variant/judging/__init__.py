"""What is wrong with a file that can be read: dimensions, values at the start, sizes; what looks like a slip of the pen."""
