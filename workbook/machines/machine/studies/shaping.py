"""Changes of laws: another for a phase, laws shaped for its drive, and laws given out by a shaper for its load."""

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from itertools import count
from typing import Any

from engine.drive.limits import at_speed
from engine.drive.rate_range import at_points
from engine.drive.shaped import Splines
from engine.laws import PieceLaw
from engine.laws.base import Kinematics
from engine.laws.ends import BoundaryValues
from engine.laws.pieces import moved_to
from engine.laws.vibration import Shaper
from workbook.book.sentence import figure
from workbook.errors import InputError
from workbook.fields.paths import Place, key_of
from workbook.fields.units import MS, PER_MINUTE, shown, si
from workbook.improving import Aim, Change
from workbook.law_sheets.library import NamedLaw, laws, named_laws
from workbook.laws.entries import ENTRIES, Laws, listed, references
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.entries_beside import Vibration
from workbook.machines.machine.view import moving_axes

FREE = ("LIN", "OWN", "SPL")  # families without a law of their own from rest to rest
# by what must not jump: the highest derivative that is 0 at ends
RESTS = {"velocity": 1, "acceleration": 2, "jerk": 3}
SHAPED = "Shaped"  # begins the name of a new law that is shaped for its drive
TORQUE_OR_RATE = ("torque", "rate")
# aims for which laws are shaped, all but the rate by least torque
SHAPED_FOR = ("rate", "torque", "power", "energy")
PIECES = 8  # of a law that is shaped for its drive, at most
MOST_PIECES = 60  # of an own law
NEAR = 1e-9  # of the rise: ends of laws that differ by less are the same


def drives(machine: AnyMachine) -> dict[str, Any]:
    """Return functions that make the drives of a machine with their limits, by the names of their axes."""
    axes = moving_axes(machine, laws(machine.laws))
    return {axis.given.name: partial(Driven, axis, machine) for axis in axes if axis.given.motor}


def law_changes(machine: AnyMachine, i: int, rate: float, aim: Aim) -> Iterator[Change]:
    """Yield a law shaped for its drive for each phase of an axis, and those of all families between two rests."""
    axis, words = machine.axes[i], {law.name: law.words for law in named_laws(machine.laws)}
    known = {law.name: law for law in from_rest_to_rest(machine)}
    driven = drives(machine)[axis.name]() if axis.motor and aim.name in SHAPED_FOR else None
    for k, phase in enumerate(axis.phases):
        if not phase.lift or machine.laws[phase.law].family == "LIN":
            continue
        begin = f"{axis.name} phase {k + 1}: {words[phase.law]}"
        if driven:
            with suppress(ValueError, ArithmeticError):  # too few pieces, or what the engine refuses
                name = free_name(machine, i, k)
                yield shaped(machine, driven, rate, k, begin, name, TORQUE_OR_RATE[aim.is_rate])
        if phase.law in known and not passes(axis, k):
            yield from shapers(machine, i, k, begin) if aim.name == "vibration" else ()
            yield from other_laws(machine, i, k, begin, known)


def other_laws(machine: AnyMachine, i: int, k: int, begin: str, known: Mapping[str, NamedLaw]) -> Iterator[Change]:
    """Yield the change of a phase to each of other laws, but those that are shaped for other phases."""
    path = ("axes", str(i), "phases", str(k), "law")
    for law in known.values():
        is_shaped = getattr(law.entered, "shaped", None) or getattr(law.entered, "shaper", None)
        if law.name != machine.axes[i].phases[k].law and not is_shaped:
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
    rest = RESTS[axis.given.smoothness]
    checks, number = at_speed(driven.limit_checks, rate * math.tau), axis.entered[k]
    jerk = getattr(machine.laws[axis.given.phases[k].law], "max_jerk", None)
    ends = axis.joined.ends_of(number)
    family = Splines(5, rest, most, jerk or math.inf, ends)
    law = family.shape_phase(checks, axis.motion, number, least_torque).law
    words = f"Shaped for its drive at {shown(1.0 / checks.drive_cycle.time, PER_MINUTE):.1f} cycles/min"
    own = frozen(law, words) | {"shaped": aim} | ({"max_jerk": jerk} if jerk else {})
    path = ("axes", str(axis.number - 1), "phases", str(k), "law")
    return Change(f"{begin} → shaped for its drive", {("laws", name): own, path: name}, "law")


