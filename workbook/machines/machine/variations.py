"""Other inputs at which ``verify`` evaluates a machine's book: every law, axis by axis, rests of every kind, shifts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from workbook.laws.variations import SIX, factors, law_for, variations, vary_laws
from workbook.machines.machine.entries import AnyMachine
from workbook.motion.asked import smoothness_for
from workbook.motion.room import within

SHIFTS = (0.0, 37.5, -20.0, 360.0, 145.25, 733.0)


def variants(machine: AnyMachine) -> list[AnyMachine]:
    """Return six machines of the same layout as ``machine``, with other inputs everywhere."""
    return [AnyMachine.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: numbers scaled each by its own factor, choices turned."""
    k = turn % SIX
    sizes, scale = data["sizes"], factors(k)
    vary_laws(data["laws"], k, scale, sizes["pieces"])
    data["master"]["rate"] *= next(scale)
    for i, axis in enumerate(data["axes"]):
        axis |= {
            "closes": "feed" if (i + k) % 2 else "position",
            "smoothness": smoothness_for(turn + i),
            "shift": SHIFTS[(i + k) % SIX],
        }
        made = phases(i, turn, sizes["phases"], data["laws"])
        axis["phases"] = within(made, data["laws"], sizes["motion_pieces"] - len(made) - 1)
    return data


def phases(axis: int, turn: int, room: int, laws: Iterable[str]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and lifts of every kind; some rests are not told."""
    k = turn % SIX
    count = room if k == 0 else min(room, 2 + (axis + k) % 5)
    step = 360.0 / count
    edges = [0.0, *((i + 0.1 * ((i + k) % 3)) * step for i in range(1, count)), 360.0]
    made = []
    for i in range(count):
        rest = (i + axis) % 4 == 3
        if rest and i and (axis + k) % 2:
            continue
        lift = 0.0 if rest else (40.0 + 11 * axis + 3 * i) * (-1) ** (i + k)
        law = "DWL" if rest else law_for(axis + turn + i, laws)
        stop = edges[i + 1] - (3.7 if (i + k) % 3 == 1 else 0.0)
        made.append({"start": edges[i], "stop": stop, "lift": lift, "law": law})
    return made
