"""What each command does and prints, thin over the library; a file a command."""
