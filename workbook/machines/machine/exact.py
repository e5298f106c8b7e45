"""Compare results by points with the exact engine, and report those that are farther off than a sheet states."""

import math
from collections.abc import Iterator

from engine.drive.limits import highest_rate
from workbook.book.sentence import rounded
from workbook.fields.units import PER_MINUTE, RPM, shown
from workbook.law_sheets.book_laws import BookLaws
from workbook.machines.machine.clearances import ClearanceView
from workbook.machines.machine.drive.view import DriveView, drive_of, settled_highest
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.view import MachineView, MovingAxis

RMS, PEAK, ENERGY, RATE, GAP, MOTION = 1e-3, 5e-3, 0.03, 1e-3, 1e-3, 5e-4
"""by which share the sheets state that T_rms, peaks, energies, the highest rate, a least gap and the extremes of phases
that meet at speed may be off"""


def axes_of(machine: AnyMachine) -> list[AxisTables]:
    """Return the axes of a machine as its book has them."""
    book_laws = BookLaws(machine.laws, machine.sizes, bool(machine.laws.of("LIN")))
    whole = MachineView(machine, book_laws.laws)
    return [AxisTables(whole, axis, book_laws.stack) for axis in whole.axes]


def drives_of(machine: AnyMachine) -> Iterator[DriveView]:
    """Yield the drives of a machine."""
    yield from filter(None, map(drive_of, axes_of(machine)))


def rates(machine: AnyMachine) -> list[str]:
    """Return a line for each drive whose exact highest rate is more than 0.1 % from that of its sheet."""
    return [line for view in drives_of(machine) for line in rate_of(view)]


def rate_of(view: DriveView) -> Iterator[str]:
    """Yield the line on the highest rate of a drive: the exact one is only searched where entering it again tells."""
    told, most, says = view.highest.rate, math.inf, str(view.highest.rate)
    if isinstance(told, float):
        settled, most, says = settled_highest(view).rate, told, f"about {rounded(told)}"
        if not told or (isinstance(settled, float) and abs(settled - told) <= RATE / 2.0 * told):
            return
    exact, limit = exact_highest(view)
    if abs(exact - most) > RATE * min(exact, most):
        found = f"the highest rate is {rounded(exact)} cycles/min exactly ({limit})"
        yield f"{view.driven.called}: {found}; its sheet says {says}"


def exact_highest(view: DriveView) -> tuple[float, str]:
    """Return the exact highest rate of a drive (cycles/min) and the limiting factor."""
    found = highest_rate(view.driven.limit_checks)
    return shown(found.speed / math.tau, PER_MINUTE), found.limit


def deviations(machine: AnyMachine) -> list[str]:
    """Return a line for each result that is farther from the exact engine's than its sheet states, and on rates."""
    rows = axes_of(machine)
    lines = [line for view in filter(None, map(drive_of, rows)) for line in (*results_of(view), *rate_of(view))]
    gaps = (gap_of(ClearanceView(one, k, rows)) for k, one in enumerate(machine.clearances, 1))
    return [*lines, *filter(None, gaps), *(line for one in rows for line in extremes_of(one.axis))]


def extremes_of(axis: MovingAxis) -> Iterator[str]:
    """Yield a line for each phase that meets its neighbours at speed, and is found slower than its sheet states."""
    for i, k in enumerate(axis.entered, 1):
        exact, told = axis.joined.motion.phases[k], axis.motion.phases[k]
        for what, true, said in (("velocity", exact.y1_max, told.y1_max), ("acceleration", exact.y2_max, told.y2_max)):
            if abs(said - true) > MOTION * true:
                yield f"{axis.given.name} row {i}: the greatest {what} is {rounded(100.0 * (true / said - 1.0))} % more"


def gap_of(one: ClearanceView) -> str:
    """Return the line on a least gap, empty where it is as exact as its sheet states."""
    exact, unit = one.exact, one.unit
    if abs(one.least - exact) <= GAP * one.change + 1e-9 * one.size:
        return ""
    return f"{one.given.name}: the least gap is {rounded(exact)} {unit} exactly; its sheet says {rounded(one.least)}"


def results_of(view: DriveView) -> Iterator[str]:
    """Yield a line for each result of a drive that is farther off than stated."""
    exact, points, behind, (driving, _) = view.driven.results, view.points, view.load.output_torque, view.energy
    peak, fastest, turning = exact.torque.peak, shown(exact.speed.peak, RPM), exact.shaft_torque(1).peak
    found = (
        ("RMS torque", "Nm", points.rms_torque, exact.rms_torque, RMS * peak),
        ("peak torque", "Nm", points.size(points.torque), peak, PEAK * peak),
        ("speed", "rpm", shown(view.speed, RPM), fastest, PEAK * fastest),
        ("peak torque behind the reducer", "Nm", points.size(behind), turning, PEAK * turning),
        ("energy driven", "J", driving, exact.energy.driving, ENERGY * exact.energy.driving),
    )
    for what, unit, told, true, bound in found:
        if abs(told - true) > bound + 1e-9 * abs(true):
            said = f"{what} is {rounded(true)} {unit} exactly; its sheet says {rounded(told)} {unit}"
            yield f"{view.driven.called}: {said}"
