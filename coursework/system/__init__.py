"""What every run leans on: files written whole, streams, limits of time and memory, what is computed on demand."""
