"""From the constraints to the velocities on paper, and a row of a further table worked through."""
