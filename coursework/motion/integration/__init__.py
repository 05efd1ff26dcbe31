"""The reduction made a right-hand side (`rates`), marched with a scheme (`integrate`) or without error (`exact_motion`)."""
