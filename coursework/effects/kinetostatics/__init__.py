"""The forces of a known motion: reactions and drive in three ways, energy, flywheel, and the checks of all of them."""
