"""Variations of a flying cutter: every law, drum and saw, each case, each limit exceeded."""

from collections.abc import Iterator
from math import pi, radians
from typing import Any

from workbook.laws.variations import RISING, SIX, factors, law_for, own_in, single_humped, variations, vary_laws
from workbook.machines.flying.entries import DRUM, FlyingCutter
from workbook.motion.asked import smoothness_for
from workbook.selection.variations import vary_selection


def variants(machine: FlyingCutter) -> list[FlyingCutter]:
    """Return six machines of the same layout: every law, drum and saw, each case, each limit exceeded."""
    return [FlyingCutter.model_validate(data) for data in variations(machine, varied, single_humped)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k = turn % SIX
    entries, scale = data["cutter"], factors(k)
    vary_laws(data["laws"], k, scale, data["sizes"]["pieces"])
    law = law_for(turn + 4, single_humped(data["laws"]))
    if law in own_in(data["laws"]):
        data["laws"][law]["pieces"] = RISING
    drum, saw, load = entries["drum"], entries["saw"], entries["load"]
    drum |= {"tools": 1.0 + k, "radius": 90.0 + 17 * k, "tool_angle": (47.0, 0.0, 31.0, 22.0, 29.0, 17.0)[k]}
    saw |= {"tool_length": 210.0 + 40 * k, "lead": 25.0 + 6 * k, "stroke": (60.0, 2000.0)[k % 2] * next(scale)}
    load |= {"inertia": 100.0 * next(scale), "mass": 3.0 * k, "torque": (0.0, 2.5, -1.5, 0.0, 4.0, 0.7)[k]}
    entries["limits"] = limits(k, scale)
    entries["line_speed"] = 35.0 + 21 * k
    entries |= product(entries, k) | {"law": law, "smoothness": smoothness_for(turn)}
    vary_selection(data["selection"], k, data["sizes"])
    return data


def limits(k: int, scale: Iterator[float]) -> dict[str, float]:
    """Return limits of the shaft that are kept or not, each in turn."""
    return {"speed": (1e5, 3.0)[k % 2] * next(scale), "acceleration": (1e6, 1e6, 2.0)[k % 3] * next(scale)}


def product(entries: dict[str, Any], k: int) -> dict[str, Any]:
    """Return kind of machine, product and strategy: shorter, longer, far too long, exactly the design length."""
    kind = "saw" if k == 2 else DRUM
    drum, saw = entries["drum"], entries["saw"]
    if kind == DRUM:
        whole = 2 * pi * drum["radius"] / drum["tools"]
        least = radians(drum["tool_angle"]) * drum["radius"]
    else:
        whole, least = 3.0 * saw["tool_length"], saw["tool_length"]
    share = (0.7, 9.0, 1.0, 1.0, 8.0, 1.7)[k]
    return {
        "kind": kind,
        "product_length": least + share * (whole - least) if share != 1.0 else whole,
        "beyond": ("standstill", "standstill", "reversal", "reversal", "reversal", "standstill")[k],
        "lengths": {"shortest": least + 0.3 * (whole - least), "longest": least + (4.0 + 2 * k) * (whole - least)},
    }
