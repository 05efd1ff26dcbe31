"""What a person takes away from a run: data frames, plots, files for other programs."""
