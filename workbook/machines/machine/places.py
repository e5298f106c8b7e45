"""Places of a cycle (phases, process forces, times of switches): their faults, and their conversion to degrees."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, TypeVar

from workbook.book.sentence import figure
from workbook.entries.abscissa import Abscissa, length_abscissa
from workbook.entries.phase import TURN, AxisPhase
from workbook.fields.types import ANGLE_TOLERANCE, DesignError, Model
from workbook.fields.units import shown, si
from workbook.machines.machine.entries_beside import KEYS, UNUSED, SwitchEntry

if TYPE_CHECKING:
    from workbook.machines.machine.entries import AnyMachine, Axis

RATES = ("velocity", "acceleration")
Lasting = TypeVar("Lasting", bound=Model)


def place_faults(machine: "AnyMachine") -> Iterator[DesignError]:
    """Yield phases, process forces and times of switches that do not lie in the cycle, or not in order."""
    over = machine.over
    if beyond_turn := [] if over.measured else [*places_beyond_turn(machine)]:
        yield from beyond_turn
        return
    located = [("axes", i, axis_faults(axis, over)) for i, axis in enumerate(machine.axes)]
    located += [("switches", i, switch_faults(switch, over)) for i, switch in enumerate(machine.switches)]
    for table, i, errors in located:
        for error in errors:
            yield DesignError(f"{table}.{i}.{error.field}", str(error), error.fits)


def places_beyond_turn(machine: "AnyMachine") -> Iterator[DesignError]:
    """Yield each place beyond a turn of the master shaft, the largest that its cell takes."""
    tables: list[tuple[str, Sequence[Model]]] = []
    for i, axis in enumerate(machine.axes):
        tables += [(f"axes.{i}.phases", axis.phases), (f"axes.{i}.load.windows", axis.load.windows)]
    tables += [(f"switches.{i}.on", switch.on) for i, switch in enumerate(machine.switches)]
    for key, rows in tables:
        for k, row in enumerate(rows):
            for name in KEYS:
                if (getattr(row, name) or 0.0) > TURN:
                    message = f"expected a number from 0 to {TURN:g}"
                    yield DesignError(f"{key}.{k}.{name}", message, TURN, getattr(row, name))


def axis_faults(axis: "Axis", over: Abscissa) -> list[DesignError]:
    """Return the faults of an axis' phases, their order first, and of its process forces."""
    phases, windows = axis.phases, axis.load.windows
    wrong = [*forward(axis.name, phases, over), *following(axis.name, phases, over)]
    beyond = within(f"{axis.name} row", phases, over, "phases", filling(phases, over.length))
    inside = [window.model_dump() | {end: min(getattr(window, end), over.length) for end in KEYS} for window in windows]
    forces = within(f"{axis.name} process force", windows, over, "load.windows", inside)
    return [*(wrong or beyond), *forces]


def forward(name: str, phases: Sequence[AxisPhase], over: Abscissa) -> Iterator[DesignError]:
    """Yield the first phase of an axis that runs backwards, or does not last."""
    for row, phase in enumerate(phases, 1):
        if phase.stop <= phase.start:
            stop, short = (f"{figure(x)}{over.after}" for x in (phase.stop, phase.start - phase.stop))
            message = f"{name} row {row} ends at {stop}, {short} before it begins"
            yield DesignError("phases", message, filling(phases, over.length))
            return


def filling(phases: Sequence[AxisPhase], length: float) -> list[dict[str, Any]]:
    """Return the phases, evenly spread over a cycle of a length."""
    step = length / len(phases)
    ends = pairwise([*(i * step for i in range(len(phases))), length])
    return [
        phase.model_dump() | {"start": start, "stop": stop} for phase, (start, stop) in zip(phases, ends, strict=True)
    ]


def following(name: str, phases: Sequence[AxisPhase], over: Abscissa) -> Iterator[DesignError]:
    """Yield the first phase of an axis that begins before the phase above ends."""
    reached = 0.0
    for i, phase in enumerate(phases):
        early = over.degrees(reached) - over.degrees(phase.start)
        if early > ANGLE_TOLERANCE:
            problem = f"begins at {figure(phase.start)}{over.after}, {over.text(early)} before row {i} ends"
            yield DesignError(f"phases.{i}.start", f"{name} row {i + 1} {problem}", reached)
            return
        reached = phase.stop


