"""Was the table computed right?  The checks that judge the rows by their own equations and start values."""
