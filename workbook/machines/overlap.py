"""Overlap of two motions (S2): the indexing mill and the die, one after the other and with overlap."""

from __future__ import annotations

from typing import Any, cast

from workbook.declare import Book, result
from workbook.machine import Machine
from workbook.machines.overlap_model import IndexingOverlap, Overlapping
from workbook.machines.variants import LAWS, factors, vary_laws
from workbook.reference import MM
from workbook.sheets.about import about_sheet
from workbook.sheets.overlap.cycle import cycle_sheet
from workbook.sheets.overlap.inverse import inverse_sheet
from workbook.sheets.overlap.picture import picture_sheet
from workbook.sheets.overlap.sheet import overlap_sheet
from workbook.template import LAW_SIZES, LawShelf, Template, finish

RISING = [
    {"duration": 0.4, "c0": 5.0},
    {"duration": 0.6, "c0": -10 / 3},
]
"""An own law that rises throughout: accelerated for less time than braked."""


def declare(machine: Machine) -> Book:
    """Declare the book."""
    given = cast(IndexingOverlap, machine)
    shelf = LawShelf(given.laws, given.sizes)
    view = Overlapping(given, shelf.laws)
    book = Book(given.template, given.title)
    peaks = [s.peak_acceleration(view.rate) for s in (view.before, view.as_set)]
    least = view.clearance.minimum / MM
    about_sheet(
        book,
        "Two motions of one machine, one after the other and with overlap: how much the acceleration falls.",
        [
            result("about_a0", "Peak acceleration one after the other", "a_max", "m/s²", "=overlap_a0", peaks[0]),
            result("about_a1", "Peak acceleration with overlap", "a_max", "m/s²", "=overlap_a1", peaks[1]),
            result("about_least", "Least clearance over the cycle", "", "mm", "=overlap_least", least, scale=1.0),
        ],
    )  # fmt: skip
    overlap_sheet(book, view, shelf.stack)
    picture_sheet(book, view, shelf.stack)
    cycle_sheet(book, view, shelf.stack)
    inverse_sheet(book, view, shelf.rows)
    shelf.sheets(book)
    return finish(book, "Overlap of two motions", ("S2", "S1", "S3"))


def variants(machine: Machine) -> list[Machine]:
    """Return six machines of the same layout: every law, angles chosen and found, each limit, collisions."""
    return [IndexingOverlap.model_validate(varied(machine.model_dump(), k)) for k in range(6)]


def varied(data: dict[str, Any], k: int) -> dict[str, Any]:
    """Return the ``k``-th variation of a description."""
    entries, scale = data["overlap"], factors(k)
    vary_laws(data["laws"], k, scale, data["sizes"]["pieces"])
    codes = [LAWS[(k + i) % 6] for i in (0, 2, 5)]
    if "OWN" in codes:
        data["laws"]["OWN"]["pieces"] = RISING
    transfer, tool, passage = entries["transfer"], entries["tool"], entries["passage"]
    entries["rate"] = 1700.0 + 310 * k
    entries["view"] = (97.0, 0.0, 133.5, 140.0, 360.0, 41.0)[k]
    transfer |= {"law": codes[0], "stroke": 80.0 + 13 * k, "angle": 110.0 + 11 * k}
    tool |= {
        "law_in": codes[1],
        "law_out": codes[2],
        "stroke": 40.0 + 7 * k,
        "dwell": (60.0, 85.0, 0.0, 33.0, 71.0, 50.0)[k],
    }
    chosen = (None, (107.0, None), (None, 88.0), (200.0, 70.0), None, (130.0, 140.0))[k]
    tool["angle_in"], tool["angle_out"] = chosen or (None, None)
    clearance = (21.0, 13.0, 90.0, 17.0, 25.0, 9.0)[k]
    passage |= {
        "remaining": (0.4, 1.7, 3.0, 0.0, 7.0, 2.2)[k],
        "clearance": clearance,
        "margin": clearance * (0.1, 0.35, 0.02, 0.2, 1.0, 0.0)[k],
        "allowance": (0.0, 3.0, 4.5, 1.0, 2.0, 6.0)[k],
        "split": (0.5, 0.42, 0.61, 0.55, 0.37, 0.48)[k],
    }
    return data


TEMPLATE = Template(
    "indexing-overlap",
    IndexingOverlap,
    declare,
    variants,
    LAW_SIZES | {"cycle": ("motions", 1), "margins": ("margins", 1)},
)
