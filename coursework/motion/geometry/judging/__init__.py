"""Whether what a file says of links and velocities agrees with its points and closures."""
