"""What differs between two designs, in terms of the machine."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from workbook.differences.design import Design, Figure, Key
from workbook.judging.report import FAIL, OK

CLOSE = 1e-9
"""relative difference of two numbers that are the same: rounding in a file changes the last digits"""
EMPTY = (None, "")


class Change(NamedTuple):
    """An entry, a result or a check that differs; ``None`` stands for what one side does not have."""

    place: str
    label: str
    unit: str
    old: Any
    new: Any
    worse: bool = False
    says: str = ""

    @property
    def difference(self) -> float | None:
        """New less old, of two numbers."""
        return self.new - self.old if is_number(self.old) and is_number(self.new) else None

    @property
    def per_cent(self) -> float | None:
        """The difference over the old value, in per cent; None where that is 0."""
        return None if self.difference is None or not self.old else 100.0 * self.difference / abs(self.old)


@dataclass(frozen=True)
class Differences:
    """All that differs between an old and a new design."""

    entries: list[Change]
    results: list[Change]
    checks: list[Change]
    edited: dict[str, list[str]]
    own: dict[str, list[str]]

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not (self.entries or self.results or self.checks or any(self.edited.values()) or any(self.own.values()))


def compare(old: Design, new: Design) -> Differences:
    """Return what differs between two designs of one template."""
    return Differences(
        changed(old.entries(), new.entries()), changed(old.results(), new.results()),
        changed(old.checks(), new.checks()), one_sided(old.edited, new.edited), one_sided(old.own, new.own),
    )  # fmt: skip


def one_sided(old: list[str], new: list[str]) -> dict[str, list[str]]:
    """Return the lines that only the old and only the new side has."""
    return {"old": [line for line in old if line not in new], "new": [line for line in new if line not in old]}


def changed(before: Mapping[Key, Figure], after: Mapping[Key, Figure]) -> list[Change]:
    """Return the figures that differ, in the order of the new book; what only the old one has comes last."""
    found = []
    for key in [*after, *(key for key in before if key not in after)]:
        was, now = before.get(key), after.get(key)
        shown = now or before[key]
        old, new = was and was.value, now and now.value
        if not same(old, new):
            says = now.says if now else ""
            found.append(Change(shown.place, shown.label, shown.unit, old, new, worse(shown.label, old, new), says))
    return found


def worse(label: str, old: Any, new: Any) -> bool:
    """Whether a check fails that passed, or a reserve to a limit became smaller."""
    if old == OK:
        return bool(new == FAIL)
    return label.startswith("Reserve") and is_number(old) and is_number(new) and new < old


def same(one: Any, other: Any) -> bool:
    """Whether two values are the same; an empty text is an empty cell."""
    if one in EMPTY or other in EMPTY:
        return one in EMPTY and other in EMPTY
    if is_number(one) and is_number(other):
        return math.isclose(one, other, rel_tol=CLOSE, abs_tol=1e-12)
    return bool(one == other)


def is_number(value: Any) -> bool:
    """Whether a value is a number, and not a truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)
