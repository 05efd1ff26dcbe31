"""The formats of learning platforms: names of downloads, worksheets to fill in, results for autograders."""
