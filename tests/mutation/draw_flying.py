"""Random valid flying cutters of one layout: what an engineer might enter."""

import random
from math import pi, radians
from typing import Any

from pydantic import ValidationError

from tests.mutation.machines import LAWS, own_pieces, stages
from workbook.machines.flying_model import FlyingCutter


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    laws, entries = data["laws"], data["cutter"]
    for code in LAWS[:-1]:
        laws[code].update(lift=drawn.uniform(-300, 300), time=drawn.uniform(0.05, 3))
    low, high = sorted((drawn.uniform(0.02, 0.98), drawn.uniform(0.02, 0.98)))
    laws["TVP"].update(rise_end=low, fall_start=drawn.choice((low, high)))
    laws["MTP"]["durations"] = stages(drawn)
    law = drawn.choice(LAWS)
    pieces = hump(drawn) if law == "OWN" else own_pieces(drawn, data["sizes"]["pieces"])
    laws["OWN"].update(name=f"Law {drawn.randrange(1000)}", pieces=pieces)
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
    return data if is_valid(data) else varied(data, drawn)


def load(drawn: random.Random) -> dict[str, float]:
    """Return a load with or without a mass that moves with the tool, and a torque."""
    return {
        "inertia": 10 ** drawn.uniform(-4, 1),
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


def is_valid(data: dict[str, Any]) -> bool:
    """Whether the rules of the description are kept: a seven-stage law of little speed, for one, breaks them."""
    try:
        FlyingCutter.model_validate(data)
    except ValidationError:
        return False
    return True
