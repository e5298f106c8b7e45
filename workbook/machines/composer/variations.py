"""Variations of a composed motion: other laws, phases, units and cycles, at which a book is verified too."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from workbook.laws.variations import SIX, factors, law_for, passing, variations, vary_laws
from workbook.machines.composer.entries import MotionComposer
from workbook.motion.asked import smoothness_for
from workbook.motion.room import within

UNITS = (("s", "mm"), ("°", "°"), ("mm", "mm"), ("°", "mm"), ("rad", "m"), ("s", "°"))


def variants(machine: MotionComposer) -> list[MotionComposer]:
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
        "smoothness": smoothness_for(turn),
        "phases": within(
            phases(turn, data["sizes"]["phases"], scale, data["laws"]), data["laws"], data["sizes"]["motion_pieces"]
        ),
    }
    return data


def phases(turn: int, room: int, scale: Iterator[float], laws: dict[str, Any]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and lifts of every kind."""
    k = turn % SIX
    count = room if k == 0 else min(room, (24, 5, 1, 8, 3, 11)[k])
    made = []
    for i in range(count):
        law = "DWL" if (i + k) % 4 == 1 else law_for(turn + i, laws)
        lift = 0.0 if law == "DWL" or (i + k) % 7 == 6 else (12.0 + 5 * i) * (-1) ** (i + k) * next(scale)
        duration = (20.0 + 9 * ((i * 5 + k) % 7)) * next(scale)
        made.append({"law": law, "lift": lift, "duration": duration, **passing(k, i, laws, 0.1)})
    return made
