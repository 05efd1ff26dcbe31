"""The work of the processes behind the desk: a job comes in as data, an answer goes out as bytes."""