def switch_faults(switch: SwitchEntry, over: Abscissa) -> list[DesignError]:
    """Return the first time of a switch beyond the cycle, or that does not last or meets another."""
    beyond = within(f"{switch.name} time", switch.on, over, "on", [UNUSED for _ in switch.on])
    return [*beyond] or [*meeting(switch, over)]


def meeting(switch: SwitchEntry, over: Abscissa) -> Iterator[DesignError]:
    """Yield the first time of a switch that does not last, or is not over where another begins."""
    ends = [(k, time.ends) for k, time in enumerate(switch.on, 1) if time.ends]
    times = [(k, over.degrees(start), over.degrees(stop)) for k, (start, stop) in ends]
    spans = {k: stop - start + (TURN if stop < start else 0.0) for k, start, stop in times}
    problems = [f"time {k} does not last" for k, span in spans.items() if span <= ANGLE_TOLERANCE]
    for k, start, _ in times:
        more = spans[k] - min(((other - start) % TURN for j, other, _ in times if j != k), default=spans[k])
        if more > ANGLE_TOLERANCE:
            problems.append(f"time {k} is on {over.text(more)} beyond the begin of another")
    if problems:
        yield DesignError("on", f"{switch.name} {problems[0]}", [UNUSED for _ in switch.on])


def within(name: str, rows: Sequence[Any], over: Abscissa, key: str, fits: Any) -> Iterator[DesignError]:
    """Yield the first of several rows, each with its ``start`` and ``stop``, that goes on beyond the cycle."""
    for k, row in enumerate(rows, 1):
        last = max(x for x in (0.0, row.start, row.stop) if x is not None)
        if over.degrees(last) - TURN > ANGLE_TOLERANCE:
            at, by = (f"{figure(x)}{over.after}" for x in (last, last - over.length))
            yield DesignError(key, f"{name} {k} goes to {at}, {by} beyond the cycle", fits)
            return


def axis_in_degrees(axis: "Axis", over: Abscissa) -> "Axis":
    """Return an axis with all its places in degrees of a turn, and what its phases pass in SI by rad."""
    if not over.measured:
        return axis
    size, phases = over.lift(axis.unit).size, []
    for phase in axis.phases:
        rates = {name: getattr(phase, name) for name in RATES}
        passed = {
            name: None if rate is None else over.per_rad(si(rate, size), order)
            for order, (name, rate) in enumerate(rates.items(), 1)
        }
        phases.append(in_degrees(phase, over).model_copy(update=passed))
    load = axis.load.model_copy(update={"windows": [in_degrees(force, over) for force in axis.load.windows]})
    return axis.model_copy(update={"phases": phases, "load": load, "shift": over.degrees(axis.shift)})


def in_degrees(lasting: Lasting, over: Abscissa) -> Lasting:
    """Return entries with ``start`` and ``stop`` of the cycle in degrees of a turn."""
    ends = {name: getattr(lasting, name) for name in KEYS if over.measured}
    return lasting.model_copy(
        update={name: None if x is None else min(over.degrees(x), TURN) for name, x in ends.items()}
    )


def to_units(data: dict[str, Any], unit: str, cycle: float) -> None:
    """Convert all places of a description from degrees into a unit of its cycle; what phases pass from SI by rad."""
    over = length_abscissa(unit, cycle)
    for axis in data["axes"]:
        size = over.lift(axis["unit"]).size
        axis["shift"] = over.shown(axis["shift"])
        for phase in axis["phases"]:
            for order, name in enumerate(RATES, 1):
                if phase.get(name) is not None:
                    phase[name] = shown(over.per_rad(phase[name], -order), size)
    lasting = [entry for axis in data["axes"] for entry in (*axis["phases"], *axis["load"]["windows"])]
    for entry in (*lasting, *(time for switch in data["switches"] for time in switch["on"])):
        entry |= {end: None if entry[end] is None else over.shown(entry[end]) for end in KEYS}
