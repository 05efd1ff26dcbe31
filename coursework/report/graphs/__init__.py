"""Small graphs, drawings as figures, the animated picture."""
