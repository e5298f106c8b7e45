"""The results of a machine by the names of its book, without a book: of many motors, reducers and rates at once."""

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from engine.drive.results import total_bus_power
from engine.motion.joining import shortfalls
from workbook.fields.texts import place_of
from workbook.fields.units import KW, shown
from workbook.law_sheets.library import laws, named_laws
from workbook.laws.family import COEFFICIENTS
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.backlash import Sides
from workbook.machines.machine.drive.reducer_load import shaft_of
from workbook.machines.machine.drive_entries import Backlash
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.exact import limit_of_gap, limit_of_stop
from workbook.machines.machine.first_sheet import RATE_CHECK
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.power import KWH
from workbook.machines.machine.studies import drive_results
from workbook.machines.machine.studies.drive_results import ok_texts
from workbook.machines.machine.studies.drives import FIXED, DriveStudy, cycles
from workbook.machines.machine.timing.stops import stops_of
from workbook.machines.machine.vibration import MOST, Swing
from workbook.machines.machine.view import MovingAxis, moving_axes
from workbook.selection.pair_selection import PairSelection
from workbook.template_outputs import Column, Computations, Results, Scaling

SCALES = re.compile(r"(axes\.\d+\.(?:motor|reducer))\.(?!holding$)\w+|((?:master|axes\.\d+)\.rate)")
GROWTH = {"v": ("y1_max", 1), "a": ("y2_max", 2), "j": ("y3_max", 3)}
"""by column: a figure of a phase, and the power of the rate with which it grows"""


def part(key: str) -> str:
    """Return motor or reducer of an axis, or the rate, to which the entry at a key belongs; empty for all others."""
    match = SCALES.fullmatch(key)
    return (match[1] or match[2]) if match else ""


def results(machine: AnyMachine, columns: Mapping[str, Column]) -> Results:
    """Return the results of designs that differ in motors, reducers and rates, by the keys of these entries."""
    rows = cache(partial(axes_of, machine))
    rate = columns.get("master.rate", Column([machine.per_minute], FIXED.places))
    faster = np.asarray(rate.each) / machine.per_minute
    figures: Computations = {f"{name}_rate": lambda: rate.each for name in ("about", "timing")}
    figures |= {f"{name}_cycle": partial(cycles, rate) for name in ("about", "timing")}
    checks: Computations = {}
    add_laws(machine, figures, checks)
    drives = []
    for axis in moving_axes(machine, laws(machine.laws)):
        axis_results, axis_checks = of_axis(axis, faster)
        figures, checks = figures | axis_results, checks | axis_checks
        checks |= end_checks(machine, axis, rows)
        if axis.given.mechanism and axis.given.motor:
            drives.append(DriveStudy(axis, machine, columns, partial(lambda i: rows()[i - 1], axis.number)))
            figures |= drive_results.results(drives[-1])
            checks |= drive_results.checks(drives[-1])
    add_clearances(machine, rows, figures, checks)
    add_vibration(machine, rows, faster, figures, checks)
    if not drives:
        return Results(figures | checks, list(checks), set(), {})
    add_backlash(drives, figures, checks)
    figures |= of_drives(machine, drives)
    slow = checks_of_drives(machine, drives)
    held = [partial(drive_results.hold_machine_rate, drive, rate.each) for drive in drives]
    (slow if any(drive.axis.given.rate for drive in drives) else checks)[RATE_CHECK] = partial(all_hold, held)
    each = {f"drive{drive.axis.number}_{name}" for drive in drives for name in drive_results.SLOW}
    slow_names = {*slow, *each, "about_highest", "about_binds"}
    return Results(figures | checks | slow, [*checks, *slow], slow_names, exact_judgements(drives, rate))


