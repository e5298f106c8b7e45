"""The single changes of a machine that may make it faster: of laws, edges, motor, reducer, inertia and reserves."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from engine.drive.backlash import Backlash
from engine.drive.rate_range import Moment
from workbook.book.checks import ZERO
from workbook.book.quantity import OK
from workbook.book.sentence import figure
from workbook.fields.paths import Place
from workbook.fields.units import DEGREE, KW, MS, shown, si
from workbook.improving import Aim, Change, Figure
from workbook.law_sheets.library import laws
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.drive.in_use import motor_in_use, reducer_in_use
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.entries_beside import Vibration
from workbook.machines.machine.exact import drives_of
from workbook.machines.machine.first_sheet import RATE_CHECK
from workbook.machines.machine.studies import shaping, timing
from workbook.machines.machine.studies.results import results
from workbook.machines.machine.vibration import Swing
from workbook.machines.machine.view import moving_axes
from workbook.template_outputs import LIMITS

LIGHTER = 0.9  # of the inertias of load and parts
RESERVES = {"rms_reserve": "RMS torque", "peak_reserve": "peak torque", "speed_reserve": "speed"}
NEAR = 1e-9  # of a torque or a ratio: those that differ by less are the same


def where(machine: AnyMachine, name: str, moment: Moment) -> str:
    """Return in words where a limit of an axis is used most: its phase, and the share or the place there."""
    driven = shaping.drives(machine)[name]()
    over, axis = machine.over, driven.axis
    at = f"{figure(round(over.shown(shown(moment.x, DEGREE)), 2))}{over.after}"
    if moment.phase not in axis.entered:
        return f"rest at {at}"
    phase = f"phase {axis.entered.index(moment.phase) + 1}"
    if moment.share == 1.0:
        return f"{phase}, at {at}"
    return f"{phase}, {100.0 * moment.share:.0f} % of it"


def crossings(machine: AnyMachine) -> Iterator[str]:
    """Yield in words each moment at which a load crosses its backlash, and how it strikes; why none is known."""
    for name, driven in ((name, make()) for name, make in shaping.drives(machine).items()):
        entered, unit = driven.entered.backlash, driven.entered.unit
        if entered is None:
            continue
        begin = f"{name}: its load crosses the backlash of {figure(entered.gap)} {unit}"
        try:
            for x, phase, time, shock in Backlash(driven.drive_cycle, si(entered.gap, driven.axis.unit)).crossings:
                back = ", back on its side" if shock < 0.0 else ""
                speed = f"{shown(abs(shock), driven.axis.unit):.4g} {unit}/s{back}"
                struck = f"strikes after {shown(time, MS):.4g} ms with {speed}" if time < math.inf else "floats"
                yield f"{begin} ({where(machine, name, Moment(phase, x, 1.0))}), {struck}"
        except ValueError as error:
            yield f"{begin}: {error}"


def changes(machine: AnyMachine, name: str, rate: float, aim: Aim) -> Iterator[Change]:
    """Yield the single changes of an axis: laws shaped for a rate (1/s) among them."""
    i = timing.axis_of(machine, name, "edges")
    yield from shaping.law_changes(machine, i, rate, aim)
    yield from edge_changes(machine, i)
    if machine.axes[i].motor:
        yield from product_changes(machine, i)
        yield from lighter(machine.axes[i], i)
        yield from balanced(machine, i)
    if aim.is_rate:
        yield from reserve_changes(machine, i)


def edge_changes(machine: AnyMachine, i: int) -> Iterator[Change]:
    """Yield each edge that may move moved by 10° of a turn, or as far as its room lets it."""
    step = machine.over.shown(timing.EDGE)
    for room in timing.rooms(machine, machine, machine.axes[i].name):
        for by in (-step, step):
            if moved := min(max(by, room.low), room.high):
                yield room.change(moved)


def product_changes(machine: AnyMachine, i: int) -> Iterator[Change]:
    """Yield the next motor up and down by the rated torque, and other ratios, of the catalogues."""
    axis = machine.axes[i]
    products = machine.selection
    limits = machine.limits.of_axis(machine.axes[i].limits)
    motor, reducer = motor_in_use(axis, products, limits), reducer_in_use(axis, products, limits)
    rated = motor.rated_torque * limits.rms_reserve
    rows = sorted(products.motors, key=lambda row: row.rated_torque)
    above = [row for row in rows if row.rated_torque > rated * (1.0 + NEAR)][:1]
    below = [row for row in rows if row.rated_torque < rated * (1.0 - NEAR)][-1:]
    for row in filter(lambda row: fits(row.shaft or 0.0, reducer.hub), (*above, *below)):
        way = "up" if row in above else "down"
        yield Change(
            f"{axis.name}: next motor {way}, {row.name}", {("axes", str(i), "motor", "name"): row.name}, "product"
        )
    for other in products.reducers:
        if abs(other.reduction - reducer.ratio) > NEAR and fits(motor.shaft, other.hub or 0.0):
            words = f"{axis.name}: ratio {figure(reducer.ratio)} → {figure(other.reduction)}, {other.name}"
            yield Change(words, {("axes", str(i), "reducer", "name"): other.name}, "product")


def fits(shaft: float, hub: float) -> bool:
    """Return whether a motor's shaft fits a reducer's hub (mm); 0 of either is not told, and fits."""
    return not hub or shaft <= hub


def lighter(axis: Axis, i: int) -> Iterator[Change]:
    """Yield load and parts with 10 % less inertia."""
    entries: dict[Place, Any] = {}
    for name in ("mass", "inertia"):
        if getattr(axis.load, name):
            entries["axes", str(i), "load", name] = LIGHTER * getattr(axis.load, name)
    for k, part in enumerate(axis.parts):
        name = "density" if part.inertia is None else "inertia"
        if getattr(part, name):
            entries["axes", str(i), "parts", str(k), name] = LIGHTER * getattr(part, name)
    if entries:
        yield Change(f"{axis.name}: load and parts with 10 % less inertia", entries, "other")


def balanced(machine: AnyMachine, i: int) -> Iterator[Change]:
    """Yield the weight of a load on a slope held by a spring of constant force, and by a counterweight as heavy.

    That of a load that rubs on a slope would rub too as an entry of its mass, so only a spring holds it.
    """
    axis, path = machine.axes[i], ("axes", str(i), "load")
    load, slope = axis.load, si(axis.load.slope, DEGREE)
    weight = load.mass * machine.gravity * math.sin(slope)
    if abs(weight) < NEAR:
        return
    begin = f"{axis.name}: weight of {figure(load.mass)} kg held by"
    yield Change(f"{begin} a spring of {abs(weight):.4g} N", {(*path, "force"): load.force - weight}, "other")
    if not load.friction or math.cos(slope) < NEAR:
        share = 1.0 + abs(math.sin(slope))
        moved: dict[Place, Any] = {(*path, "mass"): share * load.mass, (*path, "force"): load.force - share * weight}
        yield Change(f"{begin} a counterweight", moved, "other")


def reserve_changes(machine: AnyMachine, i: int) -> Iterator[Change]:
    """Yield each reserve of an axis that is above 1 lowered by 0.1, or to 1."""
    axis, limits = machine.axes[i], machine.limits.of_axis(machine.axes[i].limits)
    for name, words in RESERVES.items():
        held = getattr(limits, name)
        lower = max(1.0, round(held - 0.1, 9))
        if lower < held:
            sentence = f"{axis.name}: reserve of {words} {figure(held)} → {figure(lower)}"
            yield Change(sentence, {("axes", str(i), "limits", name): lower}, "other")


# names of checks of limits, behind the drive's
BY_RATE = tuple(check for check, _ in LIMITS.values())


def breaks(machine: AnyMachine) -> set[str]:
    """Return the names of the checks, but for limits of drives at the rate, that do not hold."""
    asked = results(machine, {})
    names = (name for name in asked.checks if not name.endswith(BY_RATE) and name not in (RATE_CHECK, *asked.slow))
    broken = {name for name in names if not np.all(asked.named[name]() == OK)}
    return broken | {name for margin, name in timing.order_margins(machine) if margin < -ZERO}


def figure_of(machine: AnyMachine, name: str, aim: Aim) -> Figure:
    """Return the figure of an axis that is to be less, at the rate of the machine."""
    axis = moving_axes(machine, laws(machine.laws))[timing.axis_of(machine, name, "edges")].sized
    if aim.name == "acceleration":
        return Figure(axis.max_acceleration, axis.over.rates(axis.given.unit)[1])
    if aim.name == "vibration":
        (row,) = (row for row in axes_of(machine) if row.axis.given.name == name)
        described = None if aim.frequency else row.axis.typed.vibration
        load = described or Vibration(frequency=aim.frequency, damping=aim.damping)
        swing = Swing(row, load)  # in RMS, so that of moves that leave alike each counts
        left = swing.exact[swing.lift > 0.0]
        return Figure(float(np.sqrt(np.mean(left**2))) if left.size else 0.0, axis.given.unit)
    results = shaping.drives(machine)[name]().limit_checks.results
    if aim.name == "power":
        return Figure(shown(results.power.peak, KW), aim.unit)
    return Figure(results.energy.driving if aim.name == "energy" else results.rms_torque, aim.unit)


def sheet_rate(machine: AnyMachine) -> float:
    """Return the highest rate (cycles/min) that the sheets of all drives state, infinite where none is bound."""
    common = (view.rates.high for view in drives_of(machine) if view.driven.entered.rate is None)
    return min((rate for rate in common if isinstance(rate, float)), default=math.inf)
