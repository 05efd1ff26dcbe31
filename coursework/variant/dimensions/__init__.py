"""What each part of a formula measures, as exponents of length and time: `System`, `Measurer`, `Clash`."""
