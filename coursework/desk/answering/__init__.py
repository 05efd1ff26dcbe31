"""What the processes behind the desk do: a job as data in, an answer as bytes out."""
