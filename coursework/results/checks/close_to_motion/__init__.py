"""Is the table close to the motion of the mechanism?  The checks that judge the rows by the exact motion."""
