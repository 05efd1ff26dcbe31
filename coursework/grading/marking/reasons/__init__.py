"""Why a grade is what it is, in sentences that a student can check."""
