"""What a right table is: the key of a variant, tables of the mechanism assembled or misread otherwise, motion under forces."""
