"""Work in pieces, here or over a cluster: what is handed in comes back with what became of it, as each is finished."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")


class Pool(Protocol):
    """Who does the work."""

    @property
    def width(self) -> int:
        """How many pieces are worked on at once."""

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | Died]]:
        """Yield each task with what ``function(task, *shared)`` gives, in the order in which they are finished.

        Tasks are taken from the iterator only as there is room for them.
        """


class Died:
    """What comes of a task whose worker died."""


class Here:
    """This process, one piece after the other."""

    width = 1

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | Died]]:
        """Yield each task with what the function gives."""
        for task in tasks:
            yield task, function(task, *shared)
