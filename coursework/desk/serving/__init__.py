"""What the browser talks to: who may, how much, the files of the folder.  It computes nothing and imports no mathematics."""
