"""What a spreadsheet hands over, a single value or rows of them, read as codes, parameters and phases.

In rows an empty cell comes as an empty text. An argument that is left out comes as None: a law's parameters are then
those as delivered, and anything else is refused.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Mapping, Tuple, Union

from .composed import AGREES, Motion, Row, Via
from .law import NUM, VALUE, Law, Refused
from .laws import OWN, OWN_WIDTH, PARAMETERS
from .library import Rows, law

Cell = Union[float, str]
Cells = Union[Cell, Tuple[Tuple[Cell, ...], ...], None]
TURNS = {"start": -1.0, "none": 0.0, "end": 1.0}
VIA = "VIA"
"""where a law turns round, as a number; what stands for the code in a row of what is prescribed between phases"""


def number(cell: Cell, words: Mapping[str, float] = {}) -> float:
    """Return the number in a cell, 0 of an empty one, or what one of these words stands for; refuses another text."""
    if isinstance(cell, str):
        cell = words.get(cell.strip().lower(), cell or 0.0)
    if isinstance(cell, str):
        raise Refused(VALUE)
    return cell


def rows(cells: Cells, words: Mapping[str, float] = {}) -> Rows:
    """Return the numbers of a range, or of a single value, by row."""
    if cells is None:
        raise Refused(VALUE)
    table = cells if isinstance(cells, tuple) else ((cells,),)
    return tuple(tuple(number(cell, words) for cell in row) for row in table)


def parameters(code: str, given: Cells) -> Rows:
    """Return the parameters of a law in cells; those of a law that takes none are not looked at."""
    if PARAMETERS.get(code) == 0 or given is None:
        return OWN if code == "OWN" else ((0.0,),)
    if code != "OWN":
        return rows(given, TURNS)
    found = rows(given)
    return tuple(row for row in found if any(row)) or found[:1]  # blank rows are no pieces, and would fill the cache


def named(name: Cell, given: Cells) -> Law:
    """Return the law of a code with the parameters in cells."""
    code = str(name).strip().upper()
    return law(code, parameters(code, given))


def motion(table: Cells) -> Motion:
    """Return the motion of a table of phases, a row a phase: code, duration, lift, parameters of the law.

    Where numbers stand in the first column, the columns are those of a book's phases: from, to, lift, code, parameters.
    """
    if not isinstance(table, tuple) or len(table[0]) < 3:
        raise Refused(VALUE)
    dated = any(isinstance(row[0], float) for row in table)
    count, looked_at = len(table), 4 if dated else 3
    while count and not any(cell != "" for cell in table[count - 1][:looked_at]):
        count -= 1
    return (rested if dated else moved)(table[:count])


@lru_cache(maxsize=128)
def moved(table: tuple[tuple[Cell, ...], ...]) -> Motion:
    """Return the motion of a table without blank rows at its end; a row VIA prescribes what its phases have there."""
    return Motion([
        Via(*(number(cell) for cell in (*row[1:4], 0.0)[:3])) if str(row[0]).strip().upper() == VIA else phase(row)
        for row in table
    ])  # fmt: skip


@lru_cache(maxsize=128)
def rested(table: tuple[tuple[Cell, ...], ...]) -> Motion:
    """Return the motion of phases from, to, which rests before, between and after them."""
    if len(table[0]) < 4 or any(str(row[3]).strip().upper() == VIA for row in table):
        raise Refused(VALUE)
    starts, stops = [number(row[0]) for row in table], [number(row[1]) for row in table]
    length = stops[-1] - starts[0]
    begin, end = starts[0] - length, stops[-1] + length
    found = []
    for done, start, stop, row in zip([begin, *stops], [*starts, end], [*stops, end], [*table, ()]):
        if abs(start - done) > AGREES * abs(length):
            found.append(phase(("DWL", start - done, 0.0)))
        if row:
            found.append(phase((row[3], stop - start, row[2], *row[4:])))
    return Motion(found, begin)


def phase(row: tuple[Cell, ...]) -> Row:
    """Return the phase of a row."""
    code = str(row[0]).strip().upper()
    duration, lift = number(row[1]), number(row[2])
    given = side_by_side(row[3:]) if code == "OWN" else (row[3 : 3 + PARAMETERS.get(code, 0)] or (0.0,),)
    found = parameters(code, given)
    law(code, found)  # refuses a code and parameters before all else
    if duration <= 0.0 or (code == "DWL" and lift):
        raise Refused(NUM)
    return Row(code, found, duration, lift)


def side_by_side(cells: tuple[Cell, ...]) -> tuple[tuple[Cell, ...], ...]:
    """Return the pieces of an own law that follow each other in a row; refuses a row with room for none."""
    starts = range(0, len(cells) - OWN_WIDTH + 1, OWN_WIDTH)
    if not starts:
        raise Refused(VALUE)
    return tuple(cells[start : start + OWN_WIDTH] for start in starts)


def pairs(one: Cells, other: Cells) -> tuple[list[float], list[float]]:
    """Return the numbers of two ranges; refuses ranges of unequal rows or columns."""
    first, second = rows(one), rows(other)
    if [len(row) for row in first] != [len(row) for row in second]:
        raise Refused(VALUE)
    return [value for row in first for value in row], [value for row in second for value in row]
