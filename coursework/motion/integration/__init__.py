"""The reduction as a right-hand side (`rates`), integrated with a scheme (`integrate`) or without error (`exact_motion`)."""
