"""Random drives of a changing ratio: cells against the engine, mirrored, and of another size.

Beside each the same mirrored, and one whose lengths are k times as long under a load that does the same work: their
motors must do the same, by cells that have other entries, other positions and other ratios.
"""

import math
import random

import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE
from tests.workbook.machines.test_machine_linked import CRANK, ROCKER, TABLE, linked, small
from tests.workbook.machines.test_random_machines import SAME, G, names_the_slowest, valid, window

KINDS = {"crank-slider": CRANK, "rocker": ROCKER, "table": TABLE}
LENGTHS = {"crank_radius", "rod_length", "start", "lever_length", "link_length", "offset"}
OTHER = {"inner": "outer", "outer": "inner", "ahead": "behind", "behind": "ahead", "forward": "backward",
         "backward": "forward"}  # fmt: skip


def drawn_axis(drawn, kind, viscous):
    """A machine of one such drive with process forces, and its axis."""
    load = {"mass": 12.0, "viscous": 50.0 if viscous else None}
    data = drawn_machine(small(linked(mechanism=KINDS[kind], load=load), cycle=12, positions=6), drawn).model_dump()
    axis = data["axes"][0] | {"rate": None}
    windows = [window(drawn) for _ in range(drawn.randint(0, 2))]
    for one in windows:
        one["force"] = abs(one["force"]) if one["resists"] == "moving" else one["force"]
    return data, axis | {"load": axis["load"] | {"windows": windows}}


def stroke(mechanism):
    """From dead centre to dead centre of a crank (mm)."""
    r, rod, e = (mechanism[name] or 0.0 for name in ("crank_radius", "rod_length", "offset"))
    return math.sqrt((rod + r) ** 2 - e**2) - math.sqrt((rod - r) ** 2 - e**2)


def turned_round(mechanism):
    """The same mechanism seen from the other side, its positions counted the other way."""
    kind = mechanism["kind"]
    if kind == "table":
        points = [{name: -value for name, value in one.items()} for one in reversed(mechanism["points"])]
        return mechanism | {"points": points}
    offset = -(mechanism["offset"] or 0.0)
    if kind == "rocker":
        return mechanism | {"offset": offset, "start_angle": -mechanism["start_angle"],
                            "direction": OTHER[mechanism["direction"] or "forward"]}  # fmt: skip
    zero, branch = OTHER[mechanism["zero"] or "inner"], OTHER[mechanism["branch"] or "ahead"]
    start = stroke(mechanism) - mechanism["start"]
    return mechanism | {"offset": offset, "zero": zero, "branch": branch, "start": start}


def mirrored(axis):
    """The same with motion, mechanism and loads the other way."""
    load = axis["load"]
    windows = [w | ({"force": -w["force"]} if w["resists"] == "always" else {}) for w in load["windows"]]
    turned = {"force": -load["force"], "slope": -load["slope"], "windows": windows}
    phases = [phase | {"lift": -phase["lift"]} for phase in axis["phases"]]
    return axis | {"name": "Mirrored", "phases": phases, "load": load | turned,
                   "mechanism": turned_round(axis["mechanism"])}  # fmt: skip


def scaled(axis, k):
    """The same k times as long, level, under forces that do the same work on its way."""
    load, mechanism = axis["load"], dict(axis["mechanism"])
    for name in mechanism.keys() & LENGTHS:
        mechanism[name] = None if mechanism[name] is None else k * mechanism[name]
    if "points" in mechanism:
        mechanism["points"] = [one | {"position": k * one["position"]} for one in mechanism["points"]]
    weight, slope = load["mass"] * G, math.radians(load["slope"])
    forces = {"mass": load["mass"] / k**2, "friction": load["friction"] * k * math.cos(slope), "slope": 0.0,
              "force": (load["force"] + weight * math.sin(slope)) / k,
              "viscous": None if load["viscous"] is None else load["viscous"] / k**2}  # fmt: skip
    windows = [one | {"force": one["force"] / k} for one in load["windows"]]
    phases = [phase | {"lift": k * phase["lift"]} for phase in axis["phases"]]
    return axis | {"name": "Scaled", "phases": phases, "mechanism": mechanism,
                   "load": load | forces | {"windows": windows}}  # fmt: skip


def examined(drawn, kind):
    """Hold the cells of a drive against the engine, and against those of the same mirrored and scaled."""
    data, axis = drawn_axis(drawn, kind, drawn.random() < 0.3)
    made = valid(data | {"axes": [axis, mirrored(axis), scaled(axis, drawn.uniform(0.3, 0.95))]})
    wrong, _ = disagreeing(TEMPLATE, made)
    assert [cell for cell in wrong if not names_the_slowest(cell)] == []
    value = computed(TEMPLATE, made)
    peak = max(value("drive1_tmax"), -value("drive1_tmin"), 1e-9)
    powerful = peak * value("drive1_speed")
    for name in (name for name in SAME if name != "highest"):
        size = powerful if name in ("pmax", "pmin", "power", "energy", "returned") else 0.0
        first, *others = (value(f"drive{k}_{name}") for k in (1, 2, 3))
        assert others == pytest.approx([first, first], rel=1e-8, abs=1e-9 * max(size, abs(first))), name
    first, *others = (value(f"drive{k}_highest") for k in (1, 2, 3))
    assert others == ([first, first] if isinstance(first, str) else pytest.approx([first, first], rel=1e-8))
    ends = [(value(f"drive{k}_tmax"), value(f"drive{k}_tmin")) for k in (1, 2, 3)]
    assert (-ends[1][1], -ends[1][0]) == pytest.approx(ends[0], rel=1e-8, abs=1e-9 * peak)
    assert ends[2] == pytest.approx(ends[0], rel=1e-8, abs=1e-9 * peak)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.sample(1)
def test_mirrored_and_scaled_it_asks_the_same_of_its_motor(kind):
    examined(random.Random(f"drive of a changing ratio: {kind}"), kind)


@pytest.mark.parametrize("number", nights(8))
def test_random_drives_of_a_changing_ratio(number):
    drawn = random.Random(seed(f"linked {number}"))
    examined(drawn, drawn.choice(list(KINDS)))
