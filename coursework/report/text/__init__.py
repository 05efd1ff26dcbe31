"""Numbers, symbols and words as a page sets them, and the parts that a page is built of."""
