#!/usr/bin/env python3
"""Writes jacksboro_fault.asc, in metres, from Matplotlib's jacksboro_fault_dem.npz. See README.md for the source.

usage: make_jacksboro.py jacksboro_fault_dem.npz > jacksboro_fault.asc      (standard library only)
"""
import array
import ast
import math
import struct
import sys
import zipfile

EARTH_RADIUS = 6371007.2  # metres: the sphere with the area of the WGS84 ellipsoid


def read_array(archive, name):
    """The shape and the numbers of one .npy member, little-endian and row by row."""
    data = archive.read(name + ".npy")
    start = 10 + struct.unpack_from("<H", data, 8)[0]
    header = ast.literal_eval(data[10:start].decode("ascii"))
    assert data[:8] == b"\x93NUMPY\x01\x00" and not header["fortran_order"]
    numbers = array.array({"<i2": "h", "<f8": "d"}[header["descr"]], data[start:])
    if sys.byteorder == "big":
        numbers.byteswap()
    return header["shape"], numbers


def in_metres(radians, radius):
    """Arc length, rounded to 1/1024 m: every cell centre is then an exact double and the grid stays an exact grid."""
    return round(radians * radius * 1024) / 1024


def main(path):
    with zipfile.ZipFile(path) as archive:
        (rows, columns), z = read_array(archive, "elevation")
        (step,) = read_array(archive, "dx")[1]
        (north,) = read_array(archive, "ymax")[1]
        assert read_array(archive, "dy")[1][0] == step
    centre = math.radians(north - rows * step / 2)
    dx = in_metres(math.radians(step), EARTH_RADIUS * math.cos(centre))
    dy = in_metres(math.radians(step), EARTH_RADIUS)
    print(f"ncols {columns}\nnrows {rows}\nxllcorner 0\nyllcorner 0\ndx {dx}\ndy {dy}\nNODATA_value -32768")
    for row in range(rows):
        print(*z[row * columns : (row + 1) * columns])


if __name__ == "__main__":
    main(*sys.argv[1:])
