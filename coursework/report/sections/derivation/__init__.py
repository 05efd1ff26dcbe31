"""The derivation on paper from the constraints to the velocities, and a row of a further table computed in numbers."""
