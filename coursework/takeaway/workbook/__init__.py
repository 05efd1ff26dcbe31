"""The coursework as a workbook that computes: data, Euler's table as formulas, the exact motion beside it, checks, graphs."""
