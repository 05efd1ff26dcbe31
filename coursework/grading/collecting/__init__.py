"""A folder or zip of submissions: whose files are whose."""
