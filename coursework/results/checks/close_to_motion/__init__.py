"""The checks that compare the table with the exact motion of the mechanism: is it close?"""
