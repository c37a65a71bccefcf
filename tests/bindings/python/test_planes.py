"""useful_edges() and OrderKVoronoi."""

import clouds
import numpy as np
import pytest
import thalweg
from scipy.spatial import cKDTree


def test_the_nearest_are_those_of_scipy():
    points, places = clouds.uniform(500, 1, 2), clouds.uniform(300, 2, 2)
    diagram = thalweg.OrderKVoronoi(points, 5)
    nearest = diagram.query(places)
    assert nearest.dtype == np.int32 and (nearest == cKDTree(points).query(places, 5)[1]).all()
    cells = diagram.locate(places)
    assert all(set(diagram.cell_sites(c)) == set(n) for c, n in zip(cells, nearest))
    assert (diagram.query(places[0]) == nearest[0]).all() and diagram.locate(places[0]) == cells[0]
    assert diagram.k == 5 and diagram.site_count == 500 and diagram.nbytes > 0 and "order 5" in repr(diagram)


def test_cells_of_grids_cover_the_box():
    diagram = thalweg.OrderKVoronoi(clouds.grid(5), 2)
    area = 0.0
    for cell in range(diagram.cell_count):
        corners = diagram.polygon(cell, (-1, -1, 5, 5))
        x, y = corners.T
        area += 0.5 * (np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert area == pytest.approx(36)
    assert diagram.polygon(0, (100, 100, 101, 101)).shape[1] == 2


def test_a_polygon_of_many_corners():
    turns = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    points = np.concatenate([[[0, 0]], np.stack([np.cos(turns), np.sin(turns)], axis=1)])
    diagram = thalweg.OrderKVoronoi(points, 1)
    assert len(diagram.polygon(int(diagram.locate((0, 0))), (-2, -2, 2, 2))) > 50


def test_one_point_and_lines():
    assert thalweg.OrderKVoronoi([[3, 4]], 1).query([0, 0]).tolist() == [0]
    line = thalweg.OrderKVoronoi([[0, 0], [1, 1], [2, 2], [2, 2]], 2)
    assert line.query([[5, 5], [-1, 0]]).tolist() == [[2, 1], [0, 1]]
    assert line.query(np.empty((0, 2))).shape == (0, 2)


def test_useful_edges_of_order_0_are_the_delaunay_edges():
    points = clouds.uniform(300, 3, 2)
    edges, orders = thalweg.useful_edges(points, 0)
    indptr, indices = thalweg.delaunay(points).vertex_neighbor_vertices
    joined = {(u, int(v)) for u in range(300) for v in indices[indptr[u] : indptr[u + 1]] if u < v}
    assert set(map(tuple, edges.tolist())) == joined and (orders == 0).all()


def test_edges_of_terrains_are_useful():
    points = clouds.uniform(300, 4)
    edges, orders = thalweg.useful_edges(points, 4)
    known = dict(zip(map(tuple, edges.tolist()), orders))
    assert orders.max() == 4 and (edges[:, 0] < edges[:, 1]).all()
    for t in thalweg.build(points, 4).triangles.tolist():
        for u, v in zip(t, t[1:] + t[:1]):
            assert known[min(u, v), max(u, v)] <= 4


def test_bad_arguments():
    points = clouds.uniform(9, 5, 2)
    for wrong, error in [((points, 0), ValueError), ((points, 10), thalweg.InputError), ((points, -1), ValueError),
                         ((points, 1.5), TypeError), (([[0, np.inf]], 1), thalweg.InputError)]:  # fmt: skip
        with pytest.raises(error):
            thalweg.OrderKVoronoi(*wrong)
    diagram = thalweg.OrderKVoronoi(points, 2)
    with pytest.raises(thalweg.InputError, match="place 1"):
        diagram.query([[0, 0], [np.nan, 0]])
    with pytest.raises(ValueError):
        diagram.query([0, 0, 0, 0])
    with pytest.raises(ValueError, match="cells"):
        diagram.cell_sites(10**6)
    with pytest.raises(ValueError):
        diagram.polygon(0, (1, 1, 0, 0))
    with pytest.raises(ValueError):
        diagram.polygon(0, (0, 0, 1))
    with pytest.raises(ValueError):
        thalweg.useful_edges(points, -1)
