"""Files written whole, sets of files, a lock on a folder, zips and CSV with the same bytes every time."""
