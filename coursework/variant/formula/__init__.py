"""Text -> checked formulas and values with units: names, numbers, trees; nothing here executes text."""
