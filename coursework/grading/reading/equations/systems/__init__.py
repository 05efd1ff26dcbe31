"""One line, matrix or program as typed -> the equations that it stands for."""
