"""A variant file and what it says: `read_variant(path)`, `parse_variant(text)`, the record `Variant`."""
