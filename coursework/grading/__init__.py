"""Many submissions -> marks: what was handed in is read here, understood, marked and written out; the text is data throughout."""
