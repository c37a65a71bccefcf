"""Errors are Python's, with the library's words."""

import clouds
import numpy as np
import pytest
import thalweg

GOOD = clouds.uniform(10, 1)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (np.empty((0, 3)), "3 distinct"),
        ([], "3 distinct"),
        ([[1, 2, 3]], "3 distinct"),
        ([[1, 2, 3]] * 5, "3 distinct"),
        ([[0, 0, 0], [1, 1, 1], [2, 2, 2]], "line"),
        ([[0, 0, 0], [1, 0, np.nan], [0, 1, 0]], "row 1"),
        ([[0, 0, 0], [1, 0, 1], [0, -np.inf, 0]], "row 2"),
    ],
)
def test_unusable_points(points, words):
    with pytest.raises(thalweg.InputError, match=words) as caught:
        thalweg.build(points)
    assert isinstance(caught.value, ValueError)


def test_rows_are_named():
    with pytest.raises(thalweg.InputError, match="same x and y") as caught:
        thalweg.build([[0, 0, 0], [1, 0, 1], [0, 1, 2], [1, 0, 5]], duplicates="error")
    assert caught.value.rows == (1, 3)


@pytest.mark.parametrize(
    "points", [[1, 2, 3], [[1, 2]], [[1, 2, 3, 4]], np.zeros((2, 2, 2)), np.float64(3), np.empty((0, 3, 1, 1))]
)
def test_shapes(points):
    with pytest.raises(ValueError, match="shape"):
        thalweg.build(points)


@pytest.mark.parametrize("points", [[["a", "b", "c"]], np.ones((3, 3), complex), np.array([[None] * 3])])
def test_types(points):
    with pytest.raises(TypeError, match="real numbers"):
        thalweg.build(points)


def test_masked_points_are_refused():
    masked = np.ma.masked_array(GOOD, mask=GOOD > 900)
    assert masked.mask.any()
    with pytest.raises(ValueError, match="masked"):
        thalweg.build(masked)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"method": "magic"}, ValueError),
        ({"order": -1}, ValueError),
        ({"order": 2.5}, TypeError),
        ({"duplicates": "all"}, ValueError),
        ({"counter": "abacus"}, ValueError),
        ({"threads": -2}, ValueError),
        ({"time_limit": -1.0}, ValueError),
        ({"time_limit": float("nan")}, ValueError),
    ],
)
def test_options(options, error):
    with pytest.raises(error):
        thalweg.build(GOOD, **options)


def test_large_options_are_legal():
    assert thalweg.build(GOOD, 2**80, threads=2**40).orders.max() <= 7
    assert thalweg.build(GOOD, np.int8(3), "exact", time_limit=float("inf")).orders.max() <= 3


def test_triangles():
    for wrong, error in [([[0, 1]], ValueError), ([[0.0, 1.0, 2.0]], TypeError), ([0, 1, 2], ValueError)]:
        with pytest.raises(error):
            thalweg.check(GOOD, wrong)
    with pytest.raises(thalweg.InputError):
        thalweg.find_pits([[0, 1, 2], [0, 1, 3]], np.zeros(4))
    with pytest.raises(thalweg.InputError, match="elevation 1"):
        thalweg.find_pits([[0, 1, 2]], [0, np.nan, 0])
    with pytest.raises(ValueError, match="names point"):
        thalweg.triangle_orders(GOOD, [[0, 1, -1]])


def test_sweep_ranges():
    for first, last in [(3, 2), (0, 10**7), (-1, 2)]:
        with pytest.raises(ValueError):
            thalweg.sweep(GOOD, first, last)


def test_the_version_is_the_projects():
    import os
    import re
    from pathlib import Path

    text = (Path(__file__).resolve().parents[3] / "CMakeLists.txt").read_text()
    assert re.search(r"project\(thalweg VERSION ([0-9.]+)", text).group(1) == thalweg.__version__
    assert os.environ.get("THALWEG_LIBRARY") is None or Path(os.environ["THALWEG_LIBRARY"]).exists()
