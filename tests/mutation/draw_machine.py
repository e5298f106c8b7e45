"""Random machines of any axes."""

import random
from collections.abc import Sequence
from typing import Any, get_args

from engine.selection.pair_matrix import Rank
from tests.laws import MOVING
from tests.mutation.machines import draw, shares, vary_laws
from workbook.entries.phase import AxisPhase
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive_entries import AxisLoad, AxisMotor, PowerEntry, Reducer, StageEntry, lacking
from workbook.machines.machine.entries import Closes, MachineSizes, rests
from workbook.machines.machine.entries_beside import TIMES, ClearanceEntry, HardStops
from workbook.machines.machine.mechanism import LINKED, MECHANISMS, SLIDING
from workbook.machines.machine.places import to_units
from workbook.motion.requirements import Smoothness, dwells_for_room
from workbook.selection.entries import Limits, OwnLimits

SHAPED = {name for name in MOVING if name != "OWN"}


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes = data["sizes"]
    vary_laws(data["laws"], drawn, sizes["pieces"])
    pace = next(iter(data["master"]))
    data["master"][pace] = drawn.uniform(5, 600) if pace == "rate" else 10 ** drawn.uniform(-2, 4)
    for i, axis in enumerate(data["axes"]):
        laws = MOVING if axis["motor"] is None else [name for name in MOVING if name in SHAPED]
        made = phases(drawn, sizes["phases"], laws)
        room = MachineSizes(**sizes).pieces_of(i + 1) - len(rests([AxisPhase(**row) for row in made]))
        axis.update(
            closes=drawn.choice(("feed", "position")), smoothness=drawn.choice(get_args(Smoothness)),
            shift=drawn.choice((0.0, float(drawn.randint(-720, 720)), drawn.uniform(-400, 400))),
            phases=dwells_for_room(made, data["laws"], room),
        )  # fmt: skip
        if axis["motor"] is not None:
            drive(axis, drawn, sizes["rotors"], sizes["positions"])
    if any(axis["motor"] is not None for axis in data["axes"]):
        draw(data["power"], PowerEntry, drawn)
        draw(data["limits"], Limits, drawn)
    if data["selection"]["axis"] is not None:
        data["selection"] |= {
            "axis": drawn.choice([axis["name"] for axis in data["axes"] if axis["motor"]]),
            "rank": drawn.choice(get_args(Rank)), "greatest_margin": 10 ** drawn.uniform(0, 6),
        }  # fmt: skip
    for clearance in data["clearances"]:
        draw(clearance, ClearanceEntry, drawn)
    for switch in data["switches"]:
        switch["on"] = times(drawn)
    for axis in data["axes"]:
        place(axis, drawn)
    if pace == "cycle":
        to_units(data, data["master"]["unit"], data["master"][pace])
    return data


def place(axis: dict[str, Any], drawn: random.Random) -> None:
    """Draw where an axis begins, but of what only reaches so far, and whether one without a drive is open."""
    begin = drawn.choice((0.0, drawn.uniform(-300, 300)))
    draw(axis["stops"] or {}, HardStops, drawn)
    axis["position"] = 0.0 if axis["motor"] and axis["mechanism"]["kind"] in LINKED else begin
    if axis["motor"] is None:
        axis["closes"] = drawn.choice(get_args(Closes))


def times(drawn: random.Random) -> list[dict[str, Any]]:
    """Return times of being on, the last of them at times across the end of the cycle; some are not entered."""
    edges = sorted(drawn.uniform(0, 360) for _ in range(2 * drawn.randint(0, TIMES)))
    if drawn.random() < 0.5:
        edges = [*edges[1:], *edges[:1]]
    found = [{"start": a, "stop": b} for a, b in zip(edges[::2], edges[1::2], strict=True)]
    if len(found) > 2 and drawn.random() < 0.5:
        found[1] = {"start": None, "stop": None}
    return found


def drive(axis: dict[str, Any], drawn: random.Random, room: int, positions: int) -> None:
    """Draw a drive of the same kind: loads that resist or drive, limits far off."""
    kind = axis["mechanism"]["kind"]
    travels = axis["unit"] == "mm" or kind in SLIDING
    axis["rate"] = drawn.choice((None, drawn.uniform(5, 600)))
    mechanism = axis["mechanism"]
    draw(mechanism, MECHANISMS[kind], drawn)
    if mechanism.get("belt_on_bed") is not None:
        mechanism["belt_on_bed"] = drawn.uniform(0, 1) * (mechanism["belt_mass"] or 0.0)
    if kind in LINKED:
        linked(axis, drawn, kind, positions)
    if kind in SLIDING:
        crank, share = drawn.uniform(5, 200), drawn.choice((0.0, drawn.uniform(-0.8, 0.8)))
        axis["mechanism"] |= {"crank_radius": crank, "rod_length": crank * drawn.uniform(1.9, 8),
                              "offset": crank * share or None, "start_angle": drawn.uniform(-400, 400)}  # fmt: skip
    load = axis["load"]
    draw(load, AxisLoad, drawn, lacking(travels, load["viscous"]))
    load["windows"] = []
    axis["parts"] = [
        {
            "name": f"part {i}", "count": float(drawn.randint(0, 5)), "shaft": drawn.choice(("motor", "mechanism")),
            **teeth(drawn), **drawn.choice((cylinder, inertia))(drawn),
        }
        for i in range(drawn.randint(0, room))
    ]  # fmt: skip
    for part, model in (("reducer", Reducer), ("motor", AxisMotor), ("limits", OwnLimits)):
        draw(axis[part], model, drawn)
    axis["reducer"]["name"] = axis["motor"]["name"] = ""
    for one in axis["stages"]:
        stage(one, drawn)


