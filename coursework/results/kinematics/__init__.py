"""Results computed from a motion on request: accelerations, points, analogs, invariants, instantaneous centres."""
