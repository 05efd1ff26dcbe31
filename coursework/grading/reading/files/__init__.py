"""The bytes of a file -> sheets of cells, whatever program wrote it; every size is limited."""
