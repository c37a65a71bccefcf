"""Draws a terrain twice, side by side: the Delaunay triangulation and thalweg's, each with its pits.

    python3 compare.py survey.xyz picture.png [order]

Needs numpy and matplotlib.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # draws to a file, without a screen

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import thalweg  # noqa: E402


def draw(axes, terrain, title):
    triangulation = terrain.to_matplotlib()
    axes.tripcolor(triangulation, terrain.points[:, 2], shading="gouraud", cmap="terrain")
    axes.triplot(triangulation, color="black", linewidth=0.2, alpha=0.5)
    x, y, _ = terrain.points.T
    changed = terrain.triangles[terrain.orders > 0]
    if len(changed):
        axes.triplot(x, y, changed, color="tab:red", linewidth=0.4)
    pits = terrain.pits["vertex"]
    axes.plot(x[pits], y[pits], "o", color="magenta", markeredgecolor="black", markersize=4)
    axes.set_title(f"{title}: {len(terrain.pits)} pits")
    axes.set_aspect("equal")
    axes.set_axis_off()


def main():
    points = np.loadtxt(sys.argv[1])
    order = int(sys.argv[3]) if len(sys.argv) > 3 else 8
    before, after = thalweg.build(points, 0, "delaunay"), thalweg.build(points, order)
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 6), layout="constrained")
    draw(left, before, "Delaunay")
    draw(right, after, f"order {order}" + (", proved to be the fewest" if after.certified else ""))
    figure.savefig(sys.argv[2], dpi=120)
    print(f"{sys.argv[2]}: {len(before.pits)} -> {len(after.pits)} pits")


if __name__ == "__main__":
    main()
