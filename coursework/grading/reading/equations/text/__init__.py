"""A text -> the lines that are equations, and what the student defines, lists or remarks in the others."""
