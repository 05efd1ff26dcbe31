"""What a right table is: the key of a variant, of the mechanism assembled or read otherwise, and of what forces move."""
