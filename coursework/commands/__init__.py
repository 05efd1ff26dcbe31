"""The commands: what each does and prints, as thin layers over the library, one file per command."""
