"""The command line itself: options that commands share, completion in the shell, messages for a misused one, the screen, the exit status."""
