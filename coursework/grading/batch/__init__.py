"""A folder of submissions -> a gradebook; each submission in a supervised child, so that none stops the rest."""
