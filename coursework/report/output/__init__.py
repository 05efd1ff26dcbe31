"""Results on disk: formats, the check before they are written, tables, the record of a run, and the set of its files."""
