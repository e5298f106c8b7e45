"""A pool for tasks, here or over a cluster; the garbage collector paused while books are built."""

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
    """The result of a task whose worker died."""


class Pool:
    """A pool of this process alone, which does the tasks in succession; a subclass has a cluster's workers."""

    distant = False  # whether they may be other machines, without the files of this

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | WorkerDied]]:
        """Yield each task with the result of ``function(task, *shared)``, in the order in which they finish."""
        for task in tasks:
            yield task, function(task, *shared)

    def alone(self) -> AbstractContextManager[Self]:
        """Give a pool for a task whose worker died: a fresh pool, unless others use this too."""
        return nullcontext(self)


THIS_PROCESS = Pool()


@contextmanager
def collector_paused() -> Iterator[None]:
    """Pause the garbage collector: it takes a quarter of the time, and finds none among cells that live to the end."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


def collecting_between(items: Iterable[T]) -> Iterator[T]:
    """Yield items, and collect garbage between them: a command runs with the collector off, and books may be large."""
    for n, item in enumerate(items):
        if n:
            gc.collect()
        yield item
