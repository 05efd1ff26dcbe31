"""Motion under forces: its equations, rows by a scheme, the exact motion, the cost of a step."""