def frozen(law: PieceLaw, words: str) -> dict[str, Any]:
    """Return the entries of an own law of a name with the ends and the pieces, cubics, of another."""
    pieces = [{"duration": piece.duration} | {f"c{n}": c for n, c in enumerate(piece.c)} for piece in law.as_pieces()]
    slopes = zip(("first_slope", "last_slope"), law.slopes, strict=True)
    return {"family": "OWN", "name": words, "pieces": pieces} | {name: v for name, v in slopes if v is not None}


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
    view = moving_axes(machine, laws(machine.laws))[i].sized
    load = view.given.vibration or Vibration()
    known = {law.name: law for law in from_rest_to_rest(machine)}
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


def misfits(machine: AnyMachine) -> Iterator[tuple[str, BoundaryValues]]:
    """Yield the laws shaped for their drives with other rates than their phases have to meet, and these, by ξ."""
    for axis in moving_axes(machine, laws(machine.laws)):
        for k, phase in zip(axis.entered, axis.given.phases, strict=True):
            law = axis.library[phase.law]
            if phase.lift and getattr(machine.laws[phase.law], "shaped", None):
                ends, asked = axis.joined.ends_of(k), "va"[: RESTS[axis.given.smoothness]]
                both = [(getattr(at, n), ends.both(n)[i]) for i, at in enumerate((law.start, law.end)) for n in asked]
                if any(abs(own - rate) > NEAR * law.coefficients.ca for own, rate in both):
                    yield phase.law, ends


def refitted(machine: AnyMachine) -> dict[Place, Any]:
    """Return the entries of laws that are shaped and frozen between velocities, with those that their phases have now.

    Raises ValueError where such a law would overshoot. Laws whose jerk is bounded stay as they are.
    """
    entries: dict[Place, Any] = {}
    for name, ends in misfits(machine):
        entered, law = machine.laws[name], laws(machine.laws)[name]
        if isinstance(law, PieceLaw) and law.fixes_ends and not entered.max_jerk:
            entries["laws", name] = entered.model_dump(exclude_none=True) | frozen(moved_to(law, ends), entered.name)
    return entries


def reshaped(machine: AnyMachine, name: str) -> tuple[str, Change]:
    """Return the axis whose drive or load a law is shaped for, and the change that shapes it anew.

    That is at the rate of the machine, or the highest. Raises InputError unless the law is that of a single phase that
    moves, with a drive; from rest to rest, with a natural frequency, where a shaper gives it out.
    """
    entered = machine.laws[name]
    needed, key = ("vibration", "shaper") if entered.shaper else ("drive", "shaped")
    axes = enumerate(machine.axes)
    phases = [(i, k) for i, axis in axes for k, phase in enumerate(axis.phases) if phase.law == name]
    fitting = [(i, k) for i, k in phases if is_fit(machine.axes[i], k, needed)]
    if len(phases) != 1 or not fitting:
        what = "moving, with a drive" if needed == "drive" else f"between two rests with a {needed}"
        problem = f"{len(phases)} phases have this law, {len(fitting)} of them {what}"
        expected = f"expected a single phase, {what}"
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
    """Return whether a phase of an axis moves, with a drive, or from rest to rest, with the vibration of its load."""
    if needed == "drive":
        return bool(axis.motor and axis.phases[k].lift)
    swings = axis.vibration and axis.vibration.natural(axis.unit)
    return bool(swings and axis.phases[k].lift and not passes(axis, k))


def passes(axis: Axis, k: int) -> bool:
    """Return whether a phase of an axis begins or ends at speed."""
    return bool(axis.phases[k].passes or axis.phases[(k + 1) % len(axis.phases)].passes)
