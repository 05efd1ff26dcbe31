"""The coursework as a program of one's own in five languages, and the block diagram of that very program."""
