"""Work in pieces, here or over a cluster: what is handed in comes back with what became of it, as each is finished."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, nullcontext
from typing import Any, Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")


class Pool(Protocol):
    """Who does the work."""

    @property
    def distant(self) -> bool:
        """Whether they may be other machines, which do not see this one's files."""

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | Died]]:
        """Yield each task with what ``function(task, *shared)`` gives, in the order in which they are finished.

        Tasks are taken from the iterator only as there is room for them.
        """

    def alone(self) -> AbstractContextManager[Pool]:
        """Give a pool for a task of which a worker died: one that is fresh, where that harms nobody."""

    def on_each(self, function: Callable[..., Any], *arguments: Any) -> dict[str, Any]:
        """Return what a function gives on each worker, or the exception that it raises there."""


class Died:
    """What comes of a task whose worker died."""


class Here:
    """The process itself, one piece after the other."""

    distant = False

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | Died]]:
        """Yield each task with what the function gives."""
        for task in tasks:
            yield task, function(task, *shared)

    def alone(self) -> AbstractContextManager[Pool]:
        """Give itself."""
        return nullcontext(self)

    def on_each(self, function: Callable[..., Any], *arguments: Any) -> dict[str, Any]:
        """Return what the function gives here."""
        return {"here": function(*arguments)}


HERE = Here()
