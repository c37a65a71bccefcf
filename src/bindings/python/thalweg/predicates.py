"""Exact geometric predicates. Each point is a pair x, y of finite numbers."""

from __future__ import annotations

from ctypes import byref, c_int
from typing import Any

from numpy.typing import ArrayLike

from . import _arrays
from ._abi import call, lib
from ._arrays import address


def _sign(function: Any, *points: ArrayLike) -> int:
    arrays = [_arrays.numbers(p, "a point") for p in points]
    for array in arrays:
        if array.shape != (2,):
            raise ValueError(f"a point must have shape (2,), not {array.shape}")
    sign = c_int()
    call(function, *[address(a) for a in arrays], byref(sign))
    return sign.value


def orient2d(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> int:
    """+1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they are on one line. Exact."""
    return _sign(lib.orient2d, a, b, c)


def incircle(a: ArrayLike, b: ArrayLike, c: ArrayLike, d: ArrayLike) -> int:
    """+1 if d is strictly inside the circle through a, b, c (counter-clockwise), 0 if on it, -1 if outside. Exact."""
    return _sign(lib.incircle, a, b, c, d)


def compare_distance(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> int:
    """-1 if b is nearer to a than c is, 0 if equally far, +1 if farther. Exact."""
    return _sign(lib.compare_distance, a, b, c)
