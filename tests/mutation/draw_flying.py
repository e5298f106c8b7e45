"""Random valid flying cutters of one layout: what an engineer might enter."""

import random
from math import pi, radians
from typing import Any

from tests.laws import MOVING
from tests.mutation.draw_selection import vary_selection
from tests.mutation.machines import draw, vary_laws
from workbook.machines.flying.entries import CutterEntry
from workbook.selection.entries import Limits


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew; a law of little speed makes it one that is refused."""
    entries = data["cutter"]
    vary_laws(data["laws"], drawn, data["sizes"]["pieces"])
    law = drawn.choice(MOVING)
    if law == "OWN":
        data["laws"]["OWN"]["pieces"] = hump(drawn)
    vary_selection(data["selection"], data["sizes"], drawn)
    draw(data["limits"], Limits, drawn)
    draw(entries, CutterEntry, drawn)
    drum, saw, entries["kind"] = entries["drum"], entries["saw"], drawn.choice(("drum", "drum", "saw"))
    drum["tools"] = float(drawn.randint(1, 8))
    drum["tool_angle"] = drawn.choice((0.0, drawn.uniform(0.02, 0.9))) * 360 / drum["tools"]
    rotates = entries["kind"] == "drum"
    whole = 2 * pi / drum["tools"] * drum["radius"] if rotates else drawn.uniform(1.2, 8) * saw["tool_length"]
    least = radians(drum["tool_angle"]) * drum["radius"] if rotates else saw["tool_length"]
    entries |= {
        "law": law,
        "product_length": least + drawn.choice((drawn.uniform(0.2, 0.9), drawn.uniform(1.1, 12))) * (whole - least),
        "lengths": {
            "shortest": least + drawn.uniform(0.2, 0.8) * (whole - least),
            "longest": least + drawn.uniform(1, 14) * (whole - least),
        },
    }
    return data


def hump(drawn: random.Random) -> list[dict[str, Any]]:
    """Return a law that speeds up once and slows down once, at rest at both ends: a sine or a constant each way."""
    rise = drawn.uniform(0.2, 0.8)
    made = []
    for duration, sign in ((rise, 1.0), (1.0 - rise, -1.0)):
        if drawn.random() < 0.5:
            made.append({"duration": duration, "c0": sign * 2 / duration})
        else:
            sine = {"amplitude": sign * pi / duration, "omega": pi / duration}
            made.append({"duration": duration, **sine})
    return made if drawn.random() < 0.7 else [*made, {"duration": 0.0, "c0": 5.0}]
