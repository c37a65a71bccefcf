"""Which k points are the nearest, everywhere in the plane."""

from __future__ import annotations

import weakref
from ctypes import byref, c_size_t
from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays
from ._abi import USAGE, call, lib, make, new_error, raise_for
from ._arrays import address


class OrderKVoronoi:
    """The order-k Voronoi diagram of points (n, 2) or (n, 3), of which x and y count.

    A cell is where the k nearest points are the same. Of rows at the same place the first stands for all. One point,
    and points on one line, are legal. Exact. Takes O(k^2 n + n log n) time and about 415 k bytes a point to build.
    Immutable; may be shared among threads.

    Raises InputError for points that are not finite or fewer than k, ValueError for k = 0.
    """

    def __init__(self, points: ArrayLike, k: int, *, threads: int = 0) -> None:
        xy = _arrays.points2(points)
        self._threads = _arrays.count(threads, "threads")
        self._handle = make(lib.voronoi_new, address(xy), len(xy), _arrays.count(k, "k"), self._threads)
        weakref.finalize(self, lib.voronoi_free, self._handle)
        self._k = int(k)

    @property
    def k(self) -> int:
        """The order."""
        return self._k

    @property
    def site_count(self) -> int:
        """The number of distinct places."""
        return int(lib.voronoi_site_count(self._handle))

    @property
    def cell_count(self) -> int:
        """The number of cells."""
        return int(lib.voronoi_cell_count(self._handle))

    @property
    def nbytes(self) -> int:
        """Bytes of memory that the diagram holds."""
        return int(lib.voronoi_memory_bytes(self._handle))

    def query(self, places: ArrayLike) -> NDArray[np.int32]:
        """The k nearest points of each place, int32 (q, k) for places (q, 2), or (k,) for one place (2,).

        Nearest first, equal distances by (x, y). Exact. Expected O(log n + k log k) a place.
        """
        return self._ask(lib.voronoi_nearest, places, self._k)

    def locate(self, places: ArrayLike) -> NDArray[np.int32]:
        """The cell that holds each place, int32 (q,), or () for one place (2,). Ties as in `query`."""
        cells: NDArray[np.int32] = self._ask(lib.voronoi_locate, places, 1)[..., 0]
        return cells

    def cell_sites(self, cell: int) -> NDArray[np.int32]:
        """The k points of a cell, int32 (k,), ascending. Raises ValueError if there is no such cell."""
        sites = np.empty(self._k, np.int32)
        call(lib.voronoi_cell_sites, self._handle, _arrays.count(cell, "cell"), address(sites), len(sites))
        return sites

    def polygon(self, cell: int, box: Sequence[float]) -> NDArray[np.float64]:
        """The corners of a cell, float64 (c, 2), counter-clockwise, clipped to the box (low x, low y, high x, high y).

        In rounded coordinates, for drawing. (0, 2) if nothing of the cell is in the box.
        """
        number, limits = _arrays.count(cell, "cell"), _arrays.numbers(box, "box")
        if limits.shape != (4,):
            raise ValueError(f"box must have shape (4,), not {limits.shape}")
        corners, error, out = c_size_t(), new_error(), np.empty((16, 2))
        for _ in range(2):
            status = lib.voronoi_polygon(
                self._handle, number, address(limits), address(out), out.size, byref(corners), byref(error)
            )
            if status != USAGE or corners.value <= len(out):
                break
            out = np.empty((corners.value, 2))
        raise_for(status, error)
        return out[: corners.value]

    def _ask(self, function: Any, places: ArrayLike, width: int) -> NDArray[np.int32]:
        array = _arrays.numbers(places, "places")
        if single := array.shape == (2,):
            array = array.reshape(1, 2)
        xy = _arrays.points2(array, "places")
        out = np.empty((len(xy), width), np.int32)
        call(function, self._handle, address(xy), len(xy), self._threads, address(out), out.size)
        answer: NDArray[np.int32] = out[0] if single else out
        return answer

    def __repr__(self) -> str:
        return f"<OrderKVoronoi: order {self._k}, {self.site_count} sites, {self.cell_count} cells>"
