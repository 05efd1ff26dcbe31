"""The command line itself: options that commands share, what the shell offers, what is said of a line nobody can understand."""
