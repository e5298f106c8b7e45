"""The engine's view of a drive at the points of its cycle, in the order of its sheet."""

import math
from copy import copy
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from engine.drive.drive_points import DrivePoints
from engine.drive.limit_use import RateSearch
from engine.drive.limits import BELOW, creep_checks, creep_factor
from engine.drive.motor import LimitCheck, Reserve, reserve
from engine.drive.quadrature import Interpolation, LoadPoints, QuadratureCycle
from engine.drive.rate_estimates import RateRange
from engine.drive.results import Energy
from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.checks import ZERO
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, PER_HOUR, PER_MINUTE, RPM, shown, si
from workbook.machines.machine.boundary.curves import BENT_FROM, bend_angles
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.peaks import Peaks
from workbook.machines.machine.drive_entries import WINDOWS
from workbook.machines.machine.motion_tables import AxisTables

LEAST = 1e-3  # of torques and powers: what is smaller is next to nothing


NONE_BINDS, AT_NO_RATE = "none", "at no rate"
"""the words for a highest rate where no limit binds, and where none is held"""


class Rates(NamedTuple):
    """The rates (cycles/min) between which a drive holds all limits, or words, and the limits at either end."""

    low: float | str
    high: float | str
    low_limit: str
    high_limit: str

    @classmethod
    def of(cls, found: RateRange) -> "Rates":
        """Return a range of rates (1/s)."""
        if found.high == 0.0:
            return cls(AT_NO_RATE, AT_NO_RATE, AT_NO_RATE, found.high_limit)
        low, high = (shown(rate, PER_MINUTE) for rate in found[:2])
        return cls(
            low,
            high if math.isfinite(high) else NONE_BINDS,
            found.low_limit or NONE_BINDS,
            found.high_limit or NONE_BINDS,
        )


def count_steps(rate: float) -> float:
    """Return the steps of a cycle/min that a highest rate is rounded down to: of four digits."""
    return 10.0 ** (3 - math.floor(math.log(rate * (1.0 + ZERO)) / math.log(10.0)))


class Scales(NamedTuple):
    """The largest sizes of quantities of a drive, by which deviations are measured, in the units of its sheet."""

    force: float
    behind: float
    torque: float
    rpm: float
    power: float
    work: float
    turning: float  # the acceleration of the shaft behind the reducer (rad/s²)


