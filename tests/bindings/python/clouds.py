"""Points that the tests share: at random, and degenerate on purpose."""

import numpy as np


def uniform(n, seed, dimensions=3):
    return np.random.default_rng(seed).random((n, dimensions)) * 1000


def grid(side):
    """Whole numbers: every cell is cocircular, every row collinear."""
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    z = (x * 7 + y * 13) % 11
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(float)


def ring(n):
    """Points on lattice circles about the origin, and the origin."""
    points = [(x, y) for x in range(-25, 26) for y in range(-25, 26) if x * x + y * y in (25, 625, 0)]
    return np.array(points[:n], dtype=float)


def crowded(n, seed):
    """Few places for many rows."""
    return np.random.default_rng(seed).integers(0, 6, (n, 3)).astype(float)


def triangle_set(triangles):
    return {frozenset(map(int, t)) for t in triangles}
