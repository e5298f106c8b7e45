"""What was made lately, found again by what it was made of, as far as :func:`enable_memo` asks a process for it."""

from collections.abc import Callable
from typing import Any, TypeVar

T = TypeVar("T")

_known: dict[str, list[tuple[Any, Any]]] = {}
_most = 0


def enable_memo(most: int) -> None:
    """Remember from now on so many things of each kind."""
    global _most
    _most = most


def memo_enabled() -> bool:
    """Whether anything is remembered."""
    return _most > 0


def memoized(kind: str, of: Any, make: Callable[[], T]) -> T:
    """Return what was made of an equal thing if it is remembered, else make it."""
    known = _known.setdefault(kind, [])
    place = next((k for k, (other, _) in enumerate(known) if other == of), None)
    pair = (of, make()) if place is None else known.pop(place)
    known.insert(0, pair)
    del known[_most:]
    made: T = pair[1]
    return made
