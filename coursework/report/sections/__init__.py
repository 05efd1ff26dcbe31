"""The sections of the report, in the order of `sections.py`."""
