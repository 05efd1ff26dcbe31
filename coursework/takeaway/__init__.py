"""What a person takes along from a run: frames of numbers, plots, files for other programs."""
