"""`python -m coursework …` is the command line."""

from __future__ import annotations

from coursework.cli import main

main()
