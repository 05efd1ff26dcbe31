"""Marks for what was understood of a submission: cells, equations, answers, misconceptions; numbers only, no text is run."""
