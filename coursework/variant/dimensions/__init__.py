"""The dimension of each part of a formula, as exponents of length, time and mass: `System`, `Measurer`, `Clash`."""
