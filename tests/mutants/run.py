#!/usr/bin/env python3
"""Tests the tests: plants mutants (wrong operators, constants off by one, statements left out) in src/kernel, src/order
and src/terrain, all of them in one build, and runs, for each of a sample, the tests that reach it until one fails.

    tests/mutants/run.py FOLDER [--sample N] [--seed S] [--jobs J]

FOLDER holds the planted copy, its build and all results; what it has already is not done again. To see what new tests
change, edit them and run again: only those mutants that survived are tried again. `--show` prints the survivors.

equivalent.txt lists mutants that change nothing that a test could see, each with the argument. They are tried like all
others, but not tried again, and counted apart."""

import argparse
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import plant  # noqa: E402

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LAYERS = ("kernel", "order", "terrain")
SUITES = ("unit", "property", "corpus", "truth", "faults")
MEMORY = 6 << 30
# Fewer cases of each property than usual: they find the same mutants, but for the rarest.
FEWER = dict(RC_PARAMS="seed=20090601 max_success=30", THALWEG_PREDICATE_CASES="200000", THALWEG_EXACT_SETS="60")


def read(path, otherwise):
    return json.loads(path.read_text()) if path.exists() else otherwise


def write(path, value):
    part = path.with_suffix(".part")
    part.write_text(json.dumps(value, indent=0))
    part.replace(path)


def update(path, text):
    """Writes only what differs, so that nothing is compiled again in vain."""
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


# -- planting and building


def sources():
    return sorted(p.relative_to(ROOT) for layer in LAYERS for p in (ROOT / "src" / layer).glob("*.[ch]pp"))


def copy_tree(tree):
    planted = set(sources())
    for top in ("include", "src", "tests", "fuzz"):
        for path in (ROOT / top).rglob("*"):
            name = path.relative_to(ROOT)
            if path.is_file() and name not in planted and "CMakeLists" not in path.name:
                if not (tree / name).exists() or (tree / name).read_bytes() != path.read_bytes():
                    (tree / name).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(path, tree / name)
    for path in [ROOT / "CMakeLists.txt", *ROOT.glob("*/**/CMakeLists.txt")]:
        text = path.read_text()
        text = text.replace("kernel/array.cpp", f"kernel/array.cpp {HERE}/state.cpp", 1) if path.parent.name == "src" else text
        text = text.replace("add_executable(test_${name} ${ARGN}", f"add_executable(test_${{name}} ${{ARGN}} {HERE}/listener.cpp")
        update(tree / path.relative_to(ROOT), text)
    for name in ("README.md", "LICENSE"):
        update(tree / name, (ROOT / name).read_text())


def plant_all(tree, dropped):
    """Rewrites the sources; returns the mutants."""
    mutants, n = [], 0
    for name in sources():
        file = plant.File((ROOT / name).read_text()).find()
        text, listed, n = file.rewritten(n, set(dropped.get(str(name), ())))
        update(tree / name, text)
        mutants += [dict(n=k, file=str(name), line=line, column=column, what=what, site=site)
                    for k, line, column, what, site in listed]
    update(tree / "mutant_count.hpp", f"#define MUTANT_COUNT {n}\n")
    return mutants


def configure(tree):
    flags = (f"-std=c++20 -w -Wno-narrowing -fno-diagnostics-color -include {HERE}/mutant.hpp -I{tree}")
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "-S", tree, "-B", tree / "build", "-G", "Ninja", "-DCMAKE_CXX_COMPILER=g++",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1", f"-DCMAKE_CXX_FLAGS={flags}",
                    "-DTHALWEG_BUILD_CLI=OFF", *launcher], check=True, stdout=subprocess.DEVNULL)


def blamed(output, tree, mutants):
    """The sites on the lines that a failed build complains of: where a template of mutant.hpp is at fault, operators
    alone."""
    lines, operators = set(), set()
    for message in re.split(r"(?m)^FAILED: ", output)[1:]:
        place = re.escape(str(tree)) + r"/(src/(?:kernel|order|terrain)/\w+\.[ch]pp):(\d+)"
        found = re.findall(place + r":\d+: error", message)
        lines |= {(file, int(line)) for file, line in found}
        operators |= {(file, int(line)) for file, line in re.findall(place, message)}
    return [m for m in mutants if (m["file"], m["line"]) in lines
            or (m["file"], m["line"]) in operators and re.match("[-+*] ->", m["what"])], lines | operators


