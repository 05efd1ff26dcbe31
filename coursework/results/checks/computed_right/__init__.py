"""The checks that judge the rows by their own equations and start values: was the table computed right?"""
