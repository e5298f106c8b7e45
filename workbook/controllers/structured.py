"""A reader of what is assigned in Structured Text."""

import re
from collections.abc import Iterable, Sequence
from itertools import islice

import numpy as np

from engine.laws.base import Array
from workbook.controllers.number import NUMBER
from workbook.controllers.table import MOST_POINTS, Table
from workbook.errors import TargetError

COMMENT = re.compile(r"//[^\n]*|\(\*.*?(?:\*\)|\Z)", re.DOTALL)
ASSIGNED = re.compile(r"\b([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})")
INDEXED = re.compile(r"\[([0-9]{1,9})\]\s{0,9}\.\s{0,9}([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})")
PLAIN = re.compile(NUMBER)


def stripped(text: str) -> str:
    """Return a text without its comments."""
    return COMMENT.sub(" ", text)


def columns(found: Iterable[tuple[int, str, str]], names: Sequence[str]) -> list[Array]:
    """Return the columns of fields that were assigned, by element, field and text; raise TargetError, by element."""
    elements: dict[int, dict[str, float]] = {}
    for index, name, text in islice(((i, n, t) for i, n, t in found if n in names), MOST_POINTS * len(names) + 1):
        row = elements.setdefault(index, {})
        if name in row:
            raise TargetError(f"element {index}: {name} is assigned twice; expected once")
        if not PLAIN.fullmatch(text):
            raise TargetError(f"element {index}: {name} is {text!r}; expected a number")
        row[name] = float(text)
    if not elements:
        raise TargetError(f"no {names[0]} is assigned; expected {', '.join(names)} of each point")
    for expected, index in enumerate(elements, min(elements)):
        lacks = [name for name in names if name not in elements[index]]
        if lacks or index != expected:
            said = f"lacks {lacks[0]}" if lacks else f"follows element {expected - 1}"
            raise TargetError(f"element {index} {said}; expected every element in order, with {', '.join(names)}")
    return [np.array([row[name] for row in elements.values()]) for name in names]


def indexed(text: str, names: Sequence[str]) -> list[Array]:
    """Return the columns that ``NAME[1].field := value;`` assigns."""
    return columns(((int(i), name, value) for i, name, value in INDEXED.findall(stripped(text))), names)


def grouped(text: str, names: Sequence[str]) -> list[Array]:
    """Return the columns that ``(field := value, …)`` initialises, a group an element."""
    found, index = [], -1
    for name, value in ASSIGNED.findall(stripped(text)):
        index += name == names[0]
        found.append((index, name, value))
    return columns(found, names)


def points(text: str, columns: Sequence[Array], count: str = "") -> Table:
    """Return the table of the columns that were found in a text, as long as ``count`` says where that is assigned."""
    x, y, *rates = columns
    v, a = rates or (None, None)
    table = Table(x, y, v, a)
    if count:
        counted(text, count, len(table.x))
    return table


def scalar(text: str, name: str) -> float | None:
    """Return the number that is assigned to a name once; None where none is. Raises TargetError for two that differ."""
    found = {value for known, value in ASSIGNED.findall(stripped(text)) if known == name}
    if len(found) > 1:
        raise TargetError(f"{name} is {' and '.join(sorted(found)[:2])}; expected one table in a file")
    value = found.pop() if found else None
    return float(value) if value and PLAIN.fullmatch(value) else None


def counted(text: str, name: str, points: int) -> None:
    """Raise TargetError where a count is told that is not that of the points."""
    told = scalar(text, name)
    if told is not None and told != points:
        raise TargetError(f"{name} is {told:g}, {points} points follow; expected as many (is the file cut off?)")


PAIR = re.compile(rf"\[\s{{0,9}}({NUMBER})\s{{0,9}},\s{{0,9}}({NUMBER})\s{{0,9}}\]")


def pairs(text: str, begin: str, end: str) -> list[Array]:
    """Return x and y of ``:= [x, y, …]`` or ``:= [[x, y], …]``; raise TargetError where that is not so."""
    _, found, rest = stripped(text).partition(begin)
    body, closed, _ = rest.partition(end)
    values = [value.strip() for value in PAIR.sub(r"\1, \2", body + end[1:]).split(",")] if found and closed else []
    if len(values) < 4 or len(values) % 2 or not all(map(PLAIN.fullmatch, values)):
        raise TargetError(f"expected {begin} x and y of each point {end}, of numbers alone (is the file cut off?)")
    return [np.array([float(value) for value in values[k::2]]) for k in (0, 1)]
