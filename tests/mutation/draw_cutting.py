"""Random cutting machines."""

import random
from itertools import pairwise
from typing import Any, get_args

from tests.laws import MOVING
from tests.mutation.draw_selection import vary_selection
from tests.mutation.machines import shares, vary_laws
from workbook.motion.asked import Smoothness
from workbook.motion.room import within


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes, drive = data["sizes"], data["drive"]
    vary_laws(data["laws"], drawn, sizes["pieces"])
    vary_selection(data["selection"], sizes, drawn)
    data["timing"]["rate"] = drawn.uniform(5, 600)
    for axis in data["timing"]["axes"]:
        moved = within(phases(drawn, sizes["phases"]), data["laws"], sizes["motion_pieces"])
        smoothness = drawn.choice(get_args(Smoothness))
        axis.update(closes=drawn.choice(("feed", "position")), smoothness=smoothness, phases=moved)
    drive.update(
        rate=drawn.uniform(5, 600), force=drawn.choice((0.0, drawn.uniform(-900, 900))), radius=drawn.uniform(0.02, 2),
        resists=drawn.choice(("always", "moving")), axis=drawn.choice(data["timing"]["axes"])["name"],
        rotors=rotors(drawn, sizes["rotors"]), motor=motor(drawn),
    )  # fmt: skip
    return data


def phases(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return phases that fill the cycle; with some luck the first and last, or two in a row, move."""
    edges = [0.0]
    for share in shares(drawn, drawn.randint(1, room)):
        edges.append(edges[-1] + share * 360)
    edges[-1] = 360.0
    made = []
    for start, stop in pairwise(edges):
        law = drawn.choice((*MOVING, "DWL"))
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
