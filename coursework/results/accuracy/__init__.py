"""The cost of accuracy: error against evaluations and time for one scene, by the protocol of a work-precision study."""
