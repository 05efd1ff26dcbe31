"""The forces of a motion that is known: reactions and drive in three ways, energy, flywheel, and the checks of all of them."""
