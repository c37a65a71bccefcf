"""The C ABI (include/thalweg/thalweg.h) as ctypes sees it: structs, signatures, statuses as exceptions."""

from __future__ import annotations

import ctypes
import os
import platform
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from pathlib import Path
from typing import Any, Sequence

NONE = 0xFFFFFFFF

OK, INTERNAL, USAGE, BAD_INPUT, VERIFICATION, OUT_OF_MEMORY, CANCELLED = 0, 1, 2, 3, 4, 5, 130

PROGRESS = ctypes.CFUNCTYPE(c_int, c_void_p, c_char_p, c_double)


class Error(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("status", c_int32),
        ("code", c_int32),
        ("row_count", c_uint32),
        ("rows", c_uint32 * 16),
        ("message", c_char * 412),
    ]


class PitCounts(ctypes.Structure):
    _fields_ = [("total", c_uint32), ("interior", c_uint32), ("boundary", c_uint32)]


class BuildOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("order", c_uint32),
        ("method", c_int32),
        ("duplicates", c_int32),
        ("counter", c_int32),
        ("threads", c_uint32),
        ("keep_trail", c_uint32),
        ("time_limit", c_double),
        ("progress", PROGRESS),
        ("progress_data", c_void_p),
        ("cancel", c_void_p),
    ]


class Summary(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("vertex_count", c_uint32),
        ("site_count", c_uint32),
        ("triangle_count", c_uint32),
        ("max_order", c_uint32),
        ("delaunay_pits", PitCounts),
        ("pits", PitCounts),
        ("lower_bound", c_uint32),
        ("certified", c_uint32),
        ("order_searched", c_uint32),
        ("remaining_count", c_uint32),
        ("removed_count", c_uint32),
        ("merged_count", c_uint32),
        ("mean_count", c_uint32),
        ("edges_changed", c_uint32),
        ("non_delaunay_edges", c_uint32),
        ("reserved", c_uint32),
        ("trail_count", c_uint64),
        ("flips", c_uint64),
        ("insertions", c_uint64),
        ("circle_counts", c_uint64),
        ("min_angle_before_deg", c_double),
        ("min_angle_after_deg", c_double),
        ("seconds_delaunay", c_double),
        ("seconds_minimize", c_double),
    ]


class InputError(ValueError):
    """Input that cannot be used. `rows` are the first of the points (or triangles) to blame, from 0."""

    def __init__(self, message: str, rows: Sequence[int] = ()) -> None:
        super().__init__(message)
        self.rows = tuple(rows)


def _load() -> ctypes.CDLL:
    """The library beside this file, or the one that the environment variable THALWEG_LIBRARY names."""
    name = {"Windows": "thalweg_c.dll", "Darwin": "libthalweg_c.dylib"}.get(platform.system(), "libthalweg_c.so")
    named = os.environ.get("THALWEG_LIBRARY")
    path = Path(named) if named else Path(__file__).resolve().parent / name
    if not path.is_file():
        raise ImportError(f"{path} is missing: install the package (pip install), or set THALWEG_LIBRARY")
    return ctypes.CDLL(str(path))  # CDLL releases the GIL during calls


_E = POINTER(Error)
_OUT = POINTER(c_void_p)

