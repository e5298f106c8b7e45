"""Variations of an overlap: every law, angles chosen and found, each limit, collisions."""

from collections.abc import Iterable
from typing import Any

from workbook.laws.variations import RISING, SIX, factors, law_for, own_in, variations, vary_laws
from workbook.machines.overlap.entries import IndexingOverlap
from workbook.motion.asked import smoothness_for


def variants(machine: IndexingOverlap) -> list[IndexingOverlap]:
    """Return six machines of the same layout: every law, angles chosen and found, each limit, collisions."""
    return [IndexingOverlap.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k, entries = turn % SIX, data["overlap"]
    vary_laws(data["laws"], k, factors(k), data["sizes"]["pieces"])
    entries["rate"] = 1700.0 + 310 * k
    entries["view"] = (97.0, 0.0, 133.5, 140.0, 360.0, 41.0)[k]
    entries["transfer"] |= {"law": law_for(turn, data["laws"]), "stroke": 80.0 + 13 * k, "angle": 110.0 + 11 * k,
                             "smoothness": smoothness_for(turn)}  # fmt: skip
    for i, tool in enumerate(entries["tools"]):
        vary_tool(tool, turn + i, i, data["laws"])
    codes = [entries["transfer"]["law"], *(tool[law] for tool in entries["tools"] for law in ("law_in", "law_out"))]
    for name in set(own_in(data["laws"])) & set(codes):
        data["laws"][name]["pieces"] = RISING
    return data


def vary_tool(tool: dict[str, Any], turn: int, i: int, laws: Iterable[str]) -> None:
    """Give the ``i``-th tool, from 0, the entries of a variation, and strokes that no other tool has."""
    k = turn % SIX
    chosen = (None, (107.0, None), (None, 88.0), (200.0, 70.0), None, (130.0, 140.0))[k]
    tool["angle_in"], tool["angle_out"] = chosen or (None, None)
    tool |= {
        "law_in": law_for(turn + i + 2, laws),
        "law_out": law_for(turn + i + 5, laws),
        "stroke": 40.0 + 7 * k + 3 * i,
        "smoothness": smoothness_for(turn + i + 1),
        "dwell": (60.0, 85.0, 0.0, 33.0, 71.0, 50.0)[k],
    }
    clearance = (21.0, 13.0, 90.0, 17.0, 25.0, 9.0)[k]
    tool["passage"] |= {
        "remaining": (0.4, 1.7, 3.0, 0.0, 7.0, 2.2)[k],
        "clearance": clearance,
        "margin": clearance * (0.1, 0.35, 0.02, 0.2, 1.0, 0.0)[k],
        "allowance": (0.0, 3.0, 4.5, 1.0, 2.0, 6.0)[k],
        "split": (0.5, 0.42, 0.61, 0.55, 0.37, 0.48)[k],
    }
