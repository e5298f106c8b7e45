"""A controller's table as the description of a composed motion: dwells, laws, and laws of its own for the rest."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from engine.cams.identify import Found, Points, identified, precision
from engine.laws import PieceLaw
from workbook.controllers.handing import rules_of
from workbook.controllers.table import Table
from workbook.controllers.target import Target
from workbook.errors import TargetError

UNITS = re.compile(r"x in (\S{1,12}), y in (\S{1,12});")
BASIC = ("ACS", "TVP", "CIC", "CUB", "MTP")
NEXT = 1e-9  # of the cycle: phases so near to each other meet


def phases_of(target: Target, table: Table) -> list[Found]:
    """Return the movements that a table was made of."""
    rebuilt = next(iter(rules_of(target, table).values())).made(table)
    known = precision(table.y)
    if table.steps[1] != 1.0:
        known = max(known, 0.5 * table.steps[1])
    return identified(Points(table.x, table.y, table.v, table.a, known), rebuilt)


def units_of(text: str) -> tuple[str, str]:
    """Return the units that a header of ours tells; ° and mm where there is none."""
    found = UNITS.search(text)
    return (found[1], found[2]) if found else ("°", "mm")


def lines(found: Sequence[Found], units: tuple[str, str]) -> list[str]:
    """Return a line for each movement: its law, from where to where, its lift, and what the table is off by."""
    x, y = units
    said = []
    for one in found:
        own = isinstance(one.law, PieceLaw)
        name = f"no law of the registry, {len(one.law.as_pieces())} pieces" if own else one.law.name
        misses = "" if one.fits else "; it neither begins and ends at rest nor keeps to the points"
        place = f"{one.begin:.9g}–{one.end:.9g} {x}"
        said.append(f"{place}: {name}, lift {one.lift:.9g} {y}, residual {one.residual:.2g} {y}{misses}")
    return said


def composed(found: Sequence[Found], table: Table, units: tuple[str, str], title: str) -> dict[str, Any]:
    """Return the description of a composed motion; raise TargetError for movements that none can have."""
    begin, end = float(table.x[0]), float(table.x[-1])
    for one in found:
        if not one.fits:
            raise TargetError(f"from {one.begin:.9g} to {one.end:.9g} it does not move from rest to rest by any law; "
                              "a composed motion needs such phases")  # fmt: skip
    edges, phases = [begin], []
    laws: dict[str, Any] = {}
    for k, one in enumerate(found):
        low, high = max(one.begin, edges[-1]), min(one.end, end)
        if low - edges[-1] > NEXT * (end - begin):
            phases.append({"law": "DWL", "lift": 0.0, "duration": low - edges[-1]})
        name, law = named(one, k)
        laws |= law
        start = edges[-1] if low - edges[-1] <= NEXT * (end - begin) else low
        phases.append({"law": name, "lift": one.lift, "duration": high - start})
        edges.append(high)
    if end - edges[-1] > NEXT * (end - begin):
        phases.append({"law": "DWL", "lift": 0.0, "duration": end - edges[-1]})
    travel = sum(one.lift for one in found)
    closes = abs(travel) <= NEXT * max((abs(one.lift) for one in found), default=1.0)
    motion = {"abscissa_unit": units[0], "lift_unit": units[1], "position": float(found[0].y if found else table.y[0]),
              "cycle": "closes" if closes else "open", "phases": tidy(phases)}  # fmt: skip
    return {"template": "motion-composer", "title": title, "laws": laws, "motion": motion}


def tidy(phases: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return phases with durations as they were meant, without what rounding leaves behind the twelfth digit."""
    return [phase | {"duration": float(f"{phase['duration']:.12g}")} for phase in phases]


def named(one: Found, k: int) -> tuple[str, dict[str, Any]]:
    """Return the name of a movement's law in a description, and its entry there where it needs one."""
    if isinstance(one.law, PieceLaw):
        pieces = [{"duration": p.duration, **{f"c{i}": c for i, c in enumerate(p.c)}} for p in one.law.pieces]
        name = f"Read {k + 1}"
        return name, {name: {"family": "OWN", "name": name, "pieces": pieces}}
    if one.law.code in BASIC:
        return one.law.code, {}
    return one.law.name, {one.law.name: {"family": one.law.code}}
