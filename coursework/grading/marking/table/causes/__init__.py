"""What a wrong table was made with: hypotheses, what each claims of a cell, which of them explains the table."""
