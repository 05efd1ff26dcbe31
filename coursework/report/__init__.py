"""Pages of a run: text and formulas, graphs, sections, the part that moves, and the files that are written."""
