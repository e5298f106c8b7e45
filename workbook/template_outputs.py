"""The outputs of a template besides its book: axes for controllers, results of many designs, limits judged exactly.

Designs that differ only in entries that scale results (a motor, a reducer) are computed together, without a book: a
template names these entries, and gives the results by the names in its book.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Generic, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from engine.drive.drive_points import stated_bounds
from engine.drive.limits import BELOW, LimitChecks
from engine.drive.motor import LimitCheck
from engine.motion.profile import CamProfile
from engine.timing import Switch
from workbook.book.quantity import FAIL, OK
from workbook.book.sentence import as_shown
from workbook.fields.units import KW, RPM, shown

M = TypeVar("M")
Values = NDArray[Any]  # a result of designs: for all, or for each


@dataclass(frozen=True)
class CamAxis:
    """An axis over a cycle of its master: its profile and the units of both."""

    name: str
    profile: CamProfile
    x_unit: str
    y_unit: str
    repeats: bool = True  # whether the cycle follows upon itself: it comes back, or a feed goes on from where it is
    shaft: Callable[[], Self] | None = None
    """gives the angle of its motor's shaft, if it has a drive; raises ValueError for what the mechanism cannot do"""

    @property
    def units(self) -> tuple[str, str, str, str]:
        """Units of y, y', y'' and y'''."""
        x, y = self.x_unit, self.y_unit
        return y, f"{y}/{x}", f"{y}/{x}²", f"{y}/{x}³"


class CamSwitch(NamedTuple):
    """A switch over a cycle of the master, in the unit of its angles."""

    name: str
    switch: Switch
    x_unit: str


class Column(NamedTuple):
    """An entry in many designs: its different values, and which of them each design has."""

    values: Sequence[Any]
    places: NDArray[np.intp]

    @property
    def each(self) -> Values:
        """The value in each design."""
        return np.array(self.values)[self.places]


Computations = dict[str, Callable[[], Any]]


class Results(NamedTuple):
    """Functions that compute results, by name; which of them are checks, and which take each design by itself.

    ``exact`` are the checks as the exact engine judges them, by their names: as slow.
    """

    named: Mapping[str, Callable[[], Any]]
    checks: Collection[str]
    slow: Collection[str]
    exact: Mapping[str, Callable[[], Any]] = MappingProxyType({})


class Scaling(NamedTuple, Generic[M]):
    """The entries of a kind of machine that only scale its results, and these results.

    ``part`` returns to which part of the machine the entry at a key belongs, empty for all others; an entry of a part
    may differ. ``results`` gives the results of designs that differ in the columns, by the keys of these.
    """

    part: Callable[[str], str]
    results: Callable[[M, Mapping[str, Column]], Results]


class JudgedLimit(NamedTuple):
    """A limit as its sheet and as the exact engine has it: both must hold it."""

    check: str  # name of the sheet's check
    of: str  # whose limit it is
    what: str  # what is limited
    unit: str
    sheet: LimitCheck
    exact: LimitCheck
    bound: float  # share of the limit by which the sheet states that its figure may be off

    @property
    def ok(self) -> bool:
        """Whether the sheet's figure and the exact figure are both within the limit."""
        return self.sheet.ok and self.exact.ok

    @property
    def is_close(self) -> bool:
        """Whether the sheet's figure is within its stated bound of the limit."""
        return abs(self.sheet.use - 1.0) <= self.bound

    @property
    def line(self) -> str:
        """Both figures against the limit; of a figure that is close to it, how close, and how well that is known."""
        exact = f"{as_shown(self.exact.value)} {self.unit}"
        limit = f"{as_shown(self.exact.limit)} {self.unit}"
        if self.is_close:
            share, known = f"{100.0 * self.sheet.use:.2f} %", f"{100.0 * self.bound:.2g} %"
            return f"{self.what} at the limit: {share}, known to {known}; {exact} exactly, the limit is {limit}"
        sheet = f"{as_shown(self.sheet.value)} {self.unit}"
        return f"{self.what} is {exact} exactly, {sheet} on its sheet; the limit is {limit}"


class ExactJudgement(NamedTuple):
    """The exact engine's judgement on a book: of its limits, and in a line of each result off by more than stated."""

    limits: Sequence[JudgedLimit] = ()
    deviations: Sequence[str] = ()

    @property
    def notes(self) -> list[str]:
        """The deviations, and the limits that are held but close."""
        return [
            *self.deviations,
            *(f"{limit.of}: {limit.line}" for limit in self.limits if limit.ok and limit.is_close),
        ]

    def judge(self, check: str, verdict: str, says: str) -> tuple[str, str]:
        """Return the verdict of a check and its sentence: it holds where its sheet and the exact engine say so.

        Where the sheet says OK, its sentence tells how well the figure is known, which explains no verdict.
        """
        limit = next((each for each in self.limits if each.check == check), None)
        says = "" if verdict == OK else says
        if limit is None or verdict not in (OK, FAIL) or limit.exact.ok == (verdict == OK):
            return verdict, says
        return FAIL, "; ".join(filter(None, (limit.line, says)))


