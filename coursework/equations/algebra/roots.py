"""Roots of whole numbers: what is rational of a product of powers of primes, and what is left of it.

Enters: positive fractions and exponents.  Leaves: a fraction, and whole numbers under each root.  Used by `expression.py`.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache

Primes = dict[int, Fraction]  # prime -> its exponent
_LARGEST_PRIME = 2**15


def gather(primes: Primes, value: Fraction, exponent: Fraction) -> None:
    """Multiply a product of powers of primes by a power of a positive number."""
    for whole, sign in ((value.numerator, 1), (value.denominator, -1)):
        for prime, times in _factored(whole):
            primes[prime] = primes.get(prime, Fraction(0)) + sign * times * exponent


@lru_cache(maxsize=256)
def _factored(whole: int) -> tuple[tuple[int, int], ...]:
    """Return primes and how often each divides a whole number; what no small prime divides stands for one."""
    found, prime = dict[int, int](), 2
    while prime * prime <= whole and prime < _LARGEST_PRIME:
        while whole % prime == 0:
            whole //= prime
            found[prime] = found.get(prime, 0) + 1
        prime += 1
    root = math.isqrt(whole)
    left, times = (root, 2) if root * root == whole else (whole, 1)
    return (*found.items(), *(((left, times),) if left > 1 else ()))


def roots(primes: Primes) -> tuple[Fraction, dict[Fraction, int]]:
    """Return the rational part of a product of powers of primes, and the number left under each root: sqrt(8) is 2, {1/2: 2}."""
    total, left = Fraction(1), dict[Fraction, int]()
    for prime, exponent in primes.items():
        whole = math.floor(exponent)
        total *= Fraction(prime) ** whole
        if exponent != whole:
            left[exponent - whole] = left.get(exponent - whole, 1) * prime
    return total, left
