"""One line, matrix or program as typed -> the equations it contains."""
