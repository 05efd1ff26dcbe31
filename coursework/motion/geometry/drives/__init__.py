"""The drives as functions of time: values, bounds, integrals, how fast they oscillate and swing."""
