"""Facts about a motion, each with a stable code; `check.check_motion` runs the families in order."""
