"""A variant after reading: frozen records, SI numbers, checked formulas."""
