"""Everything a person can be told, in any language: sentences by key, faults, the folders they stand in, text of pages."""
