"""What a mechanism looks like, in names of points only, and where these are."""
