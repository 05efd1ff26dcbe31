"""Faults of a file that could be read: dimensions, values at the start, sizes; and remarks on probable slips."""
