"""The motion that forces make: its equations, rows by a scheme, the motion itself, what a step costs."""
