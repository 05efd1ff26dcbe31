"""A position on paper, and constructions with ruler and compasses."""