class DriveView:
    """A drive over its axis' motion, by intervals and points.

    Of the table of intervals it has the ``rows``: of pieces of the motion (their ``room``), cut at edges of process
    forces and at even ``steps`` of the cycle. The load of one that ``slides`` travels while its axis turns; the ratio
    of one that ``varies`` depends on the position; the figures of the brake are known of one that ``brakes``; the
    points of one ``for_selection`` are on that sheet; one that ``is_viscous`` has a cell for viscous friction. ``rate``
    is the one that it is sized at (cycles/min), ``slow`` that at which it creeps, over it. A view ``like`` another is
    of the same load behind another motor or reducer.
    """

    def __init__(self, tables: AxisTables, driven: Driven, like: "DriveView | None" = None) -> None:
        self.tables, self.driven, machine = tables, driven, tables.machine.given
        own = driven.entered.rate
        self.steps, self.room = driven.by_angle.steps if driven.by_angle else 1, tables.room
        self.rows = self.room + self.steps - 1
        self.slides, self.varies = driven.given.SLIDES, driven.linkage is not None
        self.brakes = driven.entered.motor is not None and driven.entered.motor.brake is not None
        self.is_viscous = driven.entered.load.viscous is not None
        self.slow = creep_factor(driven.drive_cycle.time)
        self.creeps_loaded = machine.creep_forces == "on"  # by its process forces
        self.knows_falling = machine.selection.knows_falling
        self.for_selection = machine.selection.axis is not None
        self.rate = machine.per_minute if own is None else own
        self.time = driven.drive_cycle.time  # of a cycle (s)
        self.cycles = shown(1.0 / self.time, PER_HOUR)  # an hour
        pieces, near = list(tables.pieces.pieces), tables.axis.motion.tolerance
        self.turn_rows, found = machine.sizes.turns, tables.turns
        # where accelerations are cut (°); 360: nowhere
        self.bends = bend_angles(tables.ends) if tables.ends else []
        bent = sum(step.mode >= BENT_FROM for _, step in tables.ends.phases) if tables.ends else 0
        taken = 2 * (len(driven.windows) + bent)
        self.turns_cut = min(len(found), self.turn_rows, self.room - len(pieces) - taken)
        self.turns = found[: self.turn_rows]
        inside = [*(point.at for point in found[: self.turns_cut]), *(si(at, DEGREE) for at in self.bends if at < TURN)]
        self.cycle = QuadratureCycle(driven.drive_cycle, pieces, near, inside)
        self.load: LoadPoints = replace(like.load, train=driven.train) if like else self.cycle.points()
        self.points = DrivePoints(self.load)
        self.numbers = np.arange(len(self.cycle.intervals))[:, None]
        self.point_rows = self.rows * POINTS
        turns = abs(driven.mechanism.ratio) * driven.max_geometric_velocity * driven.axis.speed
        self.speed = self.peaks.size("n") if self.varies else turns  # the largest of the motor (rad/s)

    @cached_property
    def search(self) -> RateSearch:
        """The search of the rates that hold all limits."""
        driven, peaks = self.driven, (self.peaks.size("T"), self.peaks.size("S"))
        return RateSearch(self.points, self.speed, driven.motor, driven.reducer.limits, 1.0 / self.time, peaks)

    @cached_property
    def creeping(self) -> DrivePoints:
        """The points of the drive creeping."""
        return DrivePoints((self.load if self.creeps_loaded else self.load.empty).at_rate(self.slow))

    @property
    def creep_checks(self) -> tuple[LimitCheck, ...]:
        """The drive's torques against their limits while it creeps."""
        return creep_checks(self.creeping, self.driven.motor, self.driven.reducer.limits, self.slow / self.time)

    @cached_property
    def peaks(self) -> Peaks:
        """The peaks of its quantities."""
        return Peaks(self.cycle, self.points, self.driven.train, self.varies)

    @property
    def at_peaks(self) -> "DriveView":
        """The view of the drive at its peaks, measured by the same scales."""
        _ = self.scales
        other, peaks = copy(self), self.peaks
        other.points, other.load, other.numbers = peaks.there, peaks.there.load, peaks.intervals
        other.point_rows = len(peaks.places)
        return other

    @cached_property
    def between(self) -> Interpolation:
        """The places of the samples of the sheet Cycle between the points."""
        told = self.driven.axis.unshifted(self.tables.machine.samples).x
        return self.cycle.interpolation_at(self.load.x, told)

    @cached_property
    def sampled(self) -> tuple[Array, Array]:
        """The motor's torque (Nm) and its power (W) at the samples: of a constant ratio at the speed that it has."""
        torque, axis = self.between.of(self.points.torque), self.driven.axis
        lost = self.driven.motor_used.copper * torque**2
        if self.varies:
            return torque, torque * self.between.of(self.points.speed) + lost
        _, speed, *_ = axis.motion.at_speed(axis.unshifted(self.tables.machine.samples).x, axis.speed)
        return torque, torque * self.driven.mechanism.ratio * speed + lost

    def by_interval(self, values: Array) -> list[float]:
        """Return values of the intervals; spare rows have that of the last."""
        return filled(values, self.rows, float(values[-1]))

    def by_point(self, values: Array, spare: float | None = None) -> list[float]:
        """Return values of the points, interval by interval; spare rows have that of the last point, or another."""
        flat = np.broadcast_to(values, self.load.x.shape).ravel()
        return filled(flat, self.point_rows, float(flat[-1]) if spare is None else spare)

    @property
    def edges(self) -> list[float]:
        """The edges of process forces in degrees of the motion as its phases tell it; spare ones at the end."""
        near, total = self.cycle.near, self.cycle.drive_cycle.unshifted.total
        late = self.driven.axis.shifted.shift
        edges = [(edge - late + near) % total - near for w in self.driven.windows for edge in (w.begin, w.end)]
        return filled([shown(edge, DEGREE) for edge in edges], 2 * WINDOWS, TURN)

    @property
    def inertia(self) -> float:
        """Inertia at the motor, without it, the largest over the cycle (kg m²)."""
        if not self.driven.train.inertia_varies:
            return self.driven.mechanism.inertia()
        m = self.driven.mechanism
        fixed = math.fsum(m.on_shaft(k) / m.inertia_divisor(k) for k in range(m.last))
        return fixed + m.on_shaft(m.last) * (self.travel / self.driven.train.gear) ** 2

    @property
    def inertia_ratio(self) -> float:
        """The inertia at the motor over the motor's own, 0 of a motor without."""
        own = self.driven.motor_used.inertia
        return self.inertia / own if own else 0.0

    @property
    def travel(self) -> float:
        """The most that the load moves when the mechanism's shaft turns (m or 1)."""
        return float(np.abs(self.load.slopes[0] / self.load.first).max())

    @property
    def reserve(self) -> Reserve:
        """The largest figures of a cycle, each with its limit."""
        points, peak = self.points, self.peaks.size("T")
        return reserve(self.driven.motor, points.rms_torque, peak, self.speed, points.mean_speed)

    @property
    def reducer_checks(self) -> tuple[LimitCheck, LimitCheck, LimitCheck]:
        """The peak and the mean torque behind the reducer (Nm) and the speed before it (rad/s), against its limits."""
        limits, mean = self.driven.reducer.limits, self.points.cubic_mean(self.load.output_torque)
        return (
            LimitCheck("peak torque", self.peaks.size("S"), limits.peak_at(1.0 / self.time)),
            LimitCheck("mean torque", mean, limits.mean_torque),
            LimitCheck("input speed", self.speed, limits.input_speed),
        )

    @property
    def limit_checks(self) -> dict[str, LimitCheck]:
        """The quantities at the points against each limit, by its name in the engine (Nm, rad/s)."""
        left = self.points.reserve(self.driven.motor).ravel()
        torque = np.abs(self.points.torque).ravel()
        k = int(left.argmin())
        below = LimitCheck(BELOW, float(torque[k]), float(torque[k] + left[k]))
        checks = dict(zip(("RMS torque", "peak torque", "motor speed"), self.reserve, strict=True))
        checks |= {f"reducer {check.name}": check for check in self.reducer_checks}
        return checks | {BELOW: below}

    @cached_property
    def rates(self) -> Rates:
        """The range of rates of the sheet, whose upper end is rounded down, but not below a rate that is held."""
        rates = Rates.of(self.search.range)
        if isinstance(rates.high, str):
            return rates
        steps = count_steps(rates.high)
        high = math.floor(rates.high * steps * (1.0 + ZERO)) / steps  # never above it but by a rounding
        return rates._replace(high=max(self.rate * self.search.holds, high))

    @property
    def spare(self) -> float:
        """The least that is left below the motor's curve (Nm)."""
        return float(self.points.reserve(self.driven.motor).min())

    @cached_property
    def scales(self) -> Scales:
        """The largest sizes of its quantities."""
        load, points = self.load, self.points
        torque = max(float(np.abs(points.torque).max()), LEAST)
        rpm = max(shown(self.speed, RPM), LEAST)
        power = max(shown(torque * (max(self.speed, LEAST) + self.driven.motor_used.copper * torque), KW), LEAST)
        behind = max(float(np.abs(load.output_torque).max()), LEAST)
        force = max(float(np.abs(load.force).max()), LEAST)
        turning = max(float(np.abs(load.shaft_acceleration).max()), 1e-9)
        return Scales(force, behind, torque, rpm, power, max(si(power, KW) * self.time, LEAST), turning)

    @cached_property
    def parts(self) -> dict[str, Any]:
        """The parts that texts of its cells have, and the scales that these name."""
        own = {"called": self.driven.called, "base": self.driven.axis.base}
        return self.scales._asdict() | own | {"i": self.driven.number, "number": self.driven.number}

    @property
    def energy(self) -> Energy:
        """The energy that the motor gives over a cycle, and the energy that comes back to it (J)."""
        power, time = self.points.power, self.time
        driving, returned = (self.points.mean(np.maximum(way * power, 0.0)) * time for way in (1.0, -1.0))
        return Energy(driving, returned)
