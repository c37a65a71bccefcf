"""The main job: points in, a terrain with as few pits as can be found out."""

from __future__ import annotations

from ctypes import byref, c_void_p, sizeof
from typing import Any, Literal, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays
from ._abi import BuildOptions, PitCounts, Summary, call, lib, new_error, raise_for
from ._arrays import address
from ._run import Progress, run
from .mesh import Mesh, read_mesh

Method = Literal["delaunay", "flip", "hull", "best", "exact"]
Duplicates = Literal["lowest", "highest", "mean", "first", "last", "error"]
Counter = Literal["crawl", "voronoi"]

# In the order of the numbers in thalweg.h.
_METHODS = ("delaunay", "flip", "hull", "best", "exact")
_DUPLICATES = ("lowest", "highest", "mean", "first", "last", "error")
_COUNTERS = ("crawl", "voronoi")
_REASONS = ("unremovable", "conflict", "kept")
_KINDS = ("flip", "insertion")

# As the C structs lie in memory.
_REMAINING = [("vertex", "u4"), ("vertices", "u4"), ("boundary", "u4"), ("reason", "i4"), ("order_needed", "u4")]
_REMOVED = [("vertex", "u4"), ("vertices", "u4"), ("boundary", "u4")]
_MEANS = [("z", "f8"), ("row", "u4"), ("reserved", "u4")]
_STEPS = [("kind", "i4")] + [(name, "u4") for name in ("order", "u", "v", "old_u", "old_v", "pit")]
_SWEEP = [(name, "u4") for name in ("order", "flip", "hull", "best", "lower_bound", "certified")]

# As they are given to the caller.
_PIT = [("vertex", "i4"), ("vertices", "i4"), ("boundary", "?"), ("reason", "U11"), ("order_needed", "i4")]
_REMOVED_PIT = [("vertex", "i4"), ("vertices", "i4"), ("boundary", "?")]
_STEP = [("kind", "U9")] + [(name, "i4") for name in ("order", "u", "v", "old_u", "old_v", "pit")]
_SWEEP_ROW = [(name, "i4") for name in ("order", "flip", "hull", "best", "lower_bound")] + [("certified", "?")]


class PitCount(NamedTuple):
    """Numbers of pits: total = interior + boundary; boundary pits touch the convex hull."""

    total: int
    interior: int
    boundary: int


class Terrain(Mesh):
    """A terrain of order k with its report. Beside what a `Mesh` has:

    Attributes
    ----------
    points : float64 (n, 3)
        The points as given (with duplicates="mean" a copy with the mean elevations).
    orders : int32 (m,)
        The order of each triangle: how many points are strictly inside its circumcircle.
    pits : structured array (pits,)
        The pits that are left, by vertex: `vertex` (int32, its first in elevation order z, x, y), `vertices` (int32,
        how many it has), `boundary` (bool), `reason` (str: "unremovable", "conflict" or "kept"), `order_needed`
        (int32: the least order that joins it to lower ground, -1 if none was found).
    removed : structured array
        The pits of the Delaunay triangulation that are no more: `vertex`, `vertices`, `boundary`.
    pit_count, delaunay_pit_count : PitCount
        After and before.
    lower_bound : int
        No triangulation of this order has fewer pits.
    certified : bool
        Whether the number of pits is proved to be the least.
    merged : int32 (d, 2)
        Rows that are in no triangle, each with the row at the same place that is.
    trail : structured array or None
        With keep_trail=True the changes in order: `kind` (str: "flip" or "insertion"), `order`, `u`, `v` (the edge
        that came), `old_u`, `old_v` (the edge that went, -1 for insertions), `pit` (first vertex of the pit that is
        gone by it, or -1); all int32.
    statistics : dict
        site_count, max_order, order_searched, edges_changed, non_delaunay_edges, flips, insertions, circle_counts,
        min_angle_before_deg, min_angle_after_deg (degrees), seconds_delaunay, seconds_minimize (seconds).
    """

    orders: NDArray[np.int32]
    pits: NDArray[np.void]
    removed: NDArray[np.void]
    pit_count: PitCount
    delaunay_pit_count: PitCount
    lower_bound: int
    certified: bool
    merged: NDArray[np.int32]
    trail: Optional[NDArray[np.void]]
    statistics: dict[str, Any]

    def __repr__(self) -> str:
        proof = "certified" if self.certified else f"at least {self.lower_bound}"
        return (
            f"<Terrain: {len(self.points)} points, {len(self.triangles)} triangles, "
            f"{self.delaunay_pit_count.total} -> {self.pit_count.total} pits, {proof}>"
        )


