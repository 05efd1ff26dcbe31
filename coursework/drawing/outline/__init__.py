"""What a mechanism looks like, by names of points only, and where these points are."""