def exact_judgements(drives: Sequence[DriveStudy], rate: Column) -> Computations:
    """Return the checks that the exact engine decides, at rates of the machine."""
    judged = [drive_results.judged_exactly(drive) for drive in drives]
    exactly = [
        partial(drive_results.hold_machine_rate_exactly, drive, rate.each, by)
        for drive, by in zip(drives, judged, strict=True)
    ]
    exact = {name: judge for judgements in judged for name, judge in judgements.items()}
    return exact | {RATE_CHECK: partial(all_hold, exactly)}


def add_laws(machine: AnyMachine, figures: Computations, checks: Computations) -> None:
    """Add the coefficients and checks of the laws that have sheets of their own."""
    for law in [named_law for named_law in named_laws(machine.laws) if named_law.page.has_sheet]:
        figures |= {law.own(f"@{name}"): partial(getattr, law.law.coefficients, name) for name, *_ in COEFFICIENTS}
        verdicts = law.page.verdicts(law, machine.sizes)
        checks |= {law.own(q.name): partial(np.array, q.value) for q in verdicts}


def add_clearances(machine: AnyMachine, rows: Callable[[], Any], figures: Computations, checks: Computations) -> None:
    """Add the least gap of each clearance, where it is, and its check."""
    for k, given in enumerate(machine.clearances, 1):
        apart = cache(partial(lambda k, given: ClearanceView(given, k, rows()), k, given))
        figures[f"clearances.gap.{k}"] = partial(lambda apart: apart().least, apart)
        figures[f"clearances.at.{k}"] = partial(lambda apart: apart().over.shown(apart().place), apart)
        checks[f"clear{k}_kept"] = partial(lambda apart: ok_texts(limit_of_gap(apart()).ok), apart)


def add_vibration(
    machine: AnyMachine, rows: Callable[[], Any], faster: Any, figures: Computations, checks: Computations
) -> None:
    """Add the vibration that moves leave in the loads behind their axes, at many rates, and its checks."""
    for i, entered in ((i, axis.vibration) for i, axis in enumerate(machine.axes, 1) if axis.vibration):
        make = partial(
            lambda i, entered: [Swing(rows()[i - 1], entered, float(x)) for x in np.ravel(faster)], i, entered
        )
        of = partial(lambda each, figure: np.reshape([figure(s) for s in each()], np.shape(faster)), cache(make))
        figures[f"vib{i}_left"] = partial(of, lambda swing: float(swing.left.max()))
        figures[f"vib{i}_next"] = partial(of, lambda swing: float(swing.later(swing.left).max()))
        checks[f"vib{i}_settles"] = partial(lambda of: ok_texts(of(lambda swing: swing.limit.ok)), of)
        checks[f"vib{i}_reached"] = partial(lambda of: ok_texts(of(lambda swing: swing.periods <= MOST)), of)


def add_backlash(drives: Sequence[DriveStudy], figures: Computations, checks: Computations) -> None:
    """Add the torques of each drive with a backlash while the tool works, and its check."""

    def of(drive: DriveStudy, entered: Backlash, figure: Callable[[Sides], Any]) -> Any:
        return drive.of_rate(lambda base: figure(Sides(base, entered)))

    for drive in drives:
        if entered := drive.axis.given.backlash:
            begin, of_drive = f"back{drive.axis.number}_", partial(of, drive, entered)
            figures[f"{begin}back"] = partial(of_drive, lambda sides: sides.both[0])
            figures[f"{begin}fore"] = partial(of_drive, lambda sides: sides.both[1])
            ok = partial(of_drive, lambda sides: sides.limit.sheet.ok)
            checks[f"{begin}sides"] = partial(lambda ok: ok_texts(ok()), ok)


def all_hold(judged: Sequence[Callable[[], Any]]) -> Any:
    """Return in words in which designs all drives are judged to hold."""
    return ok_texts(np.logical_and.reduce(np.broadcast_arrays(*(judge() for judge in judged))))


