"""What the page says of the result: the answer, the control of the solution, the conclusion, every check in detail."""
