"""Judge limits by the exact engine too, and report results by points that are farther off than a sheet states."""

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain
from typing import NamedTuple

from engine.drive.limits import BELOW, REDUCER_TORQUE, at_speed, creeping
from engine.drive.motor import LimitCheck
from engine.drive.rate_range import EXACT_NAMES, rate_range
from workbook.book.checks import ZERO
from workbook.book.sentence import as_shown
from workbook.fields.units import PER_MINUTE, PERCENT, shown, si
from workbook.machines.machine.axes import REMEMBERED, axes_of, drive_of
from workbook.machines.machine.backlash import sides_of
from workbook.machines.machine.drive.max_rate import range_in_words
from workbook.machines.machine.drive.view import DriveView, Rates
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.first_sheet import RATE_CHECK
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.timing.stops import HardStop, stops_of
from workbook.machines.machine.vibration import swings_of
from workbook.machines.machine.view import MovingAxis
from workbook.template_outputs import ExactJudgement, JudgedLimit, deviations, judged_limits

RATE, GAP, MOTION = 0.01, 1e-3, 5e-4
"""by which share the sheets state that the highest rate, a least gap and the extremes of phases that meet at speed may
be off; :mod:`engine.drive.drive_points` has those of a drive's results"""
PAIRS_GAP = 0.25  # the same of a least gap by pairs, whose lines may turn between the points
ROUNDING, NEARLY = 1e-9, 0.9  # of exact uses; of a use by points that may be 1 exactly
CREEP_LIMITS = "RMS torque", REDUCER_TORQUE, "reducer mean torque"  # beside the peak torque


def drives_of(machine: AnyMachine) -> Iterator[DriveView]:
    """Yield the drives of a machine."""
    yield from filter(None, map(drive_of, axes_of(machine)))


def rate_of(view: DriveView) -> Iterator[str]:
    """Yield the line on the range of rates of a drive that is not as its sheet states, by the exact engine."""
    if ends_exactly(view):
        return
    exact = exact_rates(view)
    if not agree(view.rates, exact):
        ranges = [range_in_words(rates, "").text for rates in (exact, view.rates)]
        if ranges[0] == ranges[1]:  # so near that their rounded ends are equal
            ranges = [f"holds up to {rates.high:.12g} cycles/min" for rates in (exact, view.rates)]
        yield f"{view.driven.called}: {ranges[0]} exactly; its sheet says {ranges[1]}"


def ends_exactly(view: DriveView) -> bool:
    """Return whether, by the exact engine, limits are held at both ends of a range, and not RATE beyond the upper."""
    low, high = view.search.range[:2]
    if not 0.0 < high < math.inf:
        return False
    ends = [rate for rate in (low, high) if rate > 0.0]
    return all(held_exactly(view, end) for end in ends) and not held_exactly(view, high * (1.0 + RATE))


def held_exactly(view: DriveView, rate: float) -> bool:
    """Return whether all limits that are nearly used are held at a rate (1/s), by the exact engine."""
    uses = view.search.at(rate / view.search.rate).uses
    names = {EXACT_NAMES.get(name, name) for name, use in uses.items() if use > NEARLY}
    checks = at_speed(view.driven.limit_checks, rate * math.tau)
    return all(check.use <= 1.0 + ROUNDING for check in checks.of(names))


def agree(stated: Rates, exact: Rates) -> bool:
    """Return whether a sheet's highest rate is at most RATE below the exact rate, and never above it."""
    if isinstance(stated.high, str) or isinstance(exact.high, str):
        return stated.high == exact.high
    return (1.0 - RATE) * exact.high <= stated.high <= exact.high * (1.0 + ROUNDING)


def exact_rates(view: DriveView) -> Rates:
    """Return the exact range of rates of a drive."""
    return Rates.of(rate_range(view.driven.limit_checks).times(1.0 / math.tau))


def judgement(machine: AnyMachine) -> ExactJudgement:
    """Return the limits of all drives as sheets and the exact engine have them, and lines on results and on rates."""
    rows = axes_of(machine)
    views = list(filter(None, map(drive_of, rows)))
    drives = list(map(judge_drive, views))
    lines = list(chain.from_iterable(drive.lines for drive in drives))
    gaps = [ClearanceView(clearance, k, rows) for k, clearance in enumerate(machine.clearances, 1)]
    lines += filter(None, map(gap_of, gaps))
    lines += (line for row in rows for line in extremes_of(row.axis))
    swings = swings_of(rows)
    lines += filter(None, (swing.deviation for swing in swings))
    stops = [swing.limit for swing in swings if swing.entered.settled is not None]
    stops += [side.limit for side in sides_of(views)]
    stops += [limit_of_stop(stop) for row in rows for stop in stops_of(row.axis)]
    limits = chain.from_iterable(drive.limits for drive in drives)
    rates = sorted((drive.at_rate for drive in drives), key=lambda limit: -limit.exact.use)[:1]
    return ExactJudgement([*limits, *rates, *map(limit_of_gap, gaps), *stops], lines)


class JudgedDrive(NamedTuple):
    """The limits of a drive, at its own rate and creeping, and at the machine's; lines on its results and its rates."""

    limits: list[JudgedLimit]
    at_rate: JudgedLimit
    lines: list[str]


@lru_cache(REMEMBERED)
def judge_drive(view: DriveView) -> JudgedDrive:
    """Return the judgement of the exact engine on a drive."""
    limits, rate = limits_of(view), view.tables.machine.given.per_minute
    at_rate = limit_of_rate(view, limits, rate)
    return JudgedDrive([*limits, *limit_of_creeping(view)], at_rate, [*results_of(view), *rate_of(view)])


