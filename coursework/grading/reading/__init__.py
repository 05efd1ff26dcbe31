"""What a student handed in: files, the table, the equations and answers in them, and how each was read."""
