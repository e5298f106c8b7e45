"""The rates at which a drive holds all its limits, by the points of its cycle: once estimated, once tried.

With T_s the torque at standstill and I = T − T_s, a rate of √x times the present rate takes T_s + x I: so a first range
is estimated. Near its upper end the points are worked out anew, and between them and the present ones each limit's use
is a straight line over x. Torques are convex in x where losses change sides, so that the line is on the safe side. With
viscous friction that grows with the rate itself the line is over a power of the rate between both, of each limit.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from engine.drive import Motor
from engine.drive.drive_points import DrivePoints
from engine.drive.limits import BELOW, CYCLES, NEAR, PEAK_TORQUE, REDUCER_TORQUE, ReducerLimits
from engine.drive.motor import LimitCheck
from engine.drive.rate_estimates import (
    ASTRAY,
    BEYOND,
    HAIR,
    LEAST_USE,
    NO_LIMIT,
    SPEEDS,
    TARGET,
    TARGET_BETWEEN,
    TARGET_CURVE,
    Ends,
    Estimate,
    RateRange,
    Shares,
    estimates_of,
    growth_power,
    largest,
    power_through,
    use_below,
)


@dataclass(frozen=True)
class RateSearch:
    """A drive at the points of its cycle, at the present rate and at another; limits are named by their names."""

    points: DrivePoints
    speed: float  # largest of the motor (rad/s)
    motor: Motor
    reducer: ReducerLimits
    rate: float  # the present rate (1/s)
    sought: tuple[float, float] | None = None  # peak torques now, before and behind the reducer (Nm)

    @cached_property
    def estimates(self) -> dict[str, Estimate]:
        """The estimate of each limit; of the reducer's peak torque in full, and beyond its cycles."""
        return estimates_of(self.points, self.speed, self.motor, self.reducer)

    @cached_property
    def estimated(self) -> dict[str, Ends]:
        """The estimated range of each limit; beyond its cycles a reducer's full torque is held up to these."""
        growth = growth_power(self.points)
        ends = {
            name: Ends(estimate.least * self.rate, estimate.most(2.0 if name in SPEEDS else growth) * self.rate)
            for name, estimate in self.estimates.items()
        }
        cycles = self.estimates[CYCLES]
        ends[CYCLES] = Ends(0.0, self._beyond_full(ends[CYCLES].high, cycles.standing / cycles.limit))
        return ends

    def _beyond_full(self, high: float, use: float) -> float:
        """Return up to which rate (1/s) the reducer's torque at its cycles is held, where it begins at a use of it."""
        return max(self.reducer.full_rate, high if use < 1.0 else 0.0)

    @property
    def estimate(self) -> float:
        """The estimated upper end (1/s); the present rate if there is none."""
        most = min(ends.high for ends in self.estimated.values())
        return most if math.isfinite(most) else self.rate

    @cached_property
    def holds(self) -> bool:
        """Whether all limits are held at the present rate."""
        return max(self.uses.values()) <= 1.0

    @cached_property
    def tried_holds(self) -> bool:
        """Whether all limits are held at the tried rate."""
        return max(self.uses_tried.values()) <= 1.0

    def at(self, factor: float) -> "RateSearch":
        """Return the drive at another rate, ``factor`` times the present rate."""
        points = DrivePoints(self.points.load.at_rate(factor))
        return replace(self, points=points, speed=self.speed * factor, rate=self.rate * factor, sought=None)

    @cached_property
    def peaks(self) -> tuple[float, float]:
        """The peak torques at the present rate, before and behind the reducer (Nm)."""
        points = self.points
        return self.sought or (points.size(points.torque), points.size(points.load.output_torque))

    @cached_property
    def over(self) -> tuple[float, ...]:
        """These peaks over the largest torque at a point."""
        each = zip(self.peaks, (self.points.torque, self.points.load.output_torque), strict=True)
        return tuple(peak / most if (most := largest(values)) else 1.0 for peak, values in each)

    @property
    def astray(self) -> float:
        """The rate by which the estimate may be off (1/s)."""
        return BEYOND * self.estimate + ASTRAY * abs(self.estimate - self.rate)

    @cached_property
    def tried(self) -> float:
        """The rate at which the points are worked out anew (1/s): beyond the estimate, or below if not all holds."""
        return self.estimate + self.astray if self.holds else max(self.estimate - self.astray, 0.5 * self.estimate)

    @cached_property
    def factor(self) -> float:
        """The tried rate over the present rate."""
        return self.tried / self.rate

    @cached_property
    def points_tried(self) -> DrivePoints:
        """The points at the tried rate."""
        return self.at(self.factor).points

    @cached_property
    def uses(self) -> dict[str, float]:
        """The use of each limit at the present rate."""
        return {name: check.use for name, check in self._checks(self.points, *self.peaks, 1.0).items()}

    @cached_property
    def uses_tried(self) -> dict[str, float]:
        """The use of each limit at the tried rate; peaks are as far beyond those of the points as at the present."""
        points, (motor, behind) = self.points_tried, self.over
        peaks = largest(points.torque) * motor, largest(points.load.output_torque) * behind
        return {name: check.use for name, check in self._checks(points, *peaks, self.factor).items()}

    def _checks(self, points: DrivePoints, peak: float, behind: float, factor: float) -> Mapping[str, LimitCheck]:
        """Return the figures of each limit by its name, with the peak torques (Nm) before and behind the reducer."""
        motor, reducer, speed = self.motor, self.reducer, self.speed * factor
        full, fall = reducer.peak_torque, motor.falling.fall
        beyond = self.rate * factor > reducer.full_rate * (1.0 + NEAR)
        checks = [
            LimitCheck("RMS torque", points.rms_torque, float(motor.continuous(points.mean_speed))),
            LimitCheck(PEAK_TORQUE, peak, motor.peak_torque),
            LimitCheck("motor speed", speed, motor.max_speed),
            LimitCheck("reducer input speed", speed, reducer.input_speed),
            LimitCheck(REDUCER_TORQUE, behind, full),
            LimitCheck(CYCLES, behind if beyond else 0.0, full / reducer.cycle_factor),
            LimitCheck("reducer mean torque", points.cubic_mean(points.load.output_torque), reducer.mean_torque),
        ]
        if fall:
            used = np.abs(points.torque) + fall * np.abs(points.speed)
            checks.append(LimitCheck(BELOW, float(used.max()), motor.falling.corner(motor.peak_torque)))
        return {check.name: check for check in checks}

    @property
    def target(self) -> float:
        """The use of a limit at the ends of the range, less than 1 for what lies between points."""
        train = self.points.load.train
        return TARGET if train.has_constant_ratio and not train.is_viscous else TARGET_BETWEEN

    @cached_property
    def begin(self) -> int:
        """The rate to interpolate from: 0 the present rate if it holds, else 1 the tried, else 2 standstill."""
        return 0 if self.holds else 1 if self.tried_holds else 2

    @cached_property
    def way(self) -> tuple[float, float]:
        """The factors of the rate between which is interpolated."""
        return ((1.0, self.factor), (self.factor, 1.0), (0.0, self.factor))[self.begin]

    def order(self, name: str) -> float:
        """Return the power of the rate over which what a limit is used by is a straight line between two rates.

        As of inertia it is 2. Viscous friction and speed grow with the rate itself: through both rates and standstill,
        or no use if there is no less at standstill, a power is drawn; A n + B n² lies below it between both rates, and
        beyond them below a line over the square.
        """
        if not (self.points.load.train.is_viscous or name == BELOW) or (self.holds and self.share(name) < 1.0):
            return 2.0
        rest, now, then = self.uses_at_rates(name)
        most = growth_power(self.points) if use_below(rest, now, then) < rest else 2.0
        return max(1.0, min(most, self.power(name)))

    def power(self, name: str) -> float:
        """Return the power of the rate that the use of a limit at both rates and at standstill tells."""
        rest, now, then = self.uses_at_rates(name)
        return power_through(use_below(rest, now, then), now, then, self.factor)

    def uses_at_rates(self, name: str) -> tuple[float, float, float]:
        """Return the use of a limit at standstill, the present rate and the tried; 0 where it is not there.

        Of the reducer's torque at its cycles it is that of its full torque.
        """
        name = REDUCER_TORQUE if name == CYCLES else name
        estimate = self.estimates.get(name)
        standing = estimate.standing / estimate.limit if estimate else 0.0
        return standing, self.uses.get(name, 0.0), self.uses_tried.get(name, 0.0)

    @cached_property
    def caps(self) -> dict[str, float]:
        """The use of each limit at the ends of the range; of torques at points the largest of these (Nm)."""
        motor, behind = self.over
        caps = dict.fromkeys(self.estimates, self.target)
        for name in (PEAK_TORQUE, REDUCER_TORQUE, CYCLES):
            caps[name] *= min(self.estimates[name].limit, NO_LIMIT) / (motor if name == PEAK_TORQUE else behind)
        if BELOW in caps:
            caps[BELOW] = TARGET_CURVE
        return caps

    @cached_property
    def between(self) -> dict[str, tuple[Shares, ...]]:
        """The shares of each limit: from the present rate to the tried, back, and from standstill.

        From a rate that does not hold nothing is interpolated: its shares are 0.
        """
        now, then = self.points, self.points_tried
        torques = now.standing, now.torque, then.torque
        behind = now.load.output_torque_at_rest, now.load.output_torque, then.load.output_torque
        begins = self.holds, self.tried_holds, True
        shares = {}
        for name, estimate in self.estimates.items():
            rest, present, tried = torques if name == PEAK_TORQUE else behind
            if name in (PEAK_TORQUE, REDUCER_TORQUE, CYCLES):
                ways = (present, tried), (tried, present), (rest, tried)
                each = (Shares.of_torques(*way, self.caps[name]) for way in ways)
            else:
                used = estimate.standing / estimate.limit, self.uses[name], self.uses_tried[name]
                each = (Shares.of_uses(*way, self.caps[name]) for way in (used[1:], used[:0:-1], used[::2]))
            shares[name] = tuple(
                share if is_begin else Shares(0.0) for share, is_begin in zip(each, begins, strict=True)
            )
        return shares

    @cached_property
    def ends(self) -> dict[str, Ends]:
        """The range of each limit by lines between the points at both rates."""
        return {name: self._ends(name) for name in self.estimates}

    def share(self, name: str) -> float:
        """Return the inverse of the part of the way between both rates after which a limit is reached, or 0."""
        return max(self.between[name][self.begin]) if name in self.between else 0.0

    def part(self, name: str) -> float:
        """Return the part of the way between both rates after which a limit is reached, or infinite."""
        share = self.share(name)
        return 1.0 / share - LEAST_USE if share > LEAST_USE else math.inf  # the largest at once

    def met(self, name: str) -> float:
        """Return the rate (1/s) at which a limit is reached by the line between both rates, or infinite."""
        order, part = self.order(name), self.part(name)
        begin, end = (factor**order for factor in self.way)
        power = begin + (end - begin) * part if math.isfinite(part) else math.inf
        met = self.rate * max(0.0, power) ** (1.0 / order)
        return self._beyond_full(met, self.cycles_use[self.begin]) if name == CYCLES else met

    def _ends(self, name: str) -> Ends:
        (begin, end), estimated, met = self.way, self.estimated[name], self.met(name)
        if end < begin:
            return Ends(met if math.isfinite(met) else 0.0, self.tried)
        if name in SPEEDS:
            met = estimated.high * (1.0 - HAIR if self.points.load.train.has_constant_ratio else self.target)
        return Ends(estimated.low, met)

    @property
    def cycles_use(self) -> tuple[float, float, float]:
        """The use of the reducer's torque at its cycles: at the present rate, at the tried, at standstill."""
        stands, more = self.estimates[CYCLES], self.reducer.cycle_factor
        return self.uses[REDUCER_TORQUE] * more, self.uses_tried[REDUCER_TORQUE] * more, stands.standing / stands.limit

    @cached_property
    def released(self) -> float:
        """The rate (1/s) beyond which the first of the dwells that the brake holds is too short for it; or infinite."""
        time = self.points.load.train.brake.time
        return self.rate * self.points.shortest_braked_dwell / time if time > 0.0 else math.inf

    @cached_property
    def limits_ends(self) -> Ends:
        """Return the lowest and the highest rate at which all limits are held; where no rate is, they cross."""
        low = max(ends.low for ends in self.ends.values())
        high = min(ends.high for ends in self.ends.values())
        if not self.holds:
            return Ends(low, high)
        if not self.tried_holds and math.isfinite(self.released):
            high = min(high, self.released)
        return Ends(low if math.isinf(low) else min(low, self.rate), max(high, self.rate))

    @cached_property
    def range(self) -> RateRange:
        """The range that holds the present rate if any does, else the highest."""
        low_limit = max(self.ends, key=lambda name: self.ends[name].low)
        high_limit = min(self.ends, key=lambda name: self.ends[name].high)
        low, high = self.limits_ends
        if low >= high:
            return RateRange(0.0, 0.0, low_limit, low_limit)
        return RateRange(low, high, low_limit if low else "", high_limit if math.isfinite(high) else "")
