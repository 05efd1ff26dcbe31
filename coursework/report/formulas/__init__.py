"""Formulas as a page sets them: Typst math, lines of a display, SVG."""
