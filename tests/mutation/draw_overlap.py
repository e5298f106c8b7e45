"""Random transfers and tools: chosen angles or found ones, clearances that suffice or not."""

import random
from typing import Any

from tests.laws import MOVING
from tests.mutation.machines import draw, vary_laws
from workbook.machines.overlap.entries import OverlapEntry, ToolEntry


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew; it may be one that a machine refuses."""
    entries = data["overlap"]
    vary_laws(data["laws"], drawn, data["sizes"]["pieces"])
    codes = [drawn.choice(MOVING) for _ in range(1 + 2 * len(entries["tools"]))]
    if "OWN" in codes:
        data["laws"]["OWN"]["pieces"] = rising(drawn)
    draw(entries, OverlapEntry, drawn)
    entries["view"] = drawn.choice((0.0, 360.0, drawn.uniform(0, 360)))
    entries["transfer"]["law"] = codes[0]
    for tool, law_in, law_out in zip(entries["tools"], codes[1::2], codes[2::2], strict=True):
        draw(tool, ToolEntry, drawn)
        tool |= {"law_in": law_in, "law_out": law_out}
    return data


def rising(drawn: random.Random) -> list[dict[str, float]]:
    """Return an own law that rises throughout: accelerated, then braked to rest."""
    share = drawn.uniform(0.2, 0.8)
    return [{"duration": share, "c0": 2 / share}, {"duration": 1 - share, "c0": -2 / (1 - share)}]
