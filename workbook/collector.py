"""Python's search for garbage, held back where it finds none."""

import gc
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

Item = TypeVar("Item")


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


def swept_between(items: Iterable[Item]) -> Iterator[Item]:
    """Yield items, and search between two of them: a command runs with the search off, and one book may be large."""
    for n, item in enumerate(items):
        if n:
            gc.collect()
        yield item
