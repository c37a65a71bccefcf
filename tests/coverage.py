#!/usr/bin/env python3
"""The lines of a folder that no test reaches, from a build with --coverage whose tests have run.

    tests/coverage.py BUILD FOLDER ...     for example: tests/coverage.py build-coverage src/kernel

A line counts as reached if any copy of it is: of a header in any file, of a template for any type."""

import json
import subprocess
import sys
from pathlib import Path


def measured(build):
    """(file, line) -> how often it ran, summed over all objects of the build."""
    counts = {}
    for data in sorted(build.rglob("*.gcda")):
        done = subprocess.run(["gcov", "--json-format", "--stdout", str(data)], check=True, capture_output=True, cwd=data.parent)
        for text in done.stdout.splitlines():
            unit = json.loads(text)
            for file in unit["files"]:
                path = (Path(unit["current_working_directory"]) / file["file"]).resolve()
                for line in file["lines"]:
                    place = path, line["line_number"]
                    counts[place] = counts.get(place, 0) + line["count"]
    return counts


def main():
    build, folders = Path(sys.argv[1]).resolve(), [Path(f).resolve() for f in sys.argv[2:]]
    counts = measured(build)
    for folder in folders:
        lines = {place: n for place, n in counts.items() if folder in place[0].parents}
        for path in sorted({p for p, _ in lines}):
            missed = sorted(line for (p, line), n in lines.items() if p == path and n == 0)
            total = sum(p == path for p, _ in lines)
            print(f"{path.name}: {total - len(missed)} of {total}" + (f", not {missed}" if missed else ""))
        reached = sum(n > 0 for n in lines.values())
        print(f"{folder.name}: {reached} of {len(lines)} lines, {100 * reached / max(1, len(lines)):.2f} %")


if __name__ == "__main__":
    main()
