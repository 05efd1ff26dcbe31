"""What every run relies on: whole files, streams, limits of time and memory, values that are computed on demand."""
