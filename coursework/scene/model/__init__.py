"""One template compiled once for any number of data sets: structure in `model`, numbers in `data`."""
