"""Where a motion ends and why: the flow scaled by its determinant, dead points, change points, and their meaning."""
