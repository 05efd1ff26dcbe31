"""The server that the browser talks to: access, limits, the files of the folder.  It computes and imports no mathematics."""
