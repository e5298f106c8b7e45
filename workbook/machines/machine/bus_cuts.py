"""Bounds of the power on the common DC bus: in each half of an interval a drive takes between two straight lines."""

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from engine.drive.rate_estimates import TINY
from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Sheet
from workbook.book.rows import SHARES, filled
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, shown
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

CUTS = (
    "In each half of an interval a drive takes at most what a straight line says, and at least what one below it does: "
    "the sums of these lines between two cuts of any drive bound the bus, whatever its samples miss."
)
HALF = POINTS // 2  # points from the begin of an interval to its middle, and from there to its end
SMALL = 1e-9  # share of a drive's larger peak up to which the other is none; the cells' check_zero
kw = partial(shown, unit=KW)


SHORT = 1e-3  # degrees: the line of a shorter half is level


def inner_shares(half: int) -> tuple[float, ...]:
    """Return the shares of a half of an interval, the first (0) or the second (1), at which its inner points lie."""
    return tuple(2.0 * share - half for share in SHARES[1 + HALF * half : HALF * (1 + half)])


class HalfPowers(NamedTuple):
    """The power of a drive in the halves of its intervals, and a straight line from their first points: arrays."""

    begin: Array  # of the half (°)
    length: Array  # of the half (°)
    first: Array  # power at its begin (W)
    rise: Array  # of the line to its end (W)
    above: Array  # by which points lie above the line at most (W)
    below: Array  # by which they lie below it (W)


