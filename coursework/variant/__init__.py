"""A variant file: its text into a checked `Variant`; what a file may contain, and what is wrong with it."""
