"""Facts about a motion, each with a stable code; `check.check_motion` runs all checks in order."""
