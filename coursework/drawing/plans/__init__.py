"""Plans of velocities and accelerations, constructed with ruler and compasses."""
