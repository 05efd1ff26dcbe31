"""Individual variants for a class: data drawn from ranges, sheets for the students, a key and a page for the instructor."""
