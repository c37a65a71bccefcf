"""build(), sweep() and what can be asked of triangles."""

import clouds
import numpy as np
import pytest
import thalweg

METHODS = ("delaunay", "flip", "hull", "best", "exact")


def check_terrain(terrain, order):
    points, triangles = terrain.points, terrain.triangles
    assert terrain.orders.max() <= order
    assert (terrain.orders == thalweg.triangle_orders(points, triangles)).all()
    pits = thalweg.find_pits(triangles, points[:, 2])
    assert len(pits.boundary) == terrain.pit_count.total == len(terrain.pits)
    assert pits.boundary.sum() == terrain.pit_count.boundary == terrain.pits["boundary"].sum()
    assert sorted(np.diff(pits.starts)) == sorted(terrain.pits["vertices"])
    assert set(terrain.pits["vertex"]) <= set(pits.vertices)
    assert terrain.certified == (terrain.lower_bound == len(terrain.pits))
    assert len(terrain.pits) <= terrain.delaunay_pit_count.total


@pytest.mark.parametrize("method", METHODS)
def test_every_method(method):
    points = clouds.uniform(400, 5)
    order = 0 if method == "delaunay" else 4
    terrain = thalweg.build(points, order, method)
    check_terrain(terrain, order)
    assert thalweg.check(points, terrain.triangles) == []
    assert terrain.points is points
    assert "Terrain" in repr(terrain) and "400 points" in repr(terrain)


@pytest.mark.parametrize("points", [clouds.grid(12), clouds.crowded(300, 6)], ids=["grid", "crowded"])
@pytest.mark.parametrize("method", METHODS)
def test_degenerate_terrains(points, method):
    terrain = thalweg.build(points, 3, method, duplicates="first")
    check_terrain(terrain, 3)


def test_the_methods_are_ordered():
    points = clouds.uniform(1500, 7)
    pits = {method: thalweg.build(points, 8, method).pit_count.total for method in METHODS}
    assert pits["exact"] <= pits["best"] <= min(pits["hull"], pits["flip"]) < pits["delaunay"]
    row = thalweg.sweep(points, 8, 8)[0]
    assert (row["flip"], row["hull"], row["best"]) == (pits["flip"], pits["hull"], pits["best"])
    assert row["order"] == 8 and row["certified"] == (row["best"] == row["lower_bound"])


def test_threads_counter_and_order_of_rows_change_nothing():
    points = clouds.uniform(500, 8)
    plain = thalweg.build(points, 5)
    other = thalweg.build(points, 5, threads=1, counter="voronoi")
    assert (plain.triangles == other.triangles).all()
    shuffled = np.random.default_rng(1).permutation(len(points))
    again = thalweg.build(points[shuffled], 5)
    assert clouds.triangle_set(shuffled[again.triangles]) == clouds.triangle_set(plain.triangles)


@pytest.mark.parametrize("policy", ["lowest", "highest", "mean", "first", "last"])
def test_duplicates(policy):
    points = clouds.crowded(120, 9)
    before = points.copy()
    terrain = thalweg.build(points, 2, duplicates=policy)
    assert (points == before).all()
    gone, kept = terrain.merged.T
    assert (points[gone, :2] == points[kept, :2]).all()
    assert len(gone) + terrain.statistics["site_count"] == len(points)
    assert set(np.unique(terrain.triangles)) == set(range(len(points))) - set(gone)
    chosen = terrain.points[kept, 2]
    if policy == "mean":
        for row, z in zip(kept, chosen):
            same = (points[:, :2] == points[row, :2]).all(axis=1)
            assert z == pytest.approx(points[same, 2].mean())
    else:
        assert (terrain.points == points).all()
        holds = {
            "lowest": chosen <= points[gone, 2],
            "highest": chosen >= points[gone, 2],
            "first": kept < gone,
            "last": kept > gone,
        }
        assert holds[policy].all()


def test_the_trail_leads_to_the_result():
    points = clouds.uniform(300, 10)
    assert thalweg.build(points).trail is None
    terrain = thalweg.build(points, 6, "flip", keep_trail=True)
    mesh = clouds.triangle_set(thalweg.delaunay(points).triangles)
    edges = {frozenset(e) for t in mesh for e in zip(sorted(t), sorted(t)[1:] + sorted(t)[:1])}
    for step in terrain.trail:
        assert step["kind"] == "flip" and step["order"] <= 6
        edges.remove(frozenset((step["old_u"], step["old_v"])))
        edges.add(frozenset((step["u"], step["v"])))
    assert edges == {frozenset(e) for t in terrain.triangles.tolist() for e in zip(t, t[1:] + t[:1])}
    assert (terrain.trail["pit"] >= 0).sum() == len(terrain.removed)


def test_reasons_are_words():
    terrain = thalweg.build(clouds.uniform(300, 11), 1, "delaunay")
    assert set(terrain.pits["reason"]) <= {"unremovable", "conflict", "kept"}
    assert terrain.pits["order_needed"].min() >= -1


def test_to_matplotlib():
    pytest.importorskip("matplotlib")
    terrain = thalweg.build(clouds.uniform(50, 12))
    triangulation = terrain.to_matplotlib()
    assert (triangulation.triangles == terrain.triangles).all() and (triangulation.x == terrain.points[:, 0]).all()


def test_check_names_faults():
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert thalweg.check(square, [[0, 1, 2], [0, 2, 3]]) == []
    assert [fault.kind for fault in thalweg.check(square, [[0, 1, 2], [0, 3, 2]])][0] == "clockwise triangle"
    assert thalweg.check(square, [[0, 1, 2], [0, 2, -1]])[0].kind == "index out of range"
    assert thalweg.check(square, np.array([[0, 1, 2], [0, 2, 2**40]]))[0].kind == "index out of range"
    assert thalweg.check(square, [])[0].occurrences > 0


def test_triangle_orders_of_loose_triangles():
    points = [[0, 0], [4, 0], [0, 4], [1, 1], [1, 1], [9, 9]]
    assert thalweg.triangle_orders(points, [[0, 1, 2], [0, 1, 3]]).tolist() == [1, 0]
    assert thalweg.triangle_orders(points, [[0, 1, 5]]).tolist() == [2]
    assert thalweg.triangle_orders(points, [[0, 1, 2]], limit=0).tolist() == [1]
    with pytest.raises(thalweg.InputError) as caught:
        thalweg.triangle_orders(points, [[0, 1, 2], [0, 2, 1]])
    assert caught.value.rows == (1,)
