"""What is written beside a mechanism: names, lengths, angles, offsets."""