# name: (result, arguments); arrays are addresses.
_SIGNATURES: dict[str, tuple[Any, list[Any]]] = {
    "version": (c_char_p, []),
    "status_name": (c_char_p, [c_int32]),
    "orient2d": (c_int32, [c_void_p] * 3 + [POINTER(c_int), _E]),
    "incircle": (c_int32, [c_void_p] * 4 + [POINTER(c_int), _E]),
    "compare_distance": (c_int32, [c_void_p] * 3 + [POINTER(c_int), _E]),
    "cancel_new": (c_void_p, []),
    "cancel_request": (None, [c_void_p]),
    "cancel_free": (None, [c_void_p]),
    "delaunay": (c_int32, [c_void_p, c_size_t, c_uint32, _OUT, _E]),
    "mesh_from_triangles": (c_int32, [c_void_p, c_size_t, c_size_t, _OUT, _E]),
    "mesh_triangle_count": (c_size_t, [c_void_p]),
    "mesh_triangles": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "mesh_neighbors": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "mesh_free": (None, [c_void_p]),
    "mesh_pits": (c_int32, [c_void_p, c_void_p, c_size_t, _OUT, _E]),
    "pits_count": (PitCounts, [c_void_p]),
    "pits_vertex_count": (c_size_t, [c_void_p]),
    "pits_get": (c_int32, [c_void_p] + [c_void_p, c_size_t] * 3 + [_E]),
    "pits_free": (None, [c_void_p]),
    "build_options_init": (c_int32, [POINTER(BuildOptions), c_size_t]),
    "build": (c_int32, [c_void_p, c_size_t, POINTER(BuildOptions), _OUT, _E]),
    "terrain_summary": (c_int32, [c_void_p, POINTER(Summary), _E]),
    "terrain_mesh": (c_void_p, [c_void_p]),
    "terrain_orders": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_remaining": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_removed": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_merged": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_means": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_trail": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "terrain_free": (None, [c_void_p]),
    "sweep": (c_int32, [c_void_p, c_size_t, c_uint32, c_uint32, POINTER(BuildOptions), c_void_p, c_size_t, _E]),
    "validate": (c_int32, [c_void_p, c_size_t, c_void_p, c_size_t, _OUT, _E]),
    "faults_count": (c_size_t, [c_void_p]),
    "faults_kind": (c_int32, [c_void_p, c_size_t]),
    "faults_occurrences": (c_uint64, [c_void_p, c_size_t]),
    "faults_example": (c_char_p, [c_void_p, c_size_t, c_size_t]),
    "fault_name": (c_char_p, [c_int32]),
    "faults_free": (None, [c_void_p]),
    "sites_new": (c_int32, [c_void_p, c_size_t, c_uint32, _OUT, _E]),
    "sites_triangle_orders": (
        c_int32, [c_void_p, c_void_p, c_size_t, c_uint32, c_uint32, c_void_p, c_size_t, _E],
    ),
    "sites_useful_pairs": (c_int32, [c_void_p, c_uint32, c_uint32, _OUT, _E]),
    "pairs_count": (c_size_t, [c_void_p]),
    "pairs_get": (c_int32, [c_void_p, c_void_p, c_size_t, _E]),
    "pairs_free": (None, [c_void_p]),
    "sites_free": (None, [c_void_p]),
    "voronoi_new": (c_int32, [c_void_p, c_size_t, c_uint32, c_uint32, _OUT, _E]),
    "voronoi_site_count": (c_size_t, [c_void_p]),
    "voronoi_cell_count": (c_size_t, [c_void_p]),
    "voronoi_memory_bytes": (c_size_t, [c_void_p]),
    "voronoi_nearest": (c_int32, [c_void_p, c_void_p, c_size_t, c_uint32, c_void_p, c_size_t, _E]),
    "voronoi_locate": (c_int32, [c_void_p, c_void_p, c_size_t, c_uint32, c_void_p, c_size_t, _E]),
    "voronoi_cell_sites": (c_int32, [c_void_p, c_uint32, c_void_p, c_size_t, _E]),
    "voronoi_polygon": (
        c_int32, [c_void_p, c_uint32, c_void_p, c_void_p, c_size_t, POINTER(c_size_t), _E],
    ),
    "voronoi_free": (None, [c_void_p]),
}  # fmt: skip


class _Library:
    """The functions of the header without their prefix: `lib.build`."""

    def __init__(self) -> None:
        cdll = _load()
        for name, (result, arguments) in _SIGNATURES.items():
            function = getattr(cdll, "thalweg_" + name)
            function.restype, function.argtypes = result, arguments
            setattr(self, name, function)

    def __getattr__(self, name: str) -> Any:  # only for what is not set above; tells type checkers of the rest
        raise AttributeError(name)


lib = _Library()


def new_error() -> Error:
    return Error(struct_size=ctypes.sizeof(Error))


def raise_for(status: int, error: Error) -> None:
    """Nothing for OK, else the exception that the status means to a Python programmer."""
    if status == OK:
        return
    message = error.message.decode("ascii", "replace") or lib.status_name(status).decode()
    rows = list(error.rows)[: min(error.row_count, 16)]
    if status == OUT_OF_MEMORY:
        raise MemoryError(message)
    if status in (BAD_INPUT, VERIFICATION):
        raise InputError(message, rows)
    if status == USAGE:
        raise ValueError(message)
    if status == CANCELLED:
        raise KeyboardInterrupt(message)
    raise RuntimeError(f"thalweg: {message}: a bug of the library")


def call(function: Any, *arguments: Any) -> None:
    """Calls a function whose last argument is an error, and raises what it says."""
    error = new_error()
    raise_for(function(*arguments, byref(error)), error)


def make(function: Any, *arguments: Any) -> c_void_p:
    """The same for a function whose last but one argument is the place for a new handle, which is returned."""
    handle = c_void_p()
    call(function, *arguments, byref(handle))
    return handle


def library_version() -> str:
    return str(lib.version().decode())
