"""A cache of the latest values by what they were made of; it is off until a process calls :func:`enable_memo`."""

from collections.abc import Callable
from typing import Any, TypeVar

T = TypeVar("T")

_known: dict[str, list[tuple[Any, Any]]] = {}
_most = 0


def enable_memo(most: int) -> None:
    """Keep from now on so many values of each kind."""
    global _most
    _most = most


def memoized(kind: str, of: Any, make: Callable[[], T]) -> T:
    """Return the value that was made of an equal key if it is kept, else make it."""
    known = _known.setdefault(kind, [])
    place = next((k for k, (other, _) in enumerate(known) if other == of), None)
    pair = (of, make()) if place is None else known.pop(place)
    known.insert(0, pair)
    del known[_most:]
    made: T = pair[1]
    return made
