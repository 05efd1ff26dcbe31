"""Bytes of a table as any program writes it -> the student's numbers on the assigned grid, and how they were read."""
