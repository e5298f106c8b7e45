"""Random valid machines of one layout: what an engineer might enter, to tell whether a mutant ever shows."""

import random
from itertools import pairwise
from typing import Any

from workbook.machine import Machine

DRAWN = ("cutting-machine",)  # the templates whose machines can be drawn here
LAWS = ("ACS", "TVP", "CIC", "CUB", "MTP", "OWN")


def machines(given: Machine, count: int, seed: int) -> list[Machine]:
    """Return machines with the sizes of ``given`` and other entries everywhere; the same for the same seed."""
    drawn = random.Random(seed)
    return [type(given).model_validate(varied(given.model_dump(), drawn)) for _ in range(count)]


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes, laws, drive = data["sizes"], data["laws"], data["drive"]
    for code in LAWS[:-1]:
        laws[code].update(lift=drawn.uniform(-300, 300), time=drawn.uniform(0.05, 3))
    low, high = sorted((drawn.uniform(0.02, 0.98), drawn.uniform(0.02, 0.98)))
    laws["TVP"].update(rise_end=low, fall_start=drawn.choice((low, high)))
    laws["MTP"]["durations"] = stages(drawn)
    laws["OWN"].update(name=f"Law {drawn.randrange(1000)}", pieces=own_pieces(drawn, sizes["pieces"]))
    data["timing"]["rate"] = drawn.uniform(5, 600)
    for axis in data["timing"]["axes"]:
        axis.update(closes=drawn.choice(("feed", "position")), phases=phases(drawn, sizes["phases"]))
    drive.update(
        rate=drawn.uniform(5, 600), force=drawn.choice((0.0, drawn.uniform(-900, 900))), radius=drawn.uniform(0.02, 2),
        resists=drawn.choice(("always", "moving")), axis=drawn.choice(data["timing"]["axes"])["name"],
        rotors=rotors(drawn, sizes["rotors"]), motor=motor(drawn),
    )  # fmt: skip
    return data


def shares(drawn: random.Random, count: int) -> list[float]:
    """Return shares of a whole that add up to 1."""
    parts = [drawn.uniform(0.1, 1) for _ in range(count)]
    return [p / sum(parts) for p in parts]


def stages(drawn: random.Random) -> list[float]:
    """Return seven stages, some of them missing, so that the law can start and stop."""
    kept = sorted({drawn.randrange(3), drawn.randrange(4, 7), *drawn.sample(range(7), drawn.randrange(6))})
    durations = [0.0] * 7
    for stage, share in zip(kept, shares(drawn, len(kept)), strict=True):
        durations[stage] = share
    return durations


def own_pieces(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return a law of one piece or many, with or without sines, at times with a piece of no length among them."""
    pieces: list[dict[str, Any]] = []
    for share in shares(drawn, drawn.randint(1, room)):
        terms = {name: drawn.choice((0.0, drawn.uniform(-9, 9))) for name in ("c0", "c1", "c2", "c3", "phase")}
        sine = {"amplitude": drawn.uniform(-9, 9), "omega": drawn.uniform(0.5, 13)} if drawn.random() < 0.6 else {}
        pieces.append({"duration": share, **terms, **sine})
    if len(pieces) < room and drawn.random() < 0.3:
        pieces.insert(drawn.randrange(len(pieces) + 1), {"duration": 0.0, "c0": 5.0})
    return pieces


def phases(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return phases that fill the cycle; with some luck the first and last, or two in a row, move."""
    edges = [0.0]
    for share in shares(drawn, drawn.randint(1, room)):
        edges.append(edges[-1] + share * 360)
    edges[-1] = 360.0
    made = []
    for start, stop in pairwise(edges):
        law = drawn.choice((*LAWS, "DWL"))
        lift = 0.0 if law == "DWL" else drawn.choice((0.0, drawn.uniform(-200, 200), drawn.uniform(-200, 200)))
        made.append({"start": start, "stop": stop, "lift": lift, "law": law})
    return made


def rotors(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return rotating parts, geared or not."""
    made: list[dict[str, Any]] = []
    for i in range(drawn.randint(1, room)):
        teeth = {f"teeth_{side}": float(drawn.randint(12, 99)) for side in ("driver", "driven")}
        part = {"name": f"part {i}", "count": float(drawn.randint(0, 5)), "inertia": drawn.uniform(0, 2)}
        made.append(part | (teeth if drawn.random() < 0.6 else {}))
    return made


def motor(drawn: random.Random) -> dict[str, float]:
    """Return a motor that is far too small, about right or far too large."""
    return {
        "inertia": drawn.choice((0.0, drawn.uniform(0, 0.2))),
        "rated_torque": 10 ** drawn.uniform(-3, 6),
        "peak_torque": 10 ** drawn.uniform(-3, 6),
        "max_speed": 10 ** drawn.uniform(-2, 7),
        "reduction": drawn.uniform(0.2, 40),
        "efficiency": drawn.uniform(0.3, 1),
    }
