"""Random valid flying cutters of one layout: what an engineer might enter."""

import random
from math import pi, radians
from typing import Any

from tests.laws import MOVING
from tests.mutation.draw_selection import vary_selection
from tests.mutation.machines import draw, vary_laws
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
    drum = {"tools": float(drawn.randint(1, 8)), "radius": drawn.uniform(30, 400)}
    drum["tool_angle"] = drawn.choice((0.0, drawn.uniform(0.02, 0.9))) * 360 / drum["tools"]
    saw = {"tool_length": drawn.uniform(20, 900), "lead": drawn.uniform(5, 300), "stroke": 10 ** drawn.uniform(1, 5)}
    kind = drawn.choice(("drum", "drum", "saw"))
    whole = 2 * pi / drum["tools"] * drum["radius"] if kind == "drum" else drawn.uniform(1.2, 8) * saw["tool_length"]
    least = radians(drum["tool_angle"]) * drum["radius"] if kind == "drum" else saw["tool_length"]
    entries.update(
        kind=kind, line_speed=drawn.uniform(1, 400), law=law, beyond=drawn.choice(("standstill", "reversal")),
        product_length=least + drawn.choice((drawn.uniform(0.2, 0.9), drawn.uniform(1.1, 12))) * (whole - least),
        drum=drum, saw=saw, load=load(drawn),
        limits={"speed": 10 ** drawn.uniform(0, 5), "acceleration": 10 ** drawn.uniform(0, 6)},
        lengths={"shortest": least + drawn.uniform(0.2, 0.8) * (whole - least),
                 "longest": least + drawn.uniform(1, 14) * (whole - least)},
    )  # fmt: skip
    return data


def load(drawn: random.Random) -> dict[str, float]:
    """Return a load with or without a mass that moves with the tool, and a torque."""
    return {
        "inertia": 10 ** drawn.uniform(0, 5),
        "mass": drawn.choice((0.0, drawn.uniform(0.1, 200))),
        "torque": drawn.choice((0.0, drawn.uniform(-40, 40))),
    }


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
