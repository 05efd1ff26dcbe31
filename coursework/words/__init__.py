"""Everything the user is told, in any language: sentences by key, faults, text of pages, and the folders of these texts."""
