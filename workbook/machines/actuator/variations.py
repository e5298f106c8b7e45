"""Other inputs at which ``verify`` evaluates an actuator's book: every mechanism, both methods, each check."""

from __future__ import annotations

from typing import Any

from workbook.laws.variations import SIX, factors, law_for, own_in, variations, vary_laws
from workbook.laws.variations import own_pieces as own
from workbook.machines.actuator.entries import ActuatorSizing
from workbook.motion.asked import smoothness_for
from workbook.motion.room import within
from workbook.selection.variations import vary_selection

KINDS = ("rotary table", "conveyor", "rack and pinion", "belt", "lead screw", "gear train")
RISING = (
    [{"duration": 0.4, "c0": 5.0}, {"duration": 0.6, "c0": -10 / 3}],
    [
        {"duration": 0.3, "c0": 3.0, "c1": 1.5, "c2": -2.0, "c3": 0.7, "amplitude": 1.2, "omega": 7.0, "phase": 0.4},
        {"duration": 0.25, "c0": 1.0, "c1": -9.0, "amplitude": 2.0, "omega": 3.0, "phase": 1.1},
        {"duration": 0.45, "c0": -2.0, "c2": 4.0, "amplitude": -1.0, "omega": 9.0},
    ],
)
"""own laws that rise throughout, where a phase takes the own law"""
BACKWARDS = [{"duration": 0.5, "c0": -4.0}, {"duration": 0.5, "c0": 12.0}]
"""and one that does not, where none does"""


def variants(machine: ActuatorSizing) -> list[ActuatorSizing]:
    """Return six machines of the same layout: every mechanism, both methods, each check, power turning round."""
    return [ActuatorSizing.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k = turn % SIX
    sizes, entry, scale = data["sizes"], data["actuator"], factors(k)
    vary_laws(data["laws"], k, scale, sizes["pieces"])
    entry |= {
        "mechanism": KINDS[k],
        "method": "document" if k == 3 else "physical",
        "holding": "brake" if k % 3 == 1 else "motor",
        "smoothness": smoothness_for(turn),
        "output": {"turns": 0.05 + 0.03 * k, "diameter": 80.0 + 13 * k, "efficiency": 0.55 + 0.07 * k},
        "gears": [gear(k, i) for i in range((k + 1) % 3 if k else sizes["gears"])],
        "phases": phases(turn, sizes["phases"], data["laws"]),
    }  # fmt: skip
    for name in own_in(data["laws"]):
        data["laws"][name]["pieces"] = own_pieces(k, sizes["pieces"], name, entry["phases"])
    within(entry["phases"], data["laws"], sizes["motion_pieces"])
    entry["parts"] = parts(k, sizes["rotors"], len(entry["gears"]))
    entry["load"] |= {
        "mass": 4.0 + 2.3 * k,
        "count": 1.0 + k % 3,
        "belt": 0.6 + 0.3 * k,
        "friction": 0.02 * k,
        "slope": (15.0, -20.0, 0.0, 35.0, -32.0, 5.0)[k],
        "force": (0.0, -12.0, 9.0, 0.0, 3.0, -5.0)[k],
        "inertia": 0.02 + 0.013 * k,
        "torque": (0.9, 1.0, -0.7, 0.2, 0.4, -0.85)[k],
        "friction_torque": 0.11 * k,
    }
    entry["motor"] = motor(k)
    vary_selection(data["selection"], k, sizes)
    return data


def gear(k: int, i: int) -> dict[str, Any]:
    """Return one gear."""
    return {"name": f"gear {i + 1}", "ratio": 2.5 + i + 0.4 * k, "efficiency": 0.7 + 0.04 * k - 0.02 * i}


def phases(turn: int, room: int, laws: dict[str, Any]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and directions of every kind."""
    made: list[dict[str, Any]] = []
    k = turn % SIX
    own = own_in(laws)
    names = [name for name in laws if k % 3 == 0 or name not in own]
    for i in range(room if k == 0 else min(room, (24, 6, 6, 2, 6, 6)[k])):
        law = "OWN" if k == 2 else "DWL" if (i + k) % 4 == 1 else law_for(turn + turn // SIX + i, names)
        lift = 0.0 if law == "DWL" or (i + k) % 7 == 6 else (60.0 + 17 * i) * (-1) ** (i + k)
        made.append({"law": law, "lift": lift, "duration": (0.2 + 0.17 * ((i * 5 + k) % 4)) / (3 if k == 1 else 1)})
    return made


def own_pieces(k: int, room: int, name: str, taken: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return an own law: one that rises, if a phase takes it."""
    if any(phase["law"] == name for phase in taken):
        return RISING[1] if k % 2 == 0 and room >= len(RISING[1]) else RISING[0]
    return BACKWARDS if k % 2 else own(k, room)


def parts(k: int, room: int, gears: int) -> list[dict[str, Any]]:
    """Return rotating parts, entered and cylinders, behind every gear that there is."""
    made: list[dict[str, Any]] = []
    for i in range(room if k == 0 else min(room, 1 + k % 3)):
        part = {"name": f"part {i + 1}", "count": 1.0 + i, "shaft": float(min(i, gears))}
        size = {"diameter": 30.0 + 7 * i, "length": 80.0 + k, "density": 7800.0, "bore": None if i % 3 else 8.0 + k}
        made.append(part | ({"inertia": 1e-5 * (i + 2 + k)} if (i + k) % 2 else size))
    return made


def motor(k: int) -> dict[str, Any]:
    """Return a motor that a check refuses in half of the variations; its inertia entered or by the ratio."""
    made: dict[str, Any] = {
        "inertia": (None, 2e-5, None, 0.0, 3e-4, None)[k],
        "inertia_ratio": 1.3 + 0.7 * k,
        "temperature": (20.0, 40.0, 60.0, 25.0, -5.0, 90.0)[k],
        "rated_at": (25.0, 40.0, 30.0, 25.0, 20.0, 40.0)[k],
        "limit": 150.0 + 5 * k,
    }
    for i, name in enumerate(("rated_torque", "peak_torque", "max_speed")):
        made[name] = 1e-4 * (1 + i) if (k + i) % 2 else 1e6 * (1 + i)
    return made