def build(folder, tree, jobs):
    """Builds; leaves out what does not compile, and tries again."""
    dropped = read(folder / "dropped.json", {})
    targets = ["thalweg_thalweg"] + [f"test_{s}" for s in SUITES]
    for _ in range(12):
        mutants = plant_all(tree, dropped)
        done = subprocess.run(["cmake", "--build", tree / "build", f"-j{jobs}", "--target", *targets, "--", "-k", "0"],
                              capture_output=True, text=True)
        if done.returncode == 0:
            write(folder / "mutants.json", mutants)
            return mutants
        (folder / "build.log").write_text(done.stdout + done.stderr)
        wrong, lines = blamed(done.stdout, tree, mutants)
        if not wrong:
            sys.exit(f"the planted copy does not build, and not because of a mutant: {folder}/build.log")
        for m in wrong:
            sites = dropped.setdefault(m["file"], [])
            if m["site"] not in sites:
                sites.append(m["site"])
        print(f"{len(wrong)} mutants on {len(lines)} lines do not compile", flush=True)
        write(folder / "dropped.json", dropped)
    sys.exit("the planted copy does not build")


# -- which test reaches what


def run_tests(tree, suite, tests, mutant, seconds, log=None):
    """Returns None if they pass, else how they end. `seconds`: what they take without a mutant."""
    environment = dict(FEWER, **os.environ, THALWEG_MUTANT=str(mutant), GTEST_FILTER=":".join(tests))
    if log:
        environment["THALWEG_MUTANT_LOG"] = str(log)
    cpu = int(4 * seconds + 4)

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    command = [tree / "build/tests" / f"test_{suite}", "--gtest_brief=1"] + ([] if log else ["--gtest_fail_fast"])
    # A group of its own, and far more time by the clock than the limit of work: only a deadlock needs it.
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               preexec_fn=limit, cwd=tree, start_new_session=True)
    try:
        code = process.wait(timeout=20 * cpu + 60)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return "hangs"
    if code == 0:
        return None
    return "fails" if code > 0 else signal.Signals(-code).name


def listed(executable):
    names, group = [], ""
    for line in subprocess.run([executable, "--gtest_list_tests"], capture_output=True, text=True).stdout.splitlines():
        name = line.split("#")[0].strip()
        if not line.startswith(" "):
            group = name
        else:
            names.append(group + name)
    return names


def record(folder, tree, suites):
    """Runs the tests without a mutant: their times and what they reach. Tests that are known are not run again, unless
    reached_<suite>.json is deleted."""
    tests = {}
    for suite in suites:
        executable = tree / "build/tests" / f"test_{suite}"
        path = folder / f"reached_{suite}.json"
        known = read(path, {})
        names = listed(executable)
        reached = {name: known[name] for name in names if name in known}
        unknown = [name for name in names if name not in known]
        if unknown:
            log = folder / f"log_{suite}.txt"
            log.unlink(missing_ok=True)
            started = time.monotonic()
            run_tests(tree, suite, unknown, "record", 1000, log)
            for line in log.read_text().splitlines():
                name, ms, *numbers, state = line.split()
                if state != "passed":
                    sys.exit(f"test_{suite}: {name} fails without a mutant")
                reached[name] = dict(ms=int(ms), reached=[int(n) for n in numbers if n[0] != "-"],
                                     no_meaning=[-int(n) for n in numbers if n[0] == "-"])
            print(f"test_{suite}: {len(unknown)} tests, {time.monotonic() - started:.0f} s", flush=True)
        write(path, reached)
        for name, t in reached.items():
            tests[suite, name] = t
    return tests


# -- killing


def try_mutant(tree, tests, reaching, number):
    """Runs the tests that reach a mutant, the quickest first. Returns (how it died or None, by which tests)."""
    order = sorted(reaching, key=lambda t: tests[t]["ms"])
    at, portion = 0, 300
    while at < len(order):
        batch, total = [], 0
        while at < len(order) and (not batch or total + tests[order[at]]["ms"] + 2 <= portion):
            total += tests[order[at]]["ms"] + 2
            batch.append(order[at])
            at += 1
        for suite in SUITES:
            names = [name for s, name in batch if s == suite]
            if not names:
                continue
            end = run_tests(tree, suite, names, number, sum(tests[suite, n]["ms"] for n in names) / 1000)
            if end:
                return end, f"{suite}: {names[0] if len(names) == 1 else f'one of {len(names)}'}"
        portion *= 3
    return None, f"{len(order)} tests"


def argued(texts):
    """The mutants of equivalent.txt, three lines each: file, column and what is changed; the line; the argument."""
    found = {}
    lines = [line for line in (HERE / "equivalent.txt").read_text().splitlines() if line and line[0] != "#"]
    for head, text, reason in zip(lines[::3], lines[1::3], lines[2::3], strict=True):
        file, column, what = head.split(" ", 2)
        text, reason = text.strip(), reason.strip()
        if not reason.startswith(("equivalent: ", "time alone: ")):
            sys.exit(f"equivalent.txt: no argument for {head}")
        if text not in (line.strip() for line in texts.get(file, [text])):
            sys.exit(f"equivalent.txt: {file} has no line {text}")
        found[file, int(column), what, text] = reason
    return found


