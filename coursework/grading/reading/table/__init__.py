"""Sheets of cells as the student's table on the assigned grid."""
