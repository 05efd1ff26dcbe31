"""Rows by a scheme, exact rows, and where a motion ends and why."""
