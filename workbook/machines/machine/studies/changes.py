"""The single changes of a machine that may make it faster: of laws, edges, motor, reducer, inertia and reserves."""

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import count
from typing import Any

import numpy as np

from engine.drive.backlash import Backlash
from engine.drive.highest_rate import Moment
from engine.drive.limits import at_speed
from engine.drive.rate_range import at_points
from engine.drive.shaped import shape_phase
from engine.laws import Law
from engine.laws.base import Kinematics
from engine.laws.vibration import Shaper
from workbook.book.checks import ZERO
from workbook.book.quantity import OK
from workbook.book.sentence import figure
from workbook.errors import InputError
from workbook.fields.paths import Place, key_of
from workbook.fields.units import DEGREE, KW, MS, PER_MINUTE, shown, si
from workbook.improving import Aim, Change, Figure
from workbook.law_sheets.library import NamedLaw, laws, named_laws
from workbook.laws.entries import ENTRIES, Laws, listed, references
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.in_use import motor_in_use, reducer_in_use
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.entries_beside import Vibration
from workbook.machines.machine.exact import axes_of, drives_of
from workbook.machines.machine.rates_summary import RATE_CHECK
from workbook.machines.machine.studies import timing
from workbook.machines.machine.studies.results import results
from workbook.machines.machine.vibration import Swing
from workbook.machines.machine.view import MachineView
from workbook.template_outputs import LIMITS

FREE = ("LIN", "OWN", "SPL")  # families without a law of their own from rest to rest
LIGHTER = 0.9  # of the inertias of load and parts
# by what must not jump: the highest derivative that is 0 at ends
RESTS = {"velocity": 1, "acceleration": 2, "jerk": 3}
RESERVES = {"rms_reserve": "RMS torque", "peak_reserve": "peak torque", "speed_reserve": "speed"}
SHAPED = "Shaped"  # begins the name of a new law that is shaped for its drive
# aims for which laws are shaped, all but the rate by least torque
TORQUE_OR_RATE = ("torque", "rate")
SHAPED_FOR = ("rate", "torque", "power", "energy")
PIECES = 8  # of a law that is shaped for its drive, at most
MOST_PIECES = 60  # of an own law
NEAR = 1e-9  # of the rise: ends of laws that differ by less are the same


def drives(machine: AnyMachine) -> dict[str, Any]:
    """Return functions that make the drives of a machine with their limits, by the names of their axes."""
    view = MachineView(machine, laws(machine.laws))
    return {axis.given.name: partial(Driven, axis, machine) for axis in view.axes if axis.given.motor}


def limit_checks(machine: AnyMachine) -> dict[str, Any]:
    """Return functions that give the limits of the drives of a machine, by the names of their axes."""
    return {name: partial(lambda make: make().limit_checks, make) for name, make in drives(machine).items()}


def where(machine: AnyMachine, name: str, moment: Moment) -> str:
    """Return in words where a limit of an axis is used most: its phase, and the share or the place there."""
    driven = drives(machine)[name]()
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
    for name, driven in ((name, make()) for name, make in drives(machine).items()):
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
    i = timing.number_of(machine, name)
    yield from law_changes(machine, i, rate, aim)
    yield from edge_changes(machine, i)
    if machine.axes[i].motor:
        yield from product_changes(machine, i)
        yield from lighter(machine.axes[i], i)
    if aim.is_rate:
        yield from reserve_changes(machine, i)


def law_changes(machine: AnyMachine, i: int, rate: float, aim: Aim) -> Iterator[Change]:
    """Yield another law for each phase of an axis that moves from rest to rest, of all families; shaped ones too."""
    axis = machine.axes[i]
    known = {each.name: each for each in from_rest_to_rest(machine)}
    driven = drives(machine)[axis.name]() if axis.motor and aim.name in SHAPED_FOR else None
    for k, phase in enumerate(axis.phases):
        if not phase.lift or passes(axis, k) or phase.law not in known:
            continue
        path = ("axes", str(i), "phases", str(k), "law")
        begin = f"{axis.name} phase {k + 1}: {known[phase.law].words}"
        if driven:
            with suppress(ValueError, ArithmeticError):  # too few pieces, or what the engine refuses
                yield shaped(machine, driven, rate, k, begin, free_name(machine, i, k), TORQUE_OR_RATE[aim.is_rate])
        yield from shapers(machine, i, k, begin) if aim.name == "vibration" else ()
        for law in known.values():
            if law.name != phase.law and not is_shaped(law.entered):  # for another phase
                new: dict[Place, Any] = {} if law.name in machine.laws.names else {("laws", law.name): {}}
                yield Change(f"{begin} → {law.words}", new | {path: law.name}, "law")


