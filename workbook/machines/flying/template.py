"""Flying machining (S5): a rotary drum or a flying saw that follows the line while it works."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

from engine.choice import LoadSamples, Task
from workbook.book.about import about_sheet
from workbook.book.declare import Book, result
from workbook.entries.machine import Machine
from workbook.entries.units import RPM
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.laws.variations import SIX, factors, law_for, variations, vary_laws
from workbook.machines.flying.cycle import cycle_sheet
from workbook.machines.flying.entries import DRUM, FlyingCutter
from workbook.machines.flying.lengths import lengths_sheet
from workbook.machines.flying.sheet import cutter_sheet
from workbook.machines.flying.turning import turning_sheet
from workbook.machines.flying.view import Flying
from workbook.selection.load import LoadCells
from workbook.selection.sheet import selection_sheet
from workbook.selection.variations import vary_selection
from workbook.selection.view import Choosing
from workbook.template import Template, finish

RISING = [
    {"duration": 0.4, "c0": 5.0},
    {"duration": 0.6, "c0": -10 / 3},
]
"""An own law that speeds up once: for less time than it slows down."""

LOAD = LoadCells(
    time="[cycle.t]",
    speed="[cycle.w]",
    acceleration="[cycle.dw]",
    torque="[cycle.torque]",
    acceleration_rms="fly_dw_rms",
    torque_rms="fly_torque_rms",
    power_rate_mean="fly_mean",
    max_speed="fly_w_max",
)
"""Where the book has the load at the shaft of the drum or the slide."""


def declare(machine: Machine) -> Book:
    """Declare the book."""
    given = cast(FlyingCutter, machine)
    shelf = LawShelf(given.laws, given.sizes)
    view = Flying(given, shelf.laws)
    book = Book(given.template, given.title)
    cut, scale = view.cut, view.scales
    fastest, dw, beta = cut.max_angular_speed / RPM, cut.max_angular_acceleration, view.asked(cut).factor
    about_sheet(
        book,
        "A tool that follows the line while it works: the motion of its drum or slide, and what its drive must give.",
        [
            result("about_rate", "Products", "", "1/min", "=fly_rate", 60 / cut.cycle_time),
            result("about_n", "Highest speed of the shaft, either way", "n", "rpm", "=fly_w_max*60/(2*PI())", fastest),
            result("about_dw", "Peak acceleration of the shaft", "ω̇_max", "rad/s²", "=fly_dw", dw, scale=scale["dw"]),
            result("about_beta", "Load factor", "β", "W/s", "=fly_beta", beta, scale=scale["beta"]),
        ],
    )
    cutter_sheet(book, view)
    lengths_sheet(book, view)
    cycle_sheet(book, view, shelf.stack)
    selection_sheet(book, LOAD, choosing(view, given))
    turning_sheet(book, view, shelf.stack)
    shelf.sheets(book)
    return finish(book, "Flying machining", ("S5", "S1", "S3"))


def variants(machine: Machine) -> list[Machine]:
    """Return six machines of the same layout: every law, drum and saw, each case, each limit exceeded."""
    return [FlyingCutter.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k = turn % SIX
    entries, scale = data["cutter"], factors(k)
    vary_laws(data["laws"], k, scale, data["sizes"]["pieces"])
    law = law_for(turn + 4)
    if law == "OWN":
        data["laws"]["OWN"]["pieces"] = RISING
    drum, saw, load = entries["drum"], entries["saw"], entries["load"]
    drum |= {"tools": 1.0 + k, "radius": 90.0 + 17 * k, "tool_angle": (47.0, 0.0, 31.0, 22.0, 29.0, 17.0)[k]}
    saw |= {"tool_length": 210.0 + 40 * k, "lead": 25.0 + 6 * k, "stroke": (60.0, 2000.0)[k % 2] * next(scale)}
    load |= {"inertia": 0.01 * next(scale), "mass": 3.0 * k, "torque": (0.0, 2.5, -1.5, 0.0, 4.0, 0.7)[k]}
    entries["limits"] = limits(k, scale)
    entries["line_speed"] = 35.0 + 21 * k
    entries |= product(entries, k) | {"law": law}
    vary_selection(data["selection"], k, data["sizes"])
    return data


def limits(k: int, scale: Iterator[float]) -> dict[str, float]:
    """Return limits of the shaft that are kept or not, each in turn."""
    return {
        "speed": (1e5, 3.0)[k % 2] * next(scale),
        "acceleration": (1e6, 1e6, 2.0)[k % 3] * next(scale),
    }


def product(entries: dict[str, Any], k: int) -> dict[str, Any]:
    """Return kind of machine, product and strategy: shorter, longer, far too long, exactly the design length."""
    kind = "saw" if k == 2 else DRUM
    drum, saw = entries["drum"], entries["saw"]
    if kind == DRUM:
        whole = 2 * 3.141592653589793 * drum["radius"] / drum["tools"]
        least = drum["tool_angle"] * 3.141592653589793 / 180 * drum["radius"]
    else:
        whole, least = 3.0 * saw["tool_length"], saw["tool_length"]
    share = (0.7, 9.0, 1.0, 1.0, 8.0, 1.7)[k]
    return {
        "kind": kind,
        "product_length": least + share * (whole - least) if share != 1.0 else whole,
        "beyond": ("standstill", "standstill", "reversal", "reversal", "reversal", "standstill")[k],
        "lengths": {"shortest": least + 0.3 * (whole - least), "longest": least + (4.0 + 2 * k) * (whole - least)},
    }


def choosing(view: Flying, given: FlyingCutter) -> Choosing:
    """Return the choice of motor and reducer for the load at the tool's shaft."""
    at, r, load, asked = view.samples, view.tool.radius, view.load, view.asked(view.cut)
    dw = at.acceleration / r
    samples = LoadSamples(view.times, at.speed / r, dw, load.torque + load.inertia * dw)
    need = Task.of_figures(asked.acceleration, asked.torque, asked.mean, view.cut.max_angular_speed)
    return Choosing(given.selection, given.sizes, need, samples)


TEMPLATE = Template(
    "flying-cutter",
    FlyingCutter,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("cycle", 1), "lengths": ("lengths", 1)}
    | {"motors": ("motors", 0), "reducers": ("reducers", 0)},
)
