"""Text of a file into a `Variant`, or every fault of it with line and advice; the only room that knows pydantic."""