def from_rest_to_rest(machine: AnyMachine) -> Iterator[NamedLaw]:
    """Yield the laws of a machine, and those of all families, that rise from rest to rest."""
    codes = [code for code in ENTRIES if code not in (*machine.laws.names, *FREE)]
    more = named_laws(Laws.model_validate({code: {} for code in codes}))
    for law in (*named_laws(machine.laws), *(law for law in more if law.name in codes)):
        ends: Sequence[Kinematics[float]] = law.law.start, law.law.end
        if (
            abs(ends[1].s - 1.0) < NEAR
            and max(abs(end.v) for end in ends) < NEAR
            and (not law.basic or law.name != "OWN")
        ):
            yield law


def is_shaped(entered: Any) -> bool:
    """Return whether a law is shaped for the drive or the load of a phase."""
    return bool(getattr(entered, "shaped", None) or getattr(entered, "shaper", None))


def free_name(machine: AnyMachine, i: int, k: int) -> str:
    """Return a name for a law that is shaped for a phase; that of the law that it has, if no other phase takes that."""
    begin, own = f"{SHAPED} {i + 1}-{k + 1}", machine.axes[i].phases[k].law
    users = [reference.name for reference in references(machine)].count(own)
    if getattr(machine.laws[own], "shaped", None) and users == 1:
        return own
    return next(name for n in count(1) if (name := f"{begin} {n}") not in machine.laws.names)


def shaped(machine: AnyMachine, driven: Driven, rate: float, k: int, begin: str, name: str, aim: str) -> Change:
    """Return the change of a phase to a law that is shaped for its drive at a rate, frozen into its pieces."""
    axis, least_torque, most = driven.axis, aim == "torque", min(PIECES, machine.sizes.pieces)
    rest, checks = RESTS[axis.given.smoothness], at_speed(driven.limit_checks, rate * math.tau)
    jerk = getattr(machine.laws[axis.given.phases[k].law], "max_jerk", None)
    law = shape_phase(checks, axis.motion, axis.entered[k], 5, rest, most, least_torque, jerk or math.inf).law
    words = f"Shaped for its drive at {shown(1.0 / checks.drive_cycle.time, PER_MINUTE):.1f} cycles/min"
    own = frozen(law, words) | {"shaped": aim} | ({"max_jerk": jerk} if jerk else {})
    path = ("axes", str(axis.number - 1), "phases", str(k), "law")
    return Change(f"{begin} → shaped for its drive", {("laws", name): own, path: name}, "law")


def frozen(law: Law, words: str) -> dict[str, Any]:
    """Return the entries of an own law of a name with the pieces of another, of cubics."""
    pieces = [{"duration": piece.duration} | {f"c{n}": c for n, c in enumerate(piece.c)} for piece in law.as_pieces()]
    return {"family": "OWN", "name": words, "pieces": pieces}


def shapers(machine: AnyMachine, i: int, k: int, begin: str) -> Iterator[Change]:
    """Yield the law of a phase given out by each input shaper that its time and its load allow."""
    law = machine.axes[i].phases[k].law
    of = getattr(machine.laws[law], "of", None) or law
    for kind in Shaper.KINDS if is_fit(machine.axes[i], k, "vibration") else ():
        with suppress(ValueError):
            yield given_out(machine, i, k, begin, f"{kind} {i + 1}-{k + 1}", kind, of)


