"""tables.py RESULTS SITES TABLE ...: prints the tables of table.sh as Markdown, from the JSON files in RESULTS."""

import math
import os
import statistics
import sys

from measured import Measured
from plot import Panel, write_svg

METHODS = ("hull", "flip", "best")


def number(value, digits=3):
    """So many significant digits, thousands apart, or a dash."""
    if value is None:
        return "-"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:,.{decimals}f}"


def ratio(a, b):
    return a / b if a is not None and b else None


def growth(times):
    """Cells for two times, and by how much the second is larger."""
    return [*map(number, times), number(ratio(times[1], times[0]))]


def growth_header(kind, counts):
    return [f"{kind}, {counts[0]:,}", f"{counts[1]:,}", "growth"]


def print_table(header, rows):
    print("| " + " | ".join(header) + " |")
    print("|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


class Tables:

    def __init__(self, results, sites):
        self.results = results
        self.sites = sites

    def load(self, name):
        return Measured(os.path.join(self.results, name + ".json"))

    def note(self, *all_measured):
        repetitions = max(m.repetitions() for m in all_measured)
        spread = max(m.spread() for m in all_measured)
        print(f"Medians of {repetitions} repetitions in random order, the largest spread {100 * spread:.0f} %. One "
              "thread: CPU time; two: wall time, and speed-up in wall time.\n")

    def a(self):
        m = self.load("a")
        print("### Delaunay triangulation\n")
        sets = [name.removeprefix("delaunay/") for name in m.names()
                if name.startswith("delaunay/") and "/threads:" not in name]
        rows = []
        for label in sorted(sets, key=lambda s: (s.endswith("/all"), s)):
            own, two, pair = f"delaunay/{label}", f"delaunay/{label}/threads:2", f"two_at_once/{label}/threads:2"
            row = [label]
            for value in (m.milliseconds, m.least_milliseconds):
                times = value(own), value(f"cgal/{label}")
                row += [*map(number, times), number(ratio(times[1], times[0]))]
            for value in (m.real_milliseconds, m.least_real_milliseconds):
                one = value(own)
                row += [number(ratio(one, value(two))), number(ratio(one and 2 * one, value(pair)))]
            rows.append(row)
        print_table(["sites", "thalweg ms", "CGAL ms", "times as fast", "the least: thalweg ms", "CGAL ms",
                     "times as fast", "2 threads gain", "two runs at once gain", "the least: 2 threads gain",
                     "two runs at once gain"], rows)
        print("Two runs at once, each on one thread, gain what the machine's two cores have to give.\n")
        self.note(m)

    def b(self):
        m = self.load("b")
        print(f"### {self.sites:,} uniform sites at order 8, Delaunay triangulation and report included\n")
        cgal = m.milliseconds(f"cgal/uniform/{self.sites}")
        rows = []
        for method in METHODS:
            own = f"{method}/uniform/{self.sites}/k:8"
            pits = [m.value(own, key) for key in ("pits_before", "pits")]
            rows.append([method, number(m.milliseconds(own)), number(ratio(m.milliseconds(own), cgal)),
                         number(ratio(m.real_milliseconds(own), m.real_milliseconds(own + "/threads:2"))),
                         "-" if None in pits else "{:,.0f} -> {:,.0f}".format(*pits)])
        rows.append(["CGAL, Delaunay alone", number(cgal), "1", "", ""])
        print_table(["method", "ms", "of CGAL's Delaunay time", "speed-up by 2 threads", "pits"], rows)
        self.note(m)

    def c(self):
        few, many = counts = self.sites, 10 * self.sites
        print(f"### From {few:,} to {many:,} uniform sites; n log n grows {10 * math.log(many) / math.log(few):.1f} "
              "times\n")
        self.first_calls(counts)
        delaunay, hull = self.load("c_delaunay"), self.load("c_hull")
        jobs = [("delaunay", delaunay, "delaunay/uniform/{}"),
                ("delaunay, 2 threads", delaunay, "delaunay/uniform/{}/threads:2"),
                ("hull, order 8", hull, "hull/uniform/{}/k:8"),
                ("hull, order 8, 2 threads", hull, "hull/uniform/{}/k:8/threads:2"),
                ("CGAL's delaunay", delaunay, "cgal/uniform/{}")]
        rows = []
        for title, m, name in jobs:
            row = [title]
            for value in (m.milliseconds, m.least_milliseconds, m.milliseconds_without_system):
                row += growth([value(name.format(n)) for n in counts])
            rows.append(row)
        print_table(["again and again in one process", *growth_header("ms", counts), *growth_header("the least", counts),
                     *growth_header("without the system", counts)], rows)
        print("The system clears memory that is touched for the first time, and a hypervisor may have to find it first. "
              "Where calls follow each other, those with few sites get memory that has just been given back, and those "
              "with many do not.\n")
        self.note(delaunay, hull)

    def first_calls(self, counts):
        """Time and peak of the first call of a process, on one thread."""
        calls = {}
        with open(os.path.join(self.results, "c_process.txt"), encoding="utf-8") as file:
            for line in file:
                count, method, size, milliseconds = line.split()
                calls.setdefault((int(count), method), []).append((float(size), float(milliseconds)))
        rows = []
        for title, method in (("delaunay", "delaunay"), ("hull, order 8", "hull"), ("CGAL's delaunay", "cgal")):
            costs = [list(zip(*calls.get((count, method), []))) or ([None], [None]) for count in counts]
            row = [title]
            for of in (statistics.median, min):
                row += growth([of(milliseconds) for _, milliseconds in costs])
            rows.append(row + [number(max(sizes)) for sizes, _ in costs])
        print_table(["the first call of a process", *growth_header("ms", counts), *growth_header("the least", counts),
                     *growth_header("peak bytes a site", counts)[:2]], rows)
        print(f"Wall time on one thread, medians of {max(map(len, calls.values()), default=0)}. Peaks are of the whole "
              "process, the input included.\n")

    def d(self):
        m = self.load("d")
        counts = [self.sites // 10, self.sites]
        orders = sorted({int(name.split("/k:")[1]) for name in m.names()})
        panels = []
        for n in counts:
            print(f"### Milliseconds over the order, {n:,} uniform sites\n")
            lines = []
            for method in METHODS:
                lines.append((method, [(k, m.milliseconds(f"{method}/uniform/{n}/k:{k}")) for k in orders]))
            print_table(["order", *map(str, orders)],
                        [[method, *(number(time) for _, time in line)] for method, line in lines])
            panels.append(Panel(f"{n:,} sites", lines, self.paper_bound(n, lines, orders)))
        path = os.path.join(self.results, "time_over_order.svg")
        write_svg(path, panels, "order k", "milliseconds")
        print(f"Plot: {path}. Dashed is how the bound of the paper for flip and hull grows, n k^2 + n k log n "
              f"(Theorems 6 and 7), through the slowest at order {orders[len(orders) // 2]}.\n")
        self.note(m)

    @staticmethod
    def paper_bound(n, lines, orders):
        middle = len(orders) // 2
        slowest = max(line[middle][1] for _, line in lines)
        bound = [k * k + k * math.log2(n) for k in orders]
        return "paper", [(k, slowest * b / bound[middle]) for k, b in zip(orders, bound)]

    def e(self):
        m = self.load("e")
        print(f"### Files of {self.sites:,} points; PLY binary, with the Delaunay triangles\n")
        rows = []
        for job in [how + kind for how in ("read_", "write_") for kind in ("xyz", "npy", "tlw", "ply", "obj")]:
            for sites in ("uniform", "lidar"):
                own = f"{job}/{sites}/{self.sites}"
                two = own + "/threads:2"
                if not m.milliseconds(own):
                    continue
                size = m.value(own, "bytes") / 1e6
                times = (m.milliseconds(own), m.real_milliseconds(own), m.milliseconds(two))
                speeds = [t and size / t * 1e3 for t in times]
                rows.append([job.replace("_", " "), sites, number(size), *map(number, speeds)])
        print_table(["", "sites", "MB", "MB/s of CPU time", "MB/s of wall time", "the same, 2 threads"], rows)
        print("Uniform coordinates have all 17 digits, lidar has two decimals. Files are read from the system's cache, "
              "and written to disk.\n")
        self.note(m)

    def f(self):
        m = self.load("f")
        print("### Predicates, million calls a second on one thread\n")
        rows = [[*name.split("/"), number(m.value(name, "items_per_second") / 1e6)] for name in m.names()]
        print_table(["predicate", "tuples", "M/s"], sorted(rows, key=lambda row: (row[0] != "orient2d", row)))
        self.note(m)


def main(arguments):
    tables = Tables(arguments[0], int(arguments[1]))
    for name in arguments[2:]:
        getattr(tables, name)()


if __name__ == "__main__":
    main(sys.argv[1:])
