"""The pages on graded work, for a student and for the instructor: small, and without scripts."""
