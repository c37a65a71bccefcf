"""delaunay() beside scipy.spatial.Delaunay."""

import clouds
import numpy as np
import pytest
import thalweg
from scipy.spatial import Delaunay

DEGENERATE = [clouds.grid(2)[:, :2], clouds.grid(12)[:, :2], clouds.ring(99), clouds.grid(5)[:, :2] * 1e300]


def check_conventions(mesh):
    """What code written for scipy relies on."""
    triangles, neighbors = mesh.triangles, mesh.neighbors
    assert triangles.dtype == neighbors.dtype == np.int32 and triangles.shape == neighbors.shape
    for i, around in enumerate(neighbors):
        for j, other in enumerate(around):
            edge = set(triangles[i]) - {triangles[i][j]}
            if other == -1:
                assert sum(edge <= set(t) for t in triangles) == 1
            else:
                assert edge <= set(triangles[other]) and i in neighbors[other]


@pytest.mark.parametrize("seed", range(5))
def test_the_triangles_are_those_of_scipy(seed):
    points = clouds.uniform(400, seed, 2)
    ours, theirs = thalweg.delaunay(points), Delaunay(points)
    assert clouds.triangle_set(ours.triangles) == clouds.triangle_set(theirs.simplices)
    assert {frozenset(e) for e in ours.convex_hull.tolist()} == {frozenset(e) for e in theirs.convex_hull.tolist()}
    indptr, indices = ours.vertex_neighbor_vertices
    their_indptr, their_indices = theirs.vertex_neighbor_vertices
    for v in range(len(points)):
        around = their_indices[their_indptr[v] : their_indptr[v + 1]]
        assert indices[indptr[v] : indptr[v + 1]].tolist() == sorted(around)
    # By triangle: the neighbour across each corner is the same triangle.
    places = {frozenset(t): dict(zip(t, n)) for t, n in zip(theirs.simplices.tolist(), theirs.neighbors.tolist())}
    for t, n in zip(ours.triangles.tolist(), ours.neighbors.tolist()):
        for corner, other in zip(t, n):
            their_other = places[frozenset(t)][corner]
            assert (other == -1) == (their_other == -1)
            if other != -1:
                assert set(ours.triangles[other]) == set(theirs.simplices[their_other])


@pytest.mark.parametrize("points", DEGENERATE, ids=lambda p: f"{len(p)}")
def test_degenerate_input_is_triangulated(points):
    mesh = thalweg.delaunay(points)
    assert thalweg.check(points, mesh.triangles) == []
    assert thalweg.triangle_orders(points, mesh.triangles).max() == 0
    check_conventions(mesh)


def test_conventions_in_general_position():
    mesh = thalweg.delaunay(clouds.uniform(60, 9, 2))
    check_conventions(mesh)
    assert mesh.simplices is mesh.triangles
    for a, b, c in mesh.triangles:
        assert thalweg.orient2d(mesh.points[a], mesh.points[b], mesh.points[c]) == 1
    for a, b in mesh.convex_hull:
        assert all(thalweg.orient2d(mesh.points[a], mesh.points[b], p) >= 0 for p in mesh.points)


def test_points_are_not_copied_if_they_fit():
    for width in (2, 3):
        points = clouds.uniform(20, 1, width)
        assert thalweg.delaunay(points).points is points
    integers = np.array([[0, 0], [4, 0], [0, 4]])
    assert thalweg.delaunay(integers).points.dtype == np.float64
    assert thalweg.delaunay(points[::2]).triangles.max() < 10
    assert thalweg.delaunay(np.asfortranarray(points)).triangles.shape == thalweg.delaunay(points).triangles.shape


def test_duplicates_are_in_no_triangle_but_the_first():
    points = clouds.crowded(200, 4)[:, :2]
    mesh = thalweg.delaunay(points)
    _, first = np.unique(points, axis=0, return_index=True)
    assert set(np.unique(mesh.triangles)) == set(first)


def test_predicates():
    assert thalweg.orient2d((0, 0), (1, 0), (0, 5e-324)) == 1
    assert thalweg.incircle((0, 0), (1, 0), (0, 1), (1, 1)) == 0
    assert thalweg.compare_distance((0, 0), (1, 0), (2, 0)) == -1
    with pytest.raises(ValueError, match="shape"):
        thalweg.orient2d((0, 0, 0), (1, 0), (0, 1))
    with pytest.raises(ValueError, match="NaN"):
        thalweg.orient2d((0, 0), (1, np.nan), (0, 1))