def stage(stage: dict[str, Any], drawn: random.Random) -> None:
    """Draw a stage by its ratio, or by teeth."""
    draw(stage, StageEntry, drawn)
    teeth = {"teeth_driver": float(drawn.randint(12, 99)), "teeth_driven": float(drawn.randint(12, 99))}
    by_ratio = {"ratio": drawn.uniform(0.2, 8)} | dict.fromkeys(teeth)
    stage |= drawn.choice((by_ratio, {"ratio": None} | teeth))


def inertia(drawn: random.Random) -> dict[str, float]:
    """Return the inertia of a part."""
    return {"inertia": drawn.uniform(0, 1000)}


def cylinder(drawn: random.Random) -> dict[str, float]:
    """Return the size of a part that is a cylinder, hollow or not."""
    size = {"diameter": drawn.uniform(10, 150), "length": drawn.uniform(0, 400), "density": drawn.uniform(900, 9000)}
    return size | drawn.choice(({}, {"bore": drawn.uniform(0, 0.99) * size["diameter"]}))


def teeth(drawn: random.Random) -> dict[str, float]:
    """Return the teeth of a gear that drives a part, or none."""
    made = {f"teeth_{side}": float(drawn.randint(12, 99)) for side in ("driver", "driven")}
    return made if drawn.random() < 0.6 else {}


def linked(axis: dict[str, Any], drawn: random.Random, kind: str, positions: int) -> None:
    """Draw a mechanism of a changing ratio, and positions that most of these reach."""
    size = drawn.uniform(20, 90)
    offset = drawn.choice((None, 0.0, drawn.uniform(-0.4, 0.4) * size))
    if kind == "table":
        steps = [drawn.uniform(0.9, 1.1) for _ in range(drawn.randint(2, positions) - 1)]
        share = size / sum(steps)
        places = [share * sum(steps[:j]) for j in range(len(steps) + 1)]
        low, high = 0.0, size
        axis["mechanism"]["points"] = [{"angle": 30.0 * j, "position": y} for j, y in enumerate(places)]
    elif kind == "rocker":
        low, high = -0.2 * size, 0.3 * size
        axis["mechanism"] |= {
            "lever_length": size, "link_length": drawn.uniform(1.8, 5) * size, "offset": drawn.uniform(0.6, 1.2) * size,
            "start_angle": drawn.uniform(60, 120), "slide": drawn.choice((None, "ahead", "behind")),
            "direction": drawn.choice((None, "forward", "backward")),
        }  # fmt: skip
    elif kind == "crank-slider":
        low, high = 0.0, drawn.uniform(0.2, 1.4) * size
        axis["mechanism"] |= {
            "crank_radius": size, "rod_length": drawn.uniform(2.2, 6) * size, "offset": offset,
            "start": drawn.uniform(0.2, 0.4) * size, "zero": drawn.choice((None, "inner", "outer")),
            "branch": drawn.choice((None, "ahead", "behind")),
        }  # fmt: skip
    else:
        other, low, high = LINKAGES[kind].varied(drawn.randrange(20), drawn.randrange(6), positions)
        axis["mechanism"] |= other
    at = 0.0
    for phase in axis["phases"]:
        if phase["lift"]:
            goal = drawn.uniform(low, high)
            phase["lift"], at = goal - at, goal


def phases(drawn: random.Random, room: int, laws: Sequence[str]) -> list[dict[str, Any]]:
    """Return phases in order, with and without rests between them."""
    made: list[dict[str, Any]] = []
    count = drawn.randint(1, room)
    widths = shares(drawn, count + count + 1)
    reached = 0.0
    for rest, width in zip(widths[::2], widths[1::2], strict=False):
        start = reached + (rest * 360 if drawn.random() < 0.5 else 0.0)
        reached = start + width * 360
        law = drawn.choice((*laws, "DWL"))
        lift = 0.0 if law == "DWL" else drawn.choice((0.0, drawn.uniform(-200, 200), drawn.uniform(-200, 200)))
        made.append({"start": start, "stop": reached, "lift": lift, "law": law})
    if drawn.random() < 0.3:
        made[-1]["stop"] = 360.0
    return made
