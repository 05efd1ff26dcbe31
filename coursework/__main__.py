"""`python -m coursework …` is the command line."""

from __future__ import annotations

from coursework.commands.cli import main

if __name__ == "__main__":
    main()
