"""Variations of a composed motion: other laws, phases, units and cycles, at which a book is verified too."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from workbook.laws.variations import LAWS, factors, vary_laws
from workbook.machines.composer.entries import MotionComposer

UNITS = (("s", "mm"), ("°", "°"), ("mm", "mm"), ("°", "mm"), ("rad", "m"), ("s", "°"))


def variants(machine: MotionComposer) -> list[MotionComposer]:
    """Return six motions of the same layout, with other inputs everywhere."""
    return [MotionComposer.model_validate(varied(machine.model_dump(), k)) for k in range(6)]


def varied(data: dict[str, Any], k: int) -> dict[str, Any]:
    """Return the ``k``-th variation of a description: other laws, phases, units, begin, and either kind of cycle."""
    scale = factors(k)
    vary_laws(data["laws"], k, scale, data["sizes"]["pieces"])
    x, y = UNITS[k]
    data["motion"] |= {
        "abscissa_unit": x,
        "lift_unit": y,
        "position": (k - 2) * 7.5,
        "cycle": "open" if k % 2 else "closes",
        "phases": phases(k, data["sizes"]["phases"], scale),
    }
    return data


def phases(k: int, room: int, scale: Iterator[float]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and lifts of every kind."""
    count = room if k == 0 else min(room, (24, 5, 1, 8, 3, 11)[k])
    made = []
    for i in range(count):
        law = "DWL" if (i + k) % 4 == 1 else LAWS[(k + i) % 6]
        lift = 0.0 if law == "DWL" or (i + k) % 7 == 6 else (12.0 + 5 * i) * (-1) ** (i + k) * next(scale)
        made.append({"law": law, "lift": lift, "duration": (20.0 + 9 * ((i * 5 + k) % 7)) * next(scale)})
    return made
