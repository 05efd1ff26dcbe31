"""Forces as effects computed on demand: kinetostatics, virtual power, energy, motion under forces."""
