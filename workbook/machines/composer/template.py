"""S3's composed motion: up to 24 phases over any abscissa."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

from workbook.book.about import about_sheet
from workbook.book.declare import Book, result
from workbook.entries.machine import Machine
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.laws.variations import SIX, factors, law_for, variations, vary_laws
from workbook.machines.composer.entries import MotionComposer
from workbook.machines.composer.sheet import motion_sheet
from workbook.machines.composer.view import Composition
from workbook.template import Template, finish

UNIT = "in the units of Motion"
UNITS = (("s", "mm"), ("°", "°"), ("mm", "mm"), ("°", "mm"), ("rad", "m"), ("s", "°"))


def declare(machine: Machine) -> Book:
    """Declare the book."""
    given = cast(MotionComposer, machine)
    shelf = LawShelf(given.laws, given.sizes)
    composed = Composition(given, shelf.laws)
    travel = composed.motion.lifts_sum
    (h, v, a), (v_max, a_max) = composed.peaks, composed.greatest
    book = Book(given.template, given.title)
    about_sheet(
        book,
        "A motion composed of phases: each a motion law over a lift and a duration, in any units.",
        [
            result("about_travel", "Travel", "Σh", "lift", "=move_travel", travel, scale=h, source=UNIT),
            result("about_v", "Greatest velocity", "|y'|_max", "lift/x", "=move_v", v_max, scale=v, source=UNIT),
            result("about_a", "Greatest acceleration", "|y''|_max", "lift/x²", "=move_a", a_max, scale=a, source=UNIT),
        ],
    )  # fmt: skip
    motion_sheet(book, composed, shelf.stack)
    shelf.sheets(book)
    return finish(book, "Composed motion", ("S1", "S3"))


def variants(machine: Machine) -> list[Machine]:
    """Return six motions of the same layout, with other inputs everywhere."""
    return [MotionComposer.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: other laws, phases, units, begin, and either kind of cycle."""
    k = turn % SIX
    scale = factors(k)
    vary_laws(data["laws"], k, scale, data["sizes"]["pieces"])
    x, y = UNITS[k]
    data["motion"] |= {
        "abscissa_unit": x,
        "lift_unit": y,
        "position": (k - 2) * 7.5,
        "cycle": "open" if k % 2 else "closes",
        "phases": phases(turn, data["sizes"]["phases"], scale),
    }
    return data


def phases(turn: int, room: int, scale: Iterator[float]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and lifts of every kind."""
    k = turn % SIX
    count = room if k == 0 else min(room, (24, 5, 1, 8, 3, 11)[k])
    made = []
    for i in range(count):
        law = "DWL" if (i + k) % 4 == 1 else law_for(turn + i)
        lift = 0.0 if law == "DWL" or (i + k) % 7 == 6 else (12.0 + 5 * i) * (-1) ** (i + k) * next(scale)
        made.append({"law": law, "lift": lift, "duration": (20.0 + 9 * ((i * 5 + k) % 7)) * next(scale)})
    return made


TEMPLATE = Template(
    "motion-composer",
    MotionComposer,
    declare,
    variants,
    LAW_SIZES | {"cycle": ("motion", 1), "phases": ("phases", 0)},
)
