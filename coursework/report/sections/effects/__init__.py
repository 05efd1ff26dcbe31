"""The parts of a page on forces: data of masses and loads, plans and rows of forces, the motion under forces."""