def given_out(machine: AnyMachine, i: int, k: int, begin: str, name: str, kind: str, of: str) -> Change:
    """Return the change of a phase to a law given out by an input shaper for the load of its axis, in its pieces.

    Raises ValueError for a load or a time that the shaper does not suit, InputError for a law that it cannot give out.
    """
    view = MachineView(machine, laws(machine.laws)).axes[i].sized
    load, known = view.given.vibration or Vibration(), {law.name: law for law in from_rest_to_rest(machine)}
    base = known.get(listed(of, [*known]) or "")
    if base is None or getattr(base.entered, "shaper", None):
        raise InputError([f"laws.{key_of(name)}.of: found {of!r}; expected a law from rest to rest, without a shaper"])
    time = view.motion.phases[view.entered[k]].duration / view.speed
    shaper, natural = Shaper(kind, load.damping), load.natural(view.given.unit)
    law = shaper.law(base.law, time * natural, MOST_PIECES)
    rate = shown(view.speed / math.tau, PER_MINUTE)
    own = frozen(law, f"{kind} of {base.name}, {figure(natural)} Hz at {rate:.1f} cycles/min")
    entries: dict[Place, Any] = {("laws", name): own | {"shaper": kind, "of": base.name}}
    if (count := len(own["pieces"])) > machine.sizes.pieces:
        entries["sizes", "pieces"] = count
    entries["axes", str(i), "phases", str(k), "law"] = name
    costs = f"{shown(shaper.time / natural, MS):.4g} of {shown(time, MS):.4g} ms"
    return Change(f"{begin} → {kind} of {base.name}, which costs {costs}", entries, "law")


def reshaped(machine: AnyMachine, name: str) -> tuple[str, Change]:
    """Return the axis whose drive or load a law is shaped for, and the change that shapes it anew.

    That is at the rate or the highest. Raises InputError unless the law is that of a single phase that moves from rest
    to rest, with a drive; with a natural frequency where a shaper gives it out.
    """
    entered = machine.laws[name]
    needed, key = ("vibration", "shaper") if entered.shaper else ("drive", "shaped")
    phases = [(i, k) for i, axis in enumerate(machine.axes) for k, phase in enumerate(axis.phases) if phase.law == name]
    fitting = [(i, k) for i, k in phases if is_fit(machine.axes[i], k, needed)]
    if len(phases) != 1 or not fitting:
        problem = f"{len(phases)} phases have this law, {len(fitting)} of them between two rests with a {needed}"
        expected = f"expected a single phase, between two rests with a {needed}"
        raise InputError([f"laws.{key_of(name)}.{key}: {problem}; {expected}"])
    ((i, k),) = fitting
    axis, begin = machine.axes[i].name, f"{machine.axes[i].name} phase {k + 1}"
    if entered.shaper:
        return axis, given_out(machine, i, k, begin, name, entered.shaper, entered.of)
    driven, aim = drives(machine)[axis](), entered.shaped
    high = at_points(driven.limit_checks).range.high if aim == "rate" else 0.0
    rate = high if 0.0 < high < math.inf else si(machine.per_minute, PER_MINUTE)
    return axis, shaped(machine, driven, rate, k, begin, name, aim)


def is_fit(axis: Axis, k: int, needed: str) -> bool:
    """Return whether a phase of an axis moves from rest to rest, with a drive or with the vibration of its load."""
    has = axis.motor if needed == "drive" else axis.vibration and axis.vibration.natural(axis.unit)
    return bool(has and axis.phases[k].lift and not passes(axis, k))


def passes(axis: Axis, k: int) -> bool:
    """Return whether a phase of an axis begins or ends at speed."""
    return bool(axis.phases[k].passes or axis.phases[(k + 1) % len(axis.phases)].passes)


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
    axis = MachineView(machine, laws(machine.laws)).axes[timing.number_of(machine, name)].sized
    if aim.name == "acceleration":
        return Figure(axis.max_acceleration, axis.over.rates(axis.given.unit)[1])
    if aim.name == "vibration":
        (row,) = (row for row in axes_of(machine) if row.axis.given.name == name)
        described = None if aim.frequency else row.axis.typed.vibration
        load = described or Vibration(frequency=aim.frequency, damping=aim.damping)
        swing = Swing(row, load)  # in RMS, so that of moves that leave alike each counts
        left = swing.exact[swing.lift > 0.0]
        return Figure(float(np.sqrt(np.mean(left**2))) if left.size else 0.0, axis.given.unit)
    results = drives(machine)[name]().results
    if aim.name == "power":
        return Figure(shown(results.power.peak, KW), aim.unit)
    return Figure(results.energy.driving if aim.name == "energy" else results.rms_torque, aim.unit)


def sheet_rate(machine: AnyMachine) -> float:
    """Return the highest rate (cycles/min) that the sheets of all drives state, infinite where none is bound."""
    common = (view.rates.high for view in drives_of(machine) if view.driven.entered.rate is None)
    return min((rate for rate in common if isinstance(rate, float)), default=math.inf)
