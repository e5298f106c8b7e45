"""What is true of results by points: the exact engine's, where a sheet is farther off than it states."""

from __future__ import annotations

from collections.abc import Iterator

from workbook.book.sentence import rounded
from workbook.entries.units import RPM, shown
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView, settled_highest
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.view import Whole

RMS, PEAK, ENERGY, RATE = 1e-3, 5e-3, 0.03, 1e-3
"""by which share the sheets state that T_rms, peaks, energies and the highest rate may be off"""


def drives_of(machine: AnyMachine) -> Iterator[DriveView]:
    """Yield the drives of a machine."""
    shelf = LawShelf(machine.laws, machine.sizes, bool(machine.laws.of("LIN")))
    whole = Whole(machine, shelf.laws)
    for axis in whole.axes:
        if axis.given.mechanism and axis.given.motor:
            yield DriveView(AxisRows(whole, axis, shelf.stack), Driven(axis, machine.selection))


def rates(machine: AnyMachine) -> list[str]:
    """Return a line for each drive whose exact highest rate is more than 0.1 % from that of its sheet."""
    return [line for view in drives_of(machine) for line in rate_of(view)]


def rate_of(view: DriveView) -> Iterator[str]:
    """Yield the line on the highest rate of a drive: the exact one is only searched where entering it again tells."""
    most = view.highest.rate
    if not isinstance(most, float) or not most:
        return
    settled = settled_highest(view).rate
    if isinstance(settled, float) and abs(settled - most) <= RATE / 2.0 * most:
        return
    exact, limit = view.exact_highest()
    if abs(exact - most) > RATE * most:
        yield (f"{view.driven.called}: the highest rate is {rounded(exact)} cycles/min exactly ({limit}); "
               f"its sheet says about {rounded(most)}")  # fmt: skip


def truths(machine: AnyMachine) -> list[str]:
    """Return a line for each result that is farther from the exact engine's than its sheet states, and on rates."""
    lines = []
    for view in drives_of(machine):
        lines += [*results_of(view), *rate_of(view)]
    return lines


def results_of(view: DriveView) -> Iterator[str]:
    """Yield a line for each result of a drive that is farther off than stated."""
    exact, points = view.driven.demand, view.points
    behind = view.load.behind
    driving, _ = view.energy
    peak = exact.torque.peak
    found = (
        ("RMS torque", "Nm", points.rms_torque, exact.rms_torque, RMS * peak),
        ("peak torque", "Nm", points.size(points.torque), peak, PEAK * peak),
        ("speed", "rpm", shown(view.speed, RPM), shown(exact.speed.peak, RPM), PEAK * shown(exact.speed.peak, RPM)),
        ("peak torque behind the reducer", "Nm", points.size(behind), exact.shaft_torque(1).peak,
         PEAK * exact.shaft_torque(1).peak),
        ("energy driven", "J", driving, exact.energy.driving, ENERGY * exact.energy.driving),
    )  # fmt: skip
    for what, unit, told, true, bound in found:
        if abs(told - true) > bound + 1e-9 * abs(true):
            said = f"{what} is {rounded(true)} {unit} exactly; its sheet says {rounded(told)} {unit}"
            yield f"{view.driven.called}: {said}"
