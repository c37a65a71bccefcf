"""What Google Benchmark wrote to one of its JSON files: medians by name."""

import json
import statistics

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}


class Measured:
    """Benchmarks of a file. Names are JOB/SET/SITES[/k:K][/threads:T], see run.hpp."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            runs = json.load(file)["benchmarks"]
        self.runs = {}
        for run in runs:
            if run["run_type"] == "iteration" and not run.get("error_occurred"):
                for key in ("real_time", "cpu_time"):
                    run[key] *= MILLISECONDS[run["time_unit"]]
                self.runs.setdefault(run["run_name"], []).append(run)

    def names(self):
        return list(self.runs)

    def value(self, name, key):
        """Median of `key` over the repetitions; None if the benchmark was not run."""
        runs = self.runs.get(name)
        return statistics.median(run[key] for run in runs) if runs else None

    def least(self, name, key):
        """`key` of the repetition that was disturbed the least; None if the benchmark was not run."""
        runs = self.runs.get(name)
        return min(run[key] for run in runs) if runs else None

    @staticmethod
    def time_key(name):
        """CPU time of one thread, real time of more."""
        return "real_time" if "/threads:" in name else "cpu_time"

    def milliseconds(self, name):
        return self.value(name, self.time_key(name))

    def least_milliseconds(self, name):
        return self.least(name, self.time_key(name))

    def milliseconds_without_system(self, name):
        """CPU time of one thread but for what the system did for it; None of more threads, or if not counted."""
        runs = self.runs.get(name)
        if not runs or "/threads:" in name or "system_ms" not in runs[0]:
            return None
        return statistics.median(run["cpu_time"] - run["system_ms"] for run in runs)

    def real_milliseconds(self, name):
        return self.value(name, "real_time")

    def least_real_milliseconds(self, name):
        return self.least(name, "real_time")

    def spread(self):
        """The largest difference between repetitions of one benchmark, as a part of its median."""
        parts = [0.0]
        for name, runs in self.runs.items():
            times = [run[self.time_key(name)] for run in runs]
            parts.append((max(times) - min(times)) / statistics.median(times))
        return max(parts)

    def repetitions(self):
        return max((len(runs) for runs in self.runs.values()), default=0)
