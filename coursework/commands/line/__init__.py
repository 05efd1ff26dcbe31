"""The command line itself: options that commands share, completion in the shell, misuse, the screen and the exit status."""
