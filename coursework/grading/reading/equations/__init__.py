"""Lines of a submission -> equations, answers, or a variant file."""