def key(mutant, text):
    return f'{mutant["file"]}|{text}|{mutant["column"]}|{mutant["what"]}'


def lot(mutant, texts, seed):
    """What samples are drawn by. Depends on the mutant alone, so that a sample stays the same while other lines change."""
    text = texts[mutant["file"]][mutant["line"] - 1].strip()
    return hashlib.sha256(f"{seed}|{key(mutant, text)}".encode()).digest()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--sample", type=int, default=200, help="mutants of each layer; 0 for all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--suites", default=",".join(SUITES))
    parser.add_argument("--slowest", type=int, default=10**9, help="leave out tests of more milliseconds than this")
    parser.add_argument("--show", action="store_true", help="only print the survivors there are")
    options = parser.parse_args()
    folder = options.folder.resolve()
    tree = folder / "tree"
    tree.mkdir(parents=True, exist_ok=True)
    suites = options.suites.split(",")

    if not options.show:
        copy_tree(tree)
    
        if not (tree / "build/build.ninja").exists():
            plant_all(tree, read(folder / "dropped.json", {}))
            configure(tree)
        build(folder, tree, options.jobs)
    mutants = read(folder / "mutants.json", [])
    tests = record(folder, tree, suites)
    reaching, no_meaning = {}, set()
    for test, t in tests.items():
        no_meaning.update(t["no_meaning"])
        for n in t["reached"]:
            reaching.setdefault(n, []).append(test)

    texts = {name: (ROOT / name).read_text().splitlines() for name in {m["file"] for m in mutants}}
    results_path = folder / "results.json"

    def named(m):
        return key(m, texts[m["file"]][m["line"] - 1].strip() + f'|{m["line"]}')

    results = read(results_path, {})
    arguments = argued(texts)

    def argument(m):
        return arguments.get((m["file"], m["column"], m["what"], texts[m["file"]][m["line"] - 1].strip()))

    chosen = []
    for layer in LAYERS:
        of_layer = [m for m in mutants if m["file"].startswith(f"src/{layer}/")]
        of_layer = [m for m in of_layer if m["n"] in reaching or m["n"] not in no_meaning]
        of_layer.sort(key=lambda m: lot(m, texts, options.seed))
        chosen.append(of_layer[:options.sample or None])
    # One of each layer in turn, so that a run that is stopped has seen as much of each.
    queue = [m for turn in range(max(map(len, chosen))) for part in chosen for m in part[turn:turn + 1]]

    def attempt(m):
        k = named(m)
        old = results.get(k)
        todo = [t for t in reaching.get(m["n"], []) if tests[t]["ms"] <= options.slowest 
                and (not old or f"{t[0]}/{t[1]}" not in old["passed"])]
        if not options.show and not (old and (old["end"] or not todo or argument(m))):
            end, by = try_mutant(tree, tests, todo, m["n"]) if todo else (None, "reached by no test" if m["n"] not in reaching else "only slow ones")
            passed = (old["passed"] if old else []) + ([] if end else [f"{t[0]}/{t[1]}" for t in todo])
            results[k] = dict(end=end, by=by, passed=passed)
            print(f'{m["file"]}:{m["line"]}:{m["column"]} {m["what"]}: {end or "SURVIVES"} ({by})', flush=True)
        return m, results.get(k)

    finished = []
    with ThreadPoolExecutor(options.jobs) as pool:
        for i, item in enumerate(pool.map(attempt, queue)):
            finished.append(item)
            if i % 4 == 3 and not options.show:
                write(results_path, dict(results))
    if not options.show:
        write(results_path, dict(results))
    report([(m, r, argument(m)) for m, r in finished if r], texts)


def report(finished, texts):
    for layer in LAYERS:
        of_layer = [(r["end"] is not None, argument) for m, r, argument in finished if m["file"].startswith(f"src/{layer}/")]
        killed = sum(dies for dies, _ in of_layer)
        alike = sum(not dies and argument is not None for dies, argument in of_layer)
        seen = max(len(of_layer) - alike, 1)
        print(f"{layer}: {killed} of {len(of_layer)} mutants die, {100 * killed / max(len(of_layer), 1):.1f} %; {alike} of the "
              f"rest change nothing that can be seen; {100 * killed / seen:.1f} % of the others")
    for m, r, argument in sorted(finished, key=lambda f: (f[0]["file"], f[0]["line"], f[0]["column"])):
        place = f'{m["file"]}:{m["line"]}:{m["column"]} {m["what"]}'
        if r["end"] is None:
            print(f'{place} [{len(r["passed"])} tests]\n    {texts[m["file"]][m["line"] - 1].strip()}')
            if argument:
                print(f"    {argument}")
        elif argument:
            print(f"{place} dies ({r['by']}), though equivalent.txt says that it cannot")


if __name__ == "__main__":
    main()