def half_powers(view: DriveView) -> HalfPowers:
    """Return the lines of a drive's power; spare halves are at the end of the cycle, without length."""
    x, power, rows = shown(view.load.x, DEGREE), view.points.power, 2 * view.rows
    halves = [np.stack([each[:, : HALF + 1], each[:, HALF:]], axis=1).reshape(-1, HALF + 1) for each in (x, power)]
    begin, length = halves[0][:, 0], halves[0][:, -1] - halves[0][:, 0]
    first = halves[1][:, 0]
    rise = np.where(length < SHORT, 0.0, halves[1][:, -1] - first)
    shares = np.array([[*inner_shares(half), 1.0] for half in (0, 1)] * (len(begin) // 2))
    off = halves[1][:, 1:] - first[:, None] - rise[:, None] * shares
    each = (begin, length, first, rise, np.maximum(off.max(axis=1), 0.0), np.maximum(-off.min(axis=1), 0.0))
    spare = (TURN, 0.0, float(power[-1, -1]), 0.0, 0.0, 0.0)
    return HalfPowers(*(np.array(filled(*column)) for column in zip(each, [rows] * len(each), spare, strict=True)))


class BusCuts:
    """Bounds of the power on the bus between the ``cuts`` of all its drives, the begins of halves of their intervals.

    ``begin`` and ``end`` of these halves of all drives are in degrees of the master shaft. There a drive takes from
    the bus at most ``most``, ``climbs`` more a degree, and at least ``least``, ``grows`` more a degree (W, W/°); less
    than 0 comes back. From each cut to the next all take at most ``sum_most``, ``sum_climbs`` more at the next, and at
    least ``sum_least``, ``sum_grows`` more. ``shares`` are the ``peaks`` of each drive, on the mains and in its
    resistor (W), over the largest powers at its points: 0 for a drive that is not ``on_bus``. ``alone`` are the sums
    of these peaks of all drives that are.
    """

    def __init__(self, drives: Sequence[DriveView], on_bus: Array, peaks: Array) -> None:
        self.drives, near = drives, drives[0].tables.machine.near
        self.alone: list[float] = (peaks @ on_bus).tolist()
        powers = np.array([(view.points.power.max(), -view.points.power.min()) for view in drives]).T
        counted = powers > SMALL * peaks[::-1]
        self.shares = on_bus * np.divide(peaks, powers, out=np.zeros(peaks.shape), where=counted)
        tables = [half_powers(view) for view in drives]
        counts = [table.begin.size for table in tables]
        self.halves = halves = HalfPowers(*(np.concatenate(column) for column in zip(*tables, strict=True)))
        (up, down), top = np.repeat(self.shares, counts, axis=1), np.repeat(peaks[0], counts)
        high, low = halves.first + halves.above, halves.first - halves.below
        lasting = halves.length + TINY
        self.most = np.maximum(up * high, down * high)
        self.climbs = (np.maximum(up * (high + halves.rise), down * (high + halves.rise)) - self.most) / lasting
        share = np.where(low + np.minimum(halves.rise, 0.0) > SMALL * top, up, down)
        self.least, self.grows = share * low, share * halves.rise / lasting

        at = halves.begin + np.repeat([view.driven.axis.given.shift for view in drives], counts)
        self.begin = at - TURN * np.floor((at + near) / TURN)
        self.end = self.begin + halves.length
        self.cuts = np.sort(self.begin) + near / 2.0
        self.span = np.diff(self.cuts, append=self.cuts[0] + TURN)
        here = self.cuts[:, None]
        acts = ((self.begin < here) & (here < self.end)) | (here + TURN < self.end)
        since = here - self.begin + TURN * (self.begin > here)
        self.sum_most, self.sum_least = (
            (acts * (line + slope * since)).sum(axis=1)
            for line, slope in ((self.most, self.climbs), (self.least, self.grows))
        )
        self.sum_climbs, self.sum_grows = self.span * (acts @ self.climbs), self.span * (acts @ self.grows)

    @property
    def peak_most(self) -> float:
        """The most that the bus takes from the mains (W)."""
        most = float((self.sum_most + np.maximum(self.sum_climbs, 0.0)).max())
        return max(0.0, min(self.alone[0], most))

    @property
    def burnt_most(self) -> float:
        """The most that goes into its resistor (W)."""
        most = float((-self.sum_least - np.minimum(self.sum_grows, 0.0)).max())
        return max(0.0, min(self.alone[1], most))

    @property
    def sure(self) -> Array:
        """What the bus takes or burns from each cut to the next in the mean at least (W)."""
        high, low = self.sum_most + self.sum_climbs / 2.0, self.sum_least + self.sum_grows / 2.0
        return np.asarray(np.maximum(0.0, np.maximum(low, -high)))

    @property
    def sure_mean(self) -> float:
        """The mean of :attr:`sure` over the cycle (W)."""
        return float(self.span @ self.sure / TURN)


def cuts_table(sheet: Sheet, cuts: BusCuts) -> None:
    """Declare the lines of each drive in the halves of its intervals, and what all add up to between cuts."""
    cell, halves = CELLS["bus_cuts"], cuts.halves
    each = [(row, drive.driven.number) for row, drive in enumerate(cuts.drives, 1) for _ in range(2 * drive.rows)]
    first = [1 + POINTS * k + side for drive in cuts.drives for k in range(drive.rows) for side in (0, HALF)]
    numbers = [number for _, number in each]
    shares = [list(column) for column in zip(*(inner_shares(half) for half in (0, 1)), strict=True)]
    names = [f"s{n}" for n in range(1, HALF)]
    at = "INDEX(drive{0}_at,[k])+[axes_taken.late.{0}]"
    points = [f"INDEX(drive{{0}}_P,[k]+{n})-[first]-[{name}]*[rise]" for n, name in enumerate(names, 1)]
    points.append(f"INDEX(drive{{0}}_P,[k]+{HALF})-[first]-[rise]")
    acts = "([bus_cuts.from]<[at])*([at]<[bus_cuts.to])+([at]+360<[bus_cuts.to])"
    since = "([at]-[bus_cuts.from]+360*([bus_cuts.from]>[at]))"

    def of_drives(formula: str) -> list[str]:
        return [f"={formula}".replace("{0}", str(number)) for number in numbers]

    def line(power: str) -> list[str]:
        return [power.format(up=f"[power.up.{row}]", down=f"[power.down.{row}]", row=row) for row, _ in each]

    high, low = "([first]+[above])", "([first]-[below])"
    end = high.replace(")", "+[rise])")
    share = f"IF({low}+MIN(0,[rise])>check_zero*[power.peak.{{row}}],{{up}},{{down}})"
    sheet.heading("Bounds of the power of the bus", CUTS)
    sheet.table(
        "bus_cuts",
        "Halves of the intervals of all drives, and what they add up to between all cuts",
        len(each),
        cell("row", list(range(1, len(each) + 1))),
        cell("axis", numbers),
        cell("k", first),
        *(cell(name, column * (len(each) // 2)) for name, column in zip(names, shares, strict=True)),
        cell("from", cuts.begin, formula=of_drives(f"{at}-360*INT(({at}+eps)/360)"), scale=TURN),
        cell(
            "to",
            cuts.end,
            formula=of_drives(f"[from]+INDEX(drive{{0}}_at,[k]+{HALF})-INDEX(drive{{0}}_at,[k])"),
            scale=TURN,
        ),
        cell("first", kw(halves.first), formula=of_drives("INDEX(drive{0}_P,[k])")),
        cell(
            "rise",
            kw(halves.rise),
            formula=of_drives(f"IF([to]-[from]<{SHORT},0,INDEX(drive{{0}}_P,[k]+{HALF})-[first])"),
        ),
        cell("above", kw(halves.above), formula=of_drives(f"MAX(0,{','.join(points)})")),
        cell("below", kw(halves.below), formula=of_drives(f"MAX(0,{','.join(f'0-({point})' for point in points)})")),
        cell("draws", kw(cuts.most), formula=line(f"=MAX({{up}}*{high},{{down}}*{high})")),
        cell(
            "climbs", kw(cuts.climbs), formula=line(f"=(MAX({{up}}*{end},{{down}}*{end})-[draws])/([to]-[from]+tiny)")
        ),
        cell("least", kw(cuts.least), formula=line(f"={share}*{low}")),
        cell("grows", kw(cuts.grows), formula=line(f"={share}*[rise]/([to]-[from]+tiny)")),
        cell("at", cuts.cuts, scale=TURN),
        cell("span", cuts.span, len=len(each), scale=TURN),
        cell("most", kw(cuts.sum_most), acts=acts, since=since),
        cell("more", kw(cuts.sum_climbs), acts=acts),
        cell("all_least", kw(cuts.sum_least), acts=acts, since=since),
        cell("all_more", kw(cuts.sum_grows), acts=acts),
        cell("sure", kw(cuts.sure)),
    )
