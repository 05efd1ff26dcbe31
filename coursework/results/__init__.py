"""What follows from a motion: accelerations, points, analogs; verdicts; what accuracy costs."""
