"""Individual variants for a class: data drawn from ranges, task sheets for students, keys and a page for the instructor."""
