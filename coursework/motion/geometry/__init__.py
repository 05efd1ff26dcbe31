"""What is known without a march: the drive and its integral, closed positions by Newton or by a chain, exact derivatives."""
