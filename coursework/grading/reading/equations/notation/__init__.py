"""Signs of programs, commands of LaTeX and conversions of degrees -> the plain signs in which an equation is read."""
