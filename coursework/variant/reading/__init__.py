"""The text of a file into a `Variant`, or all its faults with line and advice; the only room that uses pydantic."""
