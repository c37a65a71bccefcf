"""Long runs: in a thread of their own, so that the caller's thread hears Ctrl-C and calls `progress`."""

from __future__ import annotations

import threading
from ctypes import c_void_p
from queue import SimpleQueue
from typing import Any, Callable, Optional

from ._abi import PROGRESS, BuildOptions, lib

Progress = Callable[[str, float], Any]


def run(work: Callable[[], None], options: BuildOptions, progress: Optional[Progress]) -> None:
    """Calls work() in a thread while `progress` is called here. Whatever is raised here, KeyboardInterrupt or what
    `progress` raises, stops the run before it goes on; what work() raises is raised here."""
    events: SimpleQueue[Optional[tuple[str, float]]] = SimpleQueue()
    failures: list[BaseException] = []

    def tell(_data: Any, stage: bytes, fraction: float) -> int:
        events.put((stage.decode("ascii", "replace"), fraction))
        return 0

    def body() -> None:
        try:
            work()
        except BaseException as failure:  # raised again in the caller's thread
            failures.append(failure)
        events.put(None)

    cancel = c_void_p(lib.cancel_new())
    if not cancel:
        raise MemoryError
    callback = PROGRESS(tell)
    if progress is not None:
        options.progress = callback
    options.cancel = cancel
    thread = threading.Thread(target=body, name="thalweg", daemon=True)
    try:
        thread.start()
        while (event := events.get()) is not None:
            if progress is not None:
                progress(*event)
    except BaseException:
        lib.cancel_request(cancel)
        raise
    finally:
        try:
            _join(thread)
        finally:
            lib.cancel_free(cancel)
    if failures:
        raise failures[0]


def _join(thread: threading.Thread) -> None:
    """Waits, whatever happens meanwhile: the run uses the caller's arrays. A Ctrl-C is raised afterwards."""
    interrupt: Optional[KeyboardInterrupt] = None
    while thread.is_alive():
        try:
            thread.join()
        except KeyboardInterrupt as again:
            interrupt = again
    if interrupt is not None:
        raise interrupt
