"""Progress, stopping, and several threads at once."""

import os
import signal
import threading
import time

import clouds
import numpy as np
import pytest
import thalweg


def test_progress_is_called_here_and_in_order():
    calls = []
    thalweg.build(
        clouds.uniform(300, 1), progress=lambda stage, fraction: calls.append((stage, fraction, threading.get_ident()))
    )
    assert len(calls) > 3 and {ident for _, _, ident in calls} == {threading.get_ident()}
    assert calls[0][0] == "triangulating" and all(0 <= fraction <= 1 for _, fraction, _ in calls)


def test_what_progress_raises_stops_the_run_at_every_call():
    class Enough(Exception):
        pass

    for stop_at in range(1, 1000):
        calls = 0

        def progress(stage, fraction):
            nonlocal calls
            calls += 1
            if calls == stop_at:
                raise Enough

        try:
            thalweg.build(clouds.uniform(200, 2), 4, "exact", progress=progress)
        except Enough:
            continue
        assert calls == stop_at - 1 and stop_at > 4
        break
    with pytest.raises(Enough):
        calls, stop_at = 0, 1
        thalweg.sweep(clouds.uniform(200, 2), 0, 3, progress=progress)


@pytest.mark.skipif(os.name != "posix", reason="sends a signal to itself")
def test_ctrl_c_stops_a_run():
    def press(stage, fraction):
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        thalweg.build(clouds.uniform(200, 3), progress=press)
    assert thalweg.build(clouds.uniform(200, 3)).pit_count.total > 0


def test_the_gil_is_released():
    """Another thread goes on while a single call works; it could not if the call held the lock."""
    points = clouds.uniform(10_000, 4, 2)
    inside, ticks = threading.Event(), []

    def tick():
        while not inside.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    other = threading.Thread(target=tick)
    other.start()
    begin = time.perf_counter()
    thalweg.useful_edges(points, 8, threads=1)
    end = time.perf_counter()
    inside.set()
    other.join()
    middle = [t for t in ticks if begin + 0.1 * (end - begin) < t < end - 0.1 * (end - begin)]
    assert len(middle) >= 3, f"{len(middle)} ticks in {end - begin:.3f} s"


def test_threads_share_objects_and_agree():
    points = clouds.uniform(400, 5)
    diagram = thalweg.OrderKVoronoi(points, 3)
    expected = thalweg.build(points).triangles, diagram.query(points[:, :2])
    answers = []

    def work():
        answers.append((thalweg.build(points).triangles, diagram.query(points[:, :2])))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 4
    for answer in answers:
        assert all((a == b).all() for a, b in zip(answer, expected))


def test_handles_are_freed():
    resource = pytest.importorskip("resource")
    points = clouds.uniform(500, 6)

    def use():
        for _ in range(20):
            thalweg.build(points, 2)
            thalweg.OrderKVoronoi(points, 4)
            thalweg.useful_edges(points, 2)
            with pytest.raises(thalweg.InputError):
                thalweg.build(np.zeros((5, 3)))

    use()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    use()
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 6_000  # kilobytes; diagrams alone would be 12,000