NOTHING_JUDGED = ExactJudgement()


ROUNDING = 1e-9  # share by which an exact figure that is at its limit may seem above it
SIZES = {"rpm": RPM, "kW": KW}  # of units that are not the engine's
LIMITS = {
    "RMS torque": ("ok_rms", "Nm"), "peak torque": ("ok_peak", "Nm"), BELOW: ("ok_curve", "Nm"),
    "motor speed": ("ok_speed", "rpm"), "reducer input speed": ("ok_reducer_speed", "rpm"),
    "reducer peak torque": ("ok_reducer_peak", "Nm"), "reducer mean torque": ("ok_reducer_mean", "Nm"),
}  # fmt: skip
"""of each limit of a drive by its name in the engine: the sheet's check, and its unit"""


def judged_limits(drive: str, cells: str, sheet: Mapping[str, LimitCheck], exact: LimitChecks) -> list[JudgedLimit]:
    """Return the limits of a drive whose cells have names that begin with ``cells``, by its sheet and exactly."""
    motor, limits, bounds = exact.motor, [], limit_bounds(exact)
    checks = {check.name: check for check in exact.checks}
    checks["peak torque"] = LimitCheck("peak torque", exact.results.torque.peak, motor.peak_torque)
    if not motor.falling.fall:
        del checks[BELOW]
    for name, truth in checks.items():
        check, unit = LIMITS[name]
        size = SIZES.get(unit, 1.0)
        if truth.limit < truth.value <= truth.limit * (1.0 + ROUNDING):
            truth = truth._replace(value=truth.limit)
        by_points, exactly = (
            each._replace(value=shown(each.value, size), limit=shown(each.limit, size)) for each in (sheet[name], truth)
        )
        bound = bounds[name] / truth.limit
        limits.append(JudgedLimit(f"{cells}{check}", drive, name, unit, by_points, exactly, bound))
    return limits


def limit_bounds(exact: LimitChecks) -> dict[str, float]:
    """Return by how much the figure of each limit may be off, by the limit's name, in SI units."""
    results, bound = exact.results, stated_bounds(exact.drive_cycle.train)
    peak, speed, behind = results.torque.peak, results.speed.peak, results.shaft_torque(1).peak
    return {
        "RMS torque": bound.rms_torque * peak,
        "peak torque": bound.peak_torque * peak,
        BELOW: bound.peak_torque * peak,
        "motor speed": bound.speed * speed,
        "reducer input speed": bound.speed * speed,
        "reducer peak torque": bound.peak_torque * behind,
        "reducer mean torque": bound.mean_torque * behind,
    }


def deviations(drive: str, sheet: Mapping[str, float], exact: LimitChecks) -> Iterator[str]:
    """Yield a line for each result of a drive's sheet, by its name and in SI units, that is farther off than stated."""
    results, bound = exact.results, stated_bounds(exact.drive_cycle.train)
    time = exact.drive_cycle.time
    torque, speed, power, energy = results.torque, results.speed.peak, results.power, results.energy
    behind, most = results.shaft_torque(1).peak, bound.peak_torque * torque.peak
    most_power = bound.peak_power * power.peak
    work = bound.energy * (energy.driving + energy.regenerated)
    truths = {
        "RMS torque": ("Nm", results.rms_torque, bound.rms_torque * torque.peak),
        "highest torque": ("Nm", torque.highest.value, most),
        "lowest torque": ("Nm", torque.lowest.value, most),
        "speed": ("rpm", speed, bound.speed * speed),
        "mean speed": ("rpm", results.mean_speed, bound.mean_speed * speed),
        "peak torque behind the reducer": ("Nm", behind, bound.peak_torque * behind),
        "mean torque behind the reducer": ("Nm", results.mean_shaft_torque(1), bound.mean_torque * behind),
        "highest power": ("kW", max(0.0, power.highest.value), most_power),
        "lowest power": ("kW", min(0.0, power.lowest.value), most_power),
        "mean power": ("kW", energy.net / time, bound.mean_power * power.peak),
        "energy driven": ("J", energy.driving, work),
        "energy regenerated": ("J", energy.regenerated, work),
    }
    for name, value in sheet.items():
        unit, true, off = truths[name]
        if abs(value - true) > off + 1e-9 * abs(true):
            exactly, by_points = (as_shown(shown(each, SIZES.get(unit, 1.0))) for each in (true, value))
            yield f"{drive}: {name} is {exactly} {unit} exactly; its sheet says {by_points} {unit}"
