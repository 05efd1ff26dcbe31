"""A variant file: text into a checked `Variant`; what it says, what it may say, and what is wrong with it."""
