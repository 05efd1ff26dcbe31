"""Many submissions -> marks: collected, read, marked, written out; the text of students is treated as data throughout."""
