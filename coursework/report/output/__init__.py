"""Results on disk: formats, the gate before them, tables, the record of a run, and the set they are written as."""
