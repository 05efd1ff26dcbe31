"""One template compiled once for any number of sets of data: structure in `model`, numbers in `data`."""