def of_axis(axis: MovingAxis, faster: Any) -> tuple[Computations, Computations]:
    """Return results of an axis, at rates so many times the machine's, and checks that its entries do not decide."""
    i, given = axis.number, axis.given

    def of_move(k: int, figure: str, power: int) -> Any:
        if k in axis.moves:
            return getattr(axis.moves[k], figure) * axis.speed**power * faster**power
        return 0.0

    def of_whole(figure: str, power: int) -> Any:
        return getattr(axis, figure) * faster**power

    figures: Computations = {f"axes.travel.{i}": lambda: shown(axis.motion.lifts_sum, axis.unit)}
    for name, (figure, power) in GROWTH.items():
        figures |= {
            f"axis{i}.{name}.{k + 1}": partial(of_move, k, figure, power) for k in range(len(axis.given.phases))
        }
    for table in ("axes", "axes_short"):
        figures[f"{table}.v.{i}"] = partial(of_whole, "max_velocity", 1)
        figures[f"{table}.a.{i}"] = partial(of_whole, "max_acceleration", 2)
    stops = {f"{s.name}_kept": partial(lambda stop: ok_texts(limit_of_stop(stop).ok), s) for s in stops_of(axis)}
    return figures, stops | {
        f"axis{i}_position": lambda: ok_texts(axis.motion.complete),
        f"axis{i}_smooth": lambda: ok_texts(not shortfalls(axis.motion, given.smoothness, given.repeats)),
        f"axis{i}_closes": lambda: ok_texts(axis.closes),
    }


def end_checks(machine: AnyMachine, axis: MovingAxis, rows: Callable[[], Any]) -> Computations:
    """Return the checks of the velocities at a motion's ends, where straight lines can give it some."""
    ends = rows()[axis.number - 1].ends if machine.laws.of("LIN") else None
    if ends:
        return {q.name: partial(np.array, q.value) for q in ends.checks(f"axis{axis.number}", "")}
    return {}


def checks_of_drives(machine: AnyMachine, drives: list[DriveStudy]) -> Computations:
    """Return the check of the choice for the axis that the sheet Selection looks at."""

    def chosen(drive_study: DriveStudy) -> Any:
        """Return whether the catalogue has a pair for the axis that the sheet Selection looks at."""
        each = (PairSelection(machine.selection, machine.sizes, [shaft_of(base)]) for base in drive_study.bases)
        return ok_texts(np.array([choice.proposed is not None for choice in each])[drive_study.rates.places])

    axis = machine.selection.axis
    named = [drive for drive in drives if axis and place_of(axis, [drive.axis.given.name]) == 0]
    return {"sel_ok": partial(chosen, named[0])} if named else {}


def of_drives(machine: AnyMachine, drives: list[DriveStudy]) -> Computations:
    """Return the results of all drives together."""
    whole = cache(lambda: total_bus_power([drive.mains for drive in drives]))

    def binding() -> Any:
        rates = np.array(np.broadcast_arrays(*(drive.ends("high")[0] for drive in drives)))
        words = [
            np.array([f"{drive.axis.given.name}: {limit}" for limit in drive.ends("high")[1]], dtype=object)
            for drive in drives
        ]
        return np.choose(rates.argmin(axis=0), np.broadcast_arrays(*words))

    figures: Computations = {
        "power_mains": lambda: shown(whole().mains, KW),
        "power_resistors": lambda: shown(whole().resistor, KW),
        "power_year": lambda: shown(whole().energy_a_year(machine.power.hours), KWH),
        "about_highest": lambda: np.min(np.broadcast_arrays(*(drive.ends("high")[0] for drive in drives)), axis=0),
        "about_binds": binding,
    }
    for k, drive in enumerate(drives, 1):
        figures[f"power.mains.{k}"] = partial(lambda drive: shown(drive.mains.mains, KW), drive)
        figures[f"power.resistor.{k}"] = partial(lambda drive: shown(drive.mains.resistor, KW), drive)
    return figures


SCALING = Scaling(part, results)
