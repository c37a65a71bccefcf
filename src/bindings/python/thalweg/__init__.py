"""Terrains without false pits, by higher-order Delaunay triangulations.

>>> import thalweg
>>> terrain = thalweg.build([[0, 0, 9], [10, 0, 8], [10, 8, 7], [0, 9, 3], [4, 4, 5], [7, 4, 1]], order=4)
>>> terrain.triangles.shape, len(terrain.pits), terrain.certified
((6, 3), 1, True)

Points are rows of x, y, z, any array of numbers; every finite float64 is legal and nothing is ever moved or rounded.
x and y must have the same unit (metres, not degrees); the unit of z is free. Ids in every result are rows of the
points as given, from 0. Results are exact and the same on every run, whatever the number of threads.

Wrong arguments and unusable points raise `ValueError` (`InputError` where rows are to blame, with `.rows`), a run out
of memory `MemoryError`. All functions release the GIL; objects may be shared among threads.
"""

from ._abi import InputError, library_version
from .edges import UsefulEdges, useful_edges
from .mesh import Fault, Mesh, Pits, check, delaunay, find_pits, triangle_orders
from .predicates import compare_distance, incircle, orient2d
from .terrain import PitCount, Terrain, build, sweep
from .voronoi import OrderKVoronoi

__version__ = library_version()

__all__ = [
    "Fault",
    "InputError",
    "Mesh",
    "OrderKVoronoi",
    "PitCount",
    "Pits",
    "Terrain",
    "UsefulEdges",
    "build",
    "check",
    "compare_distance",
    "delaunay",
    "find_pits",
    "incircle",
    "orient2d",
    "sweep",
    "triangle_orders",
    "useful_edges",
]
