"""A position on paper: layout, symbols, SVG in millimetres."""
