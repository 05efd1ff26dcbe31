"""Causes of a wrong table: hypotheses, what each claims about a cell, and which of them explains the table."""
