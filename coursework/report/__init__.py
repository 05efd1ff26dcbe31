"""Pages of a run: text and formulas, graphs, sections, the live part, and the files that are written."""
