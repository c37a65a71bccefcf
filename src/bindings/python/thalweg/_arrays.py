"""numpy arrays in and out. Arrays that fit already are not copied."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

MOST = 2**31 - 1
"""Ids are int32 in every array, as in scipy."""


def numbers(values: ArrayLike, name: str) -> NDArray[np.float64]:
    """C-contiguous float64. Raises TypeError for what are no real numbers, ValueError for masked elements."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():  # type: ignore[no-untyped-call]
        raise ValueError(f"{name} has masked elements: leave them out")
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        if array.size:
            raise TypeError(f"{name} must be an array of real numbers, not of {array.dtype}")
        array = array.astype(np.float64)
    return np.ascontiguousarray(array, dtype=np.float64)


def _rows(values: ArrayLike, name: str, shapes: str, *widths: int) -> NDArray[np.float64]:
    array = numbers(values, name)
    if array.size == 0 and array.ndim <= 2:
        array = array.reshape(0, widths[0])
    if array.ndim != 2 or array.shape[1] not in widths:
        raise ValueError(f"{name} must have shape {shapes}, not {array.shape}")
    if len(array) > MOST:
        raise ValueError(f"{name}: {len(array)} are more than 32-bit ids can number")
    return array


def points3(points: ArrayLike) -> NDArray[np.float64]:
    """(n, 3)."""
    return _rows(points, "points", "(n, 3)", 3)


def points2(points: ArrayLike, name: str = "points") -> NDArray[np.float64]:
    """(n, 2), of points with or without an elevation."""
    array = _rows(points, name, "(n, 2) or (n, 3)", 2, 3)
    return array if array.shape[1] == 2 else np.ascontiguousarray(array[:, :2])


def triangles(values: ArrayLike) -> NDArray[np.uint32]:
    """(m, 3) of ids; negative ones become ids that no point has."""
    array = np.asarray(values)
    if array.size == 0 and array.ndim <= 2:
        return np.empty((0, 3), np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"triangles must be an array of integers, not of {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"triangles must have shape (m, 3), not {array.shape}")
    if array.dtype == np.int32 and array.flags.c_contiguous:
        return array.view(np.uint32)  # -1 is already what no point is called
    beyond = (array < 0) | (array > MOST)
    return np.ascontiguousarray(np.where(beyond, 2**32 - 1, array), dtype=np.uint32)


def count(value: Any, name: str) -> int:
    """A whole number from 0, as the library takes it."""
    number = operator.index(value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, but is {number}")
    return min(number, 2**32 - 1)


def address(array: NDArray[Any]) -> int:
    return array.ctypes.data


def choice(value: str, names: tuple[str, ...], what: str) -> int:
    """The place of a word in a list of words."""
    if value not in names:
        raise ValueError(f"{what} must be one of {', '.join(names)}, not {value!r}")
    return names.index(value)
