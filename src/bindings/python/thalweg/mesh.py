"""Triangulations, and questions about anybody's triangles."""

from __future__ import annotations

from ctypes import byref, c_void_p
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays
from ._abi import VERIFICATION, call, lib, make, new_error, raise_for
from ._arrays import address

if TYPE_CHECKING:
    from matplotlib.tri import Triangulation  # type: ignore[import]


class Mesh:
    """A triangulation of points, with the names and conventions of scipy.spatial.Delaunay.

    Attributes
    ----------
    points : float64 (n, 2) or (n, 3)
        The points as given: the caller's own array if it was C-contiguous float64, else a copy.
    triangles : int32 (m, 3)
        Rows of `points`, counter-clockwise. Also called `simplices`.
    neighbors : int32 (m, 3)
        neighbors[i, j] is the triangle opposite to the corner triangles[i, j]; -1 at the hull.
    """

    def __init__(
        self, points: NDArray[np.float64], triangles: NDArray[np.int32], neighbors: NDArray[np.int32]
    ) -> None:
        self.points = points
        self.triangles = triangles
        self.neighbors = neighbors

    @property
    def simplices(self) -> NDArray[np.int32]:
        """The triangles, int32 (m, 3), by scipy's name."""
        return self.triangles

    @property
    def convex_hull(self) -> NDArray[np.int32]:
        """The edges of the convex hull, int32 (h, 2), each with the inside on its left."""
        triangle, corner = np.nonzero(self.neighbors == -1)
        return np.stack(
            [self.triangles[triangle, (corner + 1) % 3], self.triangles[triangle, (corner + 2) % 3]], axis=1
        )

    @property
    def vertex_neighbor_vertices(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """(indptr, indices): vertex v is joined to indices[indptr[v]:indptr[v + 1]], ascending."""
        t = self.triangles
        directed = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]).astype(np.int64)
        n = len(self.points)
        both = np.unique(np.concatenate([directed[:, 0] * n + directed[:, 1], directed[:, 1] * n + directed[:, 0]]))
        starts = np.searchsorted(both, np.arange(n + 1, dtype=np.int64) * n)
        return starts.astype(np.int32), (both % n if n else both).astype(np.int32)

    def to_matplotlib(self) -> Triangulation:
        """The mesh as a matplotlib.tri.Triangulation, for tripcolor, tricontour and the like."""
        from matplotlib.tri import Triangulation

        return Triangulation(self.points[:, 0], self.points[:, 1], self.triangles)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self.points)} points, {len(self.triangles)} triangles>"


def read_mesh(handle: Any) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """The triangles and neighbours of a mesh handle, written straight into new arrays."""
    m = lib.mesh_triangle_count(handle)
    triangles, neighbors = np.empty((m, 3), np.int32), np.empty((m, 3), np.int32)
    call(lib.mesh_triangles, handle, address(triangles), triangles.size)
    call(lib.mesh_neighbors, handle, address(neighbors), neighbors.size)
    return triangles, neighbors


def delaunay(points: ArrayLike, *, threads: int = 0) -> Mesh:
    """The Delaunay triangulation of points (n, 2) or (n, 3), of which x and y count.

    Where four and more points lie on one empty circle it is the same one every time, whatever the order of the rows.
    Of rows at the same place the first is a vertex, the others are in no triangle. Exact. O(n log n). `threads`: 0 =
    all of the machine. Raises InputError for points that are not finite, fewer than three places, or all on one line.
    """
    given = _arrays.numbers(points, "points")
    xy = _arrays.points2(given)
    handle = make(lib.delaunay, address(xy), len(xy), _arrays.count(threads, "threads"))
    try:
        triangles, neighbors = read_mesh(handle)
    finally:
        lib.mesh_free(handle)
    return Mesh(given, triangles, neighbors)


