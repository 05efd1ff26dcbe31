"""One equation as typed -> checked trees: its labels, names, repairs and meanings."""
