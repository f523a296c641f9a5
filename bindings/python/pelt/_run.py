"""How a call runs: threads, and the progress bar."""

from __future__ import annotations

import contextlib
import os
import sys
from typing import Any, Callable, Iterator, Union

from pelt import _pelt
from pelt._arrays import integer

Progress = Union[bool, None, Callable[[int], None]]

_MAX_THREADS = 1024


def thread_count(threads: Union[int, None]) -> int:
    """Returns the number of threads; all that this process may use if `threads` is None."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return integer("threads", threads, 1, _MAX_THREADS)


@contextlib.contextmanager
def run(what: str, frames: int, threads: Union[int, None], progress: Progress) -> Iterator[_pelt.Run]:
    """Yields how to run a call, and draws its progress bar."""
    count = thread_count(threads)
    if callable(progress):
        yield _pelt.Run(count, progress)
        progress(frames)
        return
    bar = _bar(what, frames, progress)
    if bar is None:
        yield _pelt.Run(count, None)
        return
    with bar:
        yield _pelt.Run(count, lambda done: bar.update(done - bar.n))
        bar.update(frames - bar.n)


def _bar(what: str, frames: int, progress: Union[bool, None]) -> Any:
    """Returns the bar of tqdm, or None if there is none to draw."""
    wanted = progress if progress is not None else sys.stderr is not None and sys.stderr.isatty()
    if not wanted:
        return None
    try:
        from tqdm import tqdm
    except ImportError:
        return _Line(what, frames) if progress else None
    return tqdm(desc=what, total=frames, unit="frame", delay=0 if progress else 2)


class _Line:
    """A line of text instead of a bar."""

    def __init__(self, what: str, frames: int) -> None:
        self.what, self.frames, self.n = what, frames, 0

    def update(self, more: int) -> None:
        self.n += more
        print(f"\r{self.what}: {self.n} of {self.frames} frames", end="", file=sys.stderr, flush=True)

    def __enter__(self) -> "_Line":
        return self

    def __exit__(self, *_: object) -> None:
        print(file=sys.stderr)
