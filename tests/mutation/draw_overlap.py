"""Random transfers and tools: chosen angles or found ones, clearances that suffice or not."""

import random
from typing import Any

from tests.laws import MOVING
from tests.mutation.machines import vary_laws


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew; it may be one that a machine refuses."""
    entries = data["overlap"]
    vary_laws(data["laws"], drawn, data["sizes"]["pieces"])
    codes = [drawn.choice(MOVING) for _ in range(1 + 2 * len(entries["tools"]))]
    if "OWN" in codes:
        data["laws"]["OWN"]["pieces"] = rising(drawn)
    entries.update(rate=drawn.uniform(100, 9000), view=drawn.choice((0.0, 360.0, drawn.uniform(0, 360))))
    entries["transfer"] |= {"law": codes[0], "stroke": drawn.uniform(20, 300), "angle": drawn.uniform(60, 200)}
    for tool, law_in, law_out in zip(entries["tools"], codes[1::2], codes[2::2], strict=True):
        tool.update(tool_drawn(drawn), law_in=law_in, law_out=law_out)
        tool["passage"] |= passage_drawn(drawn)
    return data


def tool_drawn(drawn: random.Random) -> dict[str, Any]:
    """Return the way of a tool and its angles, chosen or not."""
    return {
        "stroke": drawn.uniform(15, 200),
        "dwell": drawn.choice((0.0, drawn.uniform(5, 90))),
        "angle_in": drawn.choice((None, drawn.uniform(20, 150))),
        "angle_out": drawn.choice((None, drawn.uniform(20, 150))),
    }


def passage_drawn(drawn: random.Random) -> dict[str, Any]:
    """Return what the transfer leaves a tool."""
    clearance = drawn.uniform(2, 60)
    return {
        "remaining": drawn.choice((0.0, drawn.uniform(0.1, 12))),
        "clearance": clearance,
        "margin": clearance * drawn.choice((0.0, 1.0, drawn.uniform(0.05, 0.6))),
        "allowance": drawn.choice((0.0, drawn.uniform(0, 6))),
        "split": drawn.uniform(0.2, 0.8),
    }


def rising(drawn: random.Random) -> list[dict[str, float]]:
    """Return an own law that rises throughout: accelerated, then braked to rest."""
    share = drawn.uniform(0.2, 0.8)
    return [{"duration": share, "c0": 2 / share}, {"duration": 1 - share, "c0": -2 / (1 - share)}]
