"""A folder or zip of submissions: which files belong to which student."""
