"""Random actuators: every mechanism, loads that resist and that drive, motors far too small and far too large."""

import random
from typing import Any, get_args

from tests.laws import MOVING
from tests.mutation.draw_overlap import rising
from tests.mutation.draw_selection import vary_selection
from tests.mutation.machines import vary_laws
from workbook.machines.actuator.entries import Kind
from workbook.motion.asked import Smoothness
from workbook.motion.room import within


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes, entry = data["sizes"], data["actuator"]
    vary_laws(data["laws"], drawn, sizes["pieces"])
    entry["phases"] = [phase(drawn) for _ in range(drawn.randint(1, sizes["phases"]))]
    if any(p["law"] == "OWN" for p in entry["phases"]):
        data["laws"]["OWN"]["pieces"] = rising(drawn)
    within(entry["phases"], data["laws"], sizes["motion_pieces"])
    gears = drawn.randint(0, sizes["gears"])
    entry.update(
        mechanism=drawn.choice(get_args(Kind)), method=drawn.choice(("physical", "physical", "document")),
        holding=drawn.choice(("motor", "brake")), smoothness=drawn.choice(get_args(Smoothness)),
        gears=[gear(drawn, k) for k in range(gears)],
        parts=[part(drawn, k, gears) for k in range(drawn.randint(0, sizes["rotors"]))],
        load=load(drawn), motor=motor(drawn),
    )  # fmt: skip
    size = {"turns": drawn.uniform(0.02, 1), "diameter": drawn.uniform(20, 400)}
    entry["output"] = size | {"efficiency": drawn.uniform(0.3, 1)}
    vary_selection(data["selection"], sizes, drawn)
    return data


def phase(drawn: random.Random) -> dict[str, Any]:
    """Return a rise, a return, a dwell, or a law that lifts nothing."""
    law = drawn.choice((*MOVING, "DWL"))
    lift = 0.0 if law == "DWL" or drawn.random() < 0.1 else drawn.uniform(-400, 400)
    return {"law": law, "lift": lift, "duration": drawn.uniform(0.1, 2)}


def gear(drawn: random.Random, k: int) -> dict[str, Any]:
    """Return a gear, at times one that speeds up or loses nothing."""
    return {
        "name": f"gear {k + 1}",
        "ratio": drawn.choice((1.0, drawn.uniform(0.3, 20))),
        "efficiency": drawn.choice((1.0, drawn.uniform(0.4, 0.98))),
    }


def part(drawn: random.Random, k: int, gears: int) -> dict[str, Any]:
    """Return a rotating part on any shaft: its inertia entered, or a cylinder, solid or hollow."""
    made = {"name": f"part {k}", "count": float(drawn.randint(0, 4)), "shaft": float(drawn.randint(0, gears))}
    if drawn.random() < 0.4:
        return made | {"inertia": drawn.uniform(0, 1e-3)}
    diameter = drawn.uniform(10, 200)
    size = {"diameter": diameter, "length": drawn.uniform(5, 900), "density": drawn.uniform(1000, 9000)}
    return made | size | {"bore": drawn.choice((None, 0.0, diameter * drawn.uniform(0.1, 0.9)))}


def load(drawn: random.Random) -> dict[str, float]:
    """Return what is moved and what resists; at times nothing does."""
    return {
        "mass": drawn.uniform(0.5, 80), "count": float(drawn.randint(1, 12)), "belt": drawn.uniform(0, 20),
        "friction": drawn.choice((0.0, drawn.uniform(0, 0.6))), "slope": drawn.choice((0.0, drawn.uniform(-90, 90))),
        "force": drawn.choice((0.0, drawn.uniform(-400, 400))), "inertia": drawn.uniform(0, 3),
        "torque": drawn.choice((0.0, drawn.uniform(-60, 60))),
        "friction_torque": drawn.choice((0.0, drawn.uniform(0, 20))),
    }  # fmt: skip


def motor(drawn: random.Random) -> dict[str, Any]:
    """Return a motor at any temperature below its limit."""
    limit = drawn.uniform(100, 200)
    return {
        "inertia": drawn.choice((None, 0.0, drawn.uniform(0, 0.01))),
        "inertia_ratio": drawn.uniform(0.2, 12),
        "rated_torque": 10 ** drawn.uniform(-4, 4),
        "peak_torque": 10 ** drawn.uniform(-4, 4),
        "max_speed": 10 ** drawn.uniform(0, 6),
        "temperature": drawn.uniform(-20, limit - 5),
        "rated_at": drawn.uniform(0, limit - 20),
        "limit": limit,
    }
