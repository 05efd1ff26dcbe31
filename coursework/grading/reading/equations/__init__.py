"""Lines of a submission as equations, answers, or a variant file."""
