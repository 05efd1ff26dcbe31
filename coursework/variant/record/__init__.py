"""What a variant is once it has been read: frozen records, SI numbers, checked formulas."""