def build(
    points: ArrayLike,
    order: int = 8,
    method: Method = "best",
    *,
    duplicates: Duplicates = "lowest",
    counter: Counter = "crawl",
    threads: int = 0,
    time_limit: Optional[float] = None,
    keep_trail: bool = False,
    progress: Optional[Progress] = None,
) -> Terrain:
    """A terrain over points (n, 3) with as few pits as `method` finds in triangulations of at most this order.

    Parameters
    ----------
    points : array (n, 3)
        Rows of x, y, z. Not changed; not copied if C-contiguous float64.
    order : int
        k: every circumcircle holds at most so many points. 0 is Delaunay.
    method : "delaunay", "flip", "hull", "best" or "exact"
    duplicates : "lowest", "highest", "mean", "first", "last" or "error"
        Which elevation a place takes that occurs in several rows. All but "mean" choose one of the rows, and the
        others are in no triangle (see `Terrain.merged`).
    counter : "crawl" or "voronoi"
        How points in circles are counted; the result is the same.
    threads : int
        0 = all of the machine; the result does not depend on it.
    time_limit : seconds
        How long "exact" may search beyond "best"; None = to the end.
    keep_trail : bool
        Fill `Terrain.trail`.
    progress : callable (stage: str, fraction: float)
        Called now and then in the calling thread, fraction in [0, 1]. If it raises, the run stops and raises that.

    Raises InputError for points that are not finite, fewer than three places, all on one line, or repeated under
    duplicates="error". Ctrl-C stops a run.
    """
    xyz = _arrays.points3(points)
    options = _options(order, method, duplicates, counter, threads, time_limit)
    options.keep_trail = bool(keep_trail)
    handle = c_void_p()
    try:
        run(lambda: call(lib.build, address(xyz), len(xyz), byref(options), byref(handle)), options, progress)
        return _read_terrain(handle, xyz, keep_trail)
    finally:
        lib.terrain_free(handle)


def sweep(
    points: ArrayLike,
    first: int,
    last: int,
    *,
    duplicates: Duplicates = "lowest",
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> NDArray[np.void]:
    """The numbers of pits of flip, hull and best for every order from `first` to `last` over points (n, 3).

    Returns a structured array with `order`, `flip`, `hull`, `best`, `lower_bound` (int32) and `certified` (bool).
    Other parameters and errors as `build`.
    """
    xyz = _arrays.points3(points)
    options = _options(0, "best", duplicates, "crawl", threads, None)
    low, high = _arrays.count(first, "first"), _arrays.count(last, "last")
    if low > high or high - low >= 10**6:
        raise ValueError("a sweep needs a first order that is not larger than the last, and at most a million orders")
    rows = np.empty(high - low + 1, _SWEEP)
    run(
        lambda: call(lib.sweep, address(xyz), len(xyz), low, high, byref(options), address(rows), len(rows)),
        options,
        progress,
    )
    return rows.astype(_SWEEP_ROW)


def _options(
    order: int, method: str, duplicates: str, counter: str, threads: int, time_limit: Optional[float]
) -> BuildOptions:
    options = BuildOptions()
    raise_for(lib.build_options_init(byref(options), sizeof(options)), new_error())
    options.order = _arrays.count(order, "order")
    options.method = _arrays.choice(method, _METHODS, "method")
    options.duplicates = _arrays.choice(duplicates, _DUPLICATES, "duplicates")
    options.counter = _arrays.choice(counter, _COUNTERS, "counter")
    options.threads = _arrays.count(threads, "threads")
    if time_limit is not None:
        if not time_limit > 0:
            raise ValueError(f"time_limit must be a positive number of seconds, not {time_limit!r}")
        options.time_limit = time_limit
    return options


def _read(function: Any, handle: c_void_p, count: int, fields: list[tuple[str, str]]) -> NDArray[np.void]:
    rows = np.empty(count, fields)
    call(function, handle, address(rows), count)
    return rows


def _named(rows: NDArray[np.void], fields: list[tuple[str, str]], column: str, names: tuple[str, ...]) -> Any:
    """The rows with numbers of ids as int32 (none = -1) and the numbers of one column as words."""
    out = np.empty(len(rows), fields)
    for name, _ in fields:
        if name == column:
            out[name] = np.array(names)[rows[name]]
        else:
            out[name] = rows[name].view(np.int32)
    return out


def _pit_count(counts: PitCounts) -> PitCount:
    return PitCount(counts.total, counts.interior, counts.boundary)


def _read_terrain(handle: c_void_p, xyz: NDArray[np.float64], keep_trail: bool) -> Terrain:
    s = Summary(struct_size=sizeof(Summary))
    call(lib.terrain_summary, handle, byref(s))
    terrain = Terrain(xyz, *read_mesh(lib.terrain_mesh(handle)))
    terrain.orders = np.empty(s.triangle_count, np.int32)
    call(lib.terrain_orders, handle, address(terrain.orders), len(terrain.orders))
    terrain.pits = _named(
        _read(lib.terrain_remaining, handle, s.remaining_count, _REMAINING), _PIT, "reason", _REASONS
    )
    terrain.removed = _read(lib.terrain_removed, handle, s.removed_count, _REMOVED).astype(_REMOVED_PIT)
    terrain.pit_count, terrain.delaunay_pit_count = _pit_count(s.pits), _pit_count(s.delaunay_pits)
    terrain.lower_bound, terrain.certified = s.lower_bound, bool(s.certified)
    terrain.merged = np.empty((s.merged_count, 2), np.int32)
    call(lib.terrain_merged, handle, address(terrain.merged), s.merged_count)
    terrain.trail = None
    if keep_trail:
        terrain.trail = _named(_read(lib.terrain_trail, handle, s.trail_count, _STEPS), _STEP, "kind", _KINDS)
    if s.mean_count:
        means = _read(lib.terrain_means, handle, s.mean_count, _MEANS)
        terrain.points = xyz.copy()
        terrain.points[means["row"], 2] = means["z"]
    terrain.statistics = {
        name: getattr(s, name)
        for name in (
            "site_count", "max_order", "order_searched", "edges_changed", "non_delaunay_edges", "flips", "insertions",
            "circle_counts", "min_angle_before_deg", "min_angle_after_deg", "seconds_delaunay", "seconds_minimize",
        )
    }  # fmt: skip
    return terrain
