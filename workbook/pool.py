"""Work in pieces, here or over a cluster, each handed back as it is finished; Python's search for garbage held back."""

import gc
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Any, Self, TypeVar

T = TypeVar("T")
R = TypeVar("R")


def cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class WorkerDied:
    """What comes of a task whose worker died."""


class Pool:
    """Who does the work: this process, one piece after the other; over a cluster its workers."""

    distant = False  # whether they may be other machines, which do not see this one's files

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | WorkerDied]]:
        """Yield each task with what ``function(task, *shared)`` gives, as they are finished, taken as there is room."""
        for task in tasks:
            yield task, function(task, *shared)

    def alone(self) -> AbstractContextManager[Self]:
        """Give a pool for a task of which a worker died: one that is fresh, where that harms nobody."""
        return nullcontext(self)


THIS_PROCESS = Pool()


@contextmanager
def collector_paused() -> Iterator[None]:
    """Hold Python's search for garbage back: among cells that live until the end it finds none, yet takes a quarter."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


def collecting_between(items: Iterable[T]) -> Iterator[T]:
    """Yield items, and search between two of them: a command runs with the search off, and one book may be large."""
    for n, item in enumerate(items):
        if n:
            gc.collect()
        yield item