class Fault(NamedTuple):
    """A kind of fault of a mesh."""

    kind: str
    """In words: "hole", "clockwise triangle", ..."""
    occurrences: int
    """How often it was found; counting stops at a million."""
    examples: tuple[str, ...]
    """Up to five places, in words."""


def check(points: ArrayLike, triangles: ArrayLike) -> list[Fault]:
    """What is wrong with triangles (m, 3) as a triangulation of all points (n, 2) or (n, 3).

    Empty if and only if they are counter-clockwise, do not overlap, use every point and cover the convex hull. Exact.
    O(m log m) for a sound mesh. Raises InputError for points that are not finite.
    """
    xy, ids = _arrays.points2(points), _arrays.triangles(triangles)
    faults, error = c_void_p(), new_error()
    status = lib.validate(address(xy), len(xy), address(ids), len(ids), byref(faults), byref(error))
    if status != VERIFICATION:
        lib.faults_free(faults)
        raise_for(status, error)
        return []
    try:
        return [_read_fault(faults, i) for i in range(lib.faults_count(faults))]
    finally:
        lib.faults_free(faults)


def _read_fault(faults: Any, i: int) -> Fault:
    examples: list[str] = []
    while (example := lib.faults_example(faults, i, len(examples))) is not None:
        examples.append(example.decode())
    name = lib.fault_name(lib.faults_kind(faults, i)).decode()
    return Fault(name, lib.faults_occurrences(faults, i), tuple(examples))


def triangle_orders(
    points: ArrayLike, triangles: ArrayLike, *, limit: Optional[int] = None, threads: int = 0
) -> NDArray[np.int32]:
    """The order of each triangle, int32 (m,): how many places of the points are strictly inside its circumcircle.

    With a `limit`, limit + 1 where they are more. `triangles` (m, 3) need not be a mesh, but counter-clockwise: else
    InputError. Exact. O(n log n) for the points, then of the order of the orders.
    """
    xy, ids = _arrays.points2(points), _arrays.triangles(triangles)
    most = len(xy) if limit is None else _arrays.count(limit, "limit")
    orders = np.empty(len(ids), np.int32)
    workers = _arrays.count(threads, "threads")
    sites = make(lib.sites_new, address(xy), len(xy), workers)
    try:
        call(lib.sites_triangle_orders, sites, address(ids), len(ids), most, workers, address(orders), len(orders))
    finally:
        lib.sites_free(sites)
    return orders


class Pits(NamedTuple):
    """The pits of a terrain: pit i has the vertices vertices[starts[i]:starts[i + 1]], ascending."""

    starts: NDArray[np.int32]
    """int32 (pits + 1,)"""
    vertices: NDArray[np.int32]
    """int32"""
    boundary: NDArray[np.bool_]
    """bool (pits,): whether the pit touches the convex hull"""


def find_pits(triangles: ArrayLike, z: ArrayLike) -> Pits:
    """The pits of a terrain with elevations z (n,) and triangles (m, 3): sets of joined vertices of the same elevation
    without a strictly lower neighbour. A lake is one pit; a flat that drains is none. O(m log m). Raises InputError
    unless the triangles are counter-clockwise about every vertex, as those of a mesh are."""
    ids, heights = _arrays.triangles(triangles), _arrays.numbers(z, "z").reshape(-1)
    mesh = make(lib.mesh_from_triangles, address(ids), len(ids), len(heights))
    try:
        pits = make(lib.mesh_pits, mesh, address(heights), len(heights))
    finally:
        lib.mesh_free(mesh)
    try:
        total = lib.pits_count(pits).total
        starts, boundary = np.empty(total + 1, np.int32), np.empty(total, np.bool_)
        vertices = np.empty(lib.pits_vertex_count(pits), np.int32)
        call(
            lib.pits_get, pits, address(starts), len(starts), address(vertices), len(vertices),
            address(boundary), len(boundary),
        )  # fmt: skip
    finally:
        lib.pits_free(pits)
    return Pits(starts, vertices, boundary)
