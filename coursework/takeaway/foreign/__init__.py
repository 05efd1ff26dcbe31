"""Mechanisms of other programs as variant files: PMKS, pylinkage, Linkage."""
