"""Other inputs at which ``verify`` evaluates a cutting machine's book: every law on every axis, zero stages, each
choice, each side of each check, so that a fault shows that happens to be silent at the values entered."""

from __future__ import annotations

from typing import Any

from workbook.laws.variations import SIX, factors, law_for, passing, variations, vary_laws
from workbook.machines.cutting.entries import CuttingMachine
from workbook.motion.asked import smoothness_for
from workbook.motion.room import within
from workbook.selection.variations import vary_selection


def variants(machine: CuttingMachine) -> list[CuttingMachine]:
    """Return six machines of the same layout as ``machine``, with other inputs everywhere."""
    return [CuttingMachine.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: numbers scaled each by its own factor, choices turned."""
    k = turn % SIX
    timing, drive, sizes = data["timing"], data["drive"], data["sizes"]
    scale = factors(k)
    vary_laws(data["laws"], k, scale, sizes["pieces"])
    timing["rate"] *= next(scale)
    for i, axis in enumerate(timing["axes"]):
        axis |= {"closes": "feed" if (i + k) % 2 else "position", "smoothness": smoothness_for(turn + i)}
        axis["phases"] = within(phases(i, turn, sizes["phases"], data["laws"]), data["laws"], sizes["motion_pieces"])
    drive["axis"] = timing["axes"][k % 3]["name"]
    drive["resists"] = "moving" if k % 2 else "always"
    for entry in ("rate", "force", "radius"):
        drive[entry] *= next(scale)
    drive["rotors"] = rotors(k, sizes["rotors"])
    drive["motor"] = motor(drive["motor"], k, scale)
    vary_selection(data["selection"], k, sizes)
    return data


def phases(axis: int, turn: int, room: int, laws: dict[str, Any]) -> list[dict[str, Any]]:
    """Return phases that fill the cycle, up to the table's last row in turn, with laws and lifts of every kind."""
    k = turn % SIX
    count = room if k == 0 else min(room, 2 + (axis + k) % 5)
    step = 360.0 / count
    edges = [0.0, *((i + 0.1 * ((i + k) % 3)) * step for i in range(1, count)), 360.0]
    made = []
    for i in range(count):
        dwell = (i + axis) % 4 == 3
        lift = 0.0 if dwell else (40.0 + 11 * axis + 3 * i) * (-1) ** (i + k)
        law = "DWL" if dwell else law_for(axis + turn + i, laws)
        made.append({"start": edges[i], "stop": edges[i + 1], "lift": lift, "law": law, **passing(k, i, laws, 0.01)})
    return made


def rotors(k: int, room: int) -> list[dict[str, Any]]:
    """Return rotating parts, geared and not, that fill the table in one variation."""
    made: list[dict[str, Any]] = []
    for i in range(room if k == 0 else min(room, 1 + k % 3)):
        geared = (i + k) % 2 == 1
        teeth = {"teeth_driver": 40.0 + i, "teeth_driven": 23.0 + k} if geared else {}
        made.append({"name": f"part {i + 1}", "count": 1.0 + i, "inertia": 0.02 + 0.01 * i + 0.003 * k, **teeth})
    return made


def motor(given: dict[str, Any], k: int, scale: Any) -> dict[str, Any]:
    """Return another motor: in half of the variations one that each check refuses, once without inertia."""
    limits = ("rated_torque", "peak_torque", "max_speed")
    made = {name: given[name] * next(scale) for name in ("inertia", *limits, "reduction")}
    made["efficiency"] = 0.6 + 0.05 * k
    made["inertia"] = 0.0 if k == 4 else made["inertia"] + 0.001
    for i, name in enumerate(limits):
        made[name] = 1e-3 * (1 + i) if (k + i) % 2 else 1e6 * (1 + i)
    return made
