"""The coursework as a program in five languages for the student, and the block diagram of that program."""
