"""Marks for a submission that was read: cells, equations, answers, misconceptions; works on numbers only and runs no text."""
