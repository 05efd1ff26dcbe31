"""Bytes of a file as sheets of cells, whatever program wrote it; every size bounded."""