def limit_of_rate(view: DriveView, limits: Sequence[JudgedLimit], rate: float) -> JudgedLimit:
    """Return the limit of a drive that is used most at the machine's rate (cycles/min), of its ``limits`` at its own.

    It stands for the check of the rate; near a limit, the drive's own check warns.
    """
    if view.driven.entered.rate is None:
        return max(limits, key=lambda limit: limit.exact.use)._replace(check=RATE_CHECK, bound=0.0)
    exact = at_speed(view.driven.limit_checks, si(rate, PER_MINUTE) * math.tau).worst
    where, use = f"at {as_shown(rate)} cycles/min", max(view.search.at(rate / view.rate).uses.values())
    return limit_in_percent(RATE_CHECK, view, where, exact.name, use, exact.use)


def limit_in_percent(check: str, view: DriveView, where: str, name: str, *uses: float) -> JudgedLimit:
    """Return the most used limit of a drive, by its use on the sheet and by the exact engine, for a check."""
    sheet, truth = (LimitCheck(name, shown(use, PERCENT), shown(1.0, PERCENT)) for use in uses)
    return JudgedLimit(check, view.driven.called, f"{where} the most used limit, {name},", "%", sheet, truth, 0.0)


class AtLeast(LimitCheck):
    """A gap or a position against the least that it must be."""

    @property
    def ok(self) -> bool:
        """Whether it is as much."""
        return self.value >= self.limit

    @property
    def use(self) -> float:
        """Infinity, since a gap of 0 or a limit of 0 has no share."""
        return math.inf


def limit_of_gap(gap: ClearanceView) -> JudgedLimit:
    """Return the least gap of a clearance as its sheet and as the exact engine have it; rounding breaks none."""
    sheet, truth = (AtLeast("least gap", value + ZERO * gap.size, gap.given.least) for value in (gap.least, gap.exact))
    return JudgedLimit(f"clear{gap.number}_kept", gap.given.name, "least gap", gap.unit, sheet, truth, 0.0)


def limit_of_stop(stop: HardStop) -> JudgedLimit:
    """Return how far an axis goes towards a hard stop as its sheet and as the exact engine have it."""
    what, kind = ("lowest position", AtLeast) if stop.end == "low" else ("highest position", LimitCheck)
    limit = stop.position + stop.outwards * stop.tolerance
    sheet, exact = (
        kind(what, stop.reached_by(motion), limit) for motion in (stop.axis.motion, stop.axis.joined.motion)
    )
    return JudgedLimit(f"{stop.name}_kept", stop.axis.given.name, what, stop.axis.given.unit, sheet, exact, 0.0)


def limits_of(view: DriveView) -> list[JudgedLimit]:
    """Return the limits of a drive."""
    driven = view.driven
    return judged_limits(driven.called, f"drive{driven.number}_", view.limit_checks, driven.limit_checks)


def limit_of_creeping(view: DriveView) -> Iterator[JudgedLimit]:
    """Yield the limit of a drive that is used most while it creeps, if it nearly is."""
    use = max(check.use for check in view.creep_checks)
    if use <= NEARLY:
        return
    checks = creeping(view.driven.limit_checks, view.creeps_loaded)
    exact = max(checks.of([BELOW, *CREEP_LIMITS]), key=lambda check: check.use)
    exactly = 1.0 if 1.0 < exact.use <= 1.0 + ROUNDING else exact.use
    check = f"drive{view.driven.number}_ok_creep"
    yield limit_in_percent(check, view, "creeping at 1 cycle/min", exact.name, use, exactly)


def extremes_of(axis: MovingAxis) -> Iterator[str]:
    """Yield a line for each phase that meets its neighbours at speed, and is slower than its sheet states."""
    for i, k in enumerate(axis.entered, 1):
        exact, by_points = axis.joined.motion.phases[k], axis.motion.phases[k]
        for what, true, stated in (
            ("velocity", exact.y1_max, by_points.y1_max),
            ("acceleration", exact.y2_max, by_points.y2_max),
        ):
            if abs(stated - true) > MOTION * true:
                more = as_shown(100.0 * (true / stated - 1.0))
                yield f"{axis.given.name} row {i}: the greatest {what} is {more} % more"


def gap_of(gap: ClearanceView) -> str:
    """Return the line on a least gap, empty where it is as exact as its sheet states."""
    exact, unit = gap.exact, gap.unit
    if abs(gap.least - exact) <= (PAIRS_GAP if gap.table else GAP) * gap.change + 1e-9 * gap.size:
        return ""
    return f"{gap.given.name}: the least gap is {as_shown(exact)} {unit} exactly; its sheet says {as_shown(gap.least)}"


def results_of(view: DriveView) -> Iterator[str]:
    """Yield a line for each result of a drive that is farther off than stated."""
    points, (driving, regenerated) = view.points, view.energy
    sheet = {
        "RMS torque": points.rms_torque,
        "highest torque": view.peaks.top("T"),
        "lowest torque": -view.peaks.top("T", -1),
        "speed": view.speed,
        "mean speed": points.mean_speed,
        "peak torque behind the reducer": view.peaks.size("S"),
        "mean torque behind the reducer": points.cubic_mean(view.load.output_torque),
        "highest power": max(0.0, view.peaks.top("P")),
        "lowest power": min(0.0, -view.peaks.top("P", -1)),
        "mean power": (driving - regenerated) / view.time,
        "energy driven": driving,
        "energy regenerated": regenerated,
    }
    return deviations(view.driven.called, sheet, view.driven.limit_checks)
