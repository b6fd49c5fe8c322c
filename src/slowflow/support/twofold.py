"""Sums and products with their rounding errors: error-free transforms by Dekker and Knuth, on floats and arrays.

native/twofold.h is the same for C.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """a + b and its rounding error."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def _split(a: Any) -> tuple[Any, Any]:
    t = 134217729.0 * a
    high = t - (t - a)
    return high, a - high


def two_product(a: Any, b: Any) -> tuple[Any, Any]:
    """a b and its rounding error, by Dekker's splitting: NumPy has no fma."""
    p = a * b
    a_high, a_low = _split(a)
    b_high, b_low = (a_high, a_low) if b is a else _split(b)
    return p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def distilled(terms: Sequence[Any]) -> Any:
    """The sum of some doubles, distilled until they no longer overlap: its sign is certain."""
    sums = list(terms)
    for _ in sums:
        for i in range(1, len(sums)):
            sums[i], sums[i - 1] = two_sum(sums[i], sums[i - 1])
    return sum(sums)
