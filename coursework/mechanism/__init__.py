"""Links, joints, Assur groups, contours: a variant as a mechanism, and what its points say of velocities."""
