"""The parts of a page that judge the result: the answer, the control of the solution, the conclusion, all checks in detail."""
