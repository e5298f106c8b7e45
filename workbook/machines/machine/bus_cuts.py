"""Bounds of the power on the common DC bus: in each half of an interval a drive takes between two straight lines."""

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Sheet
from workbook.book.rows import SHARES, filled
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, shown
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

ROUNDED = 1e-4  # by so much, times the larger peak over it, a share of a small power may be off more than others
HALF = POINTS // 2  # points from the begin of an interval to its middle, and from there to its end
SMALL = 1e-9  # share of a drive's larger peak up to which the other is none; the cells' check_zero
kw = partial(shown, unit=KW)


INNER = np.array([SHARES[1:HALF], SHARES[HALF + 1 : -1]]) * 2.0 - [[0.0], [1.0]]
"""the shares of both halves of an interval at which their inner points lie"""
SHORT = 1e-3  # degrees: the line of a shorter half is level


BEGUN = "[at]-[bus_cuts.from]+360*([bus_cuts.from]>[at])"
ACTS, SINCE = f"({BEGUN}<[bus_cuts.len])", f"({BEGUN})"
"""in cells: whether a half acts behind a cut, and how far it has come there"""

BOUNDS = (
    ",SUMPRODUCT(MAX([bus_cuts.most]+([bus_cuts.more]>0)*[bus_cuts.more]))",
    ",SUMPRODUCT(MAX(0-[bus_cuts.all_least]-([bus_cuts.all_more]<0)*[bus_cuts.all_more]))",
    ",bus_apart-(bus_net+SUMPRODUCT([bus_cuts.span],[bus_cuts.sure])/360)/2",
)
"""in cells: the most that the bus takes, burns and saves between its cuts, each behind other bounds of the same"""


class HalfLines(NamedTuple):
    """The power of drives in halves of their intervals, beside straight lines: arrays, in degrees and W."""

    begin: Array  # of the half
    length: Array  # of the half
    first: Array  # power at its begin, where the line begins
    rise: Array  # of the line to its end
    above: Array  # by which points lie above the line at most
    below: Array  # by which they lie below it


def half_lines(view: DriveView) -> HalfLines:
    """Return the lines of a drive's power; spare halves are at the end of the cycle, without length."""
    load_at, power = shown(view.load.x, DEGREE), view.points.power
    at, power = (
        np.stack([each[:, : HALF + 1], each[:, HALF:]], axis=1).reshape(-1, HALF + 1) for each in (load_at, power)
    )
    first, length = power[:, 0], at[:, -1] - at[:, 0]
    rise = np.where(length < SHORT, 0.0, power[:, -1] - first)
    shares = np.tile(np.column_stack([INNER, (1.0, 1.0)]), (len(at) // 2, 1))
    off = power[:, 1:] - first[:, None] - rise[:, None] * shares
    above, below = np.maximum(off.max(axis=1), 0.0), np.maximum(-off.min(axis=1), 0.0)
    each = at[:, 0], length, first, rise, above, below
    spare = TURN, 0.0, float(power[-1, -1]), 0.0, 0.0, 0.0
    columns = zip(each, spare, strict=True)
    return HalfLines(*(np.array(filled(column, 2 * view.rows, end)) for column, end in columns))


class BusCuts:
    """Bounds of the power on the bus between the ``cuts`` of all its drives, the begins of halves of their intervals.

    The ``begin`` of these halves is in degrees of the master shaft. There a drive takes from the bus at most
    ``most``, ``climbs`` more a degree, and at least ``least``, ``grows`` more a degree (W, W/°); less than 0 comes
    back. From each cut to the next all take at most ``sum_most``, ``sum_climbs`` more at the next, and at least
    ``sum_least``, ``sum_grows`` more. ``shares`` are the ``peaks`` of each drive, on the mains and in its resistor (W),
    over the largest powers at its points: 0 for a drive that is not ``on_bus``; ``alone`` are the sums of these peaks.
    From the mains the bus takes at most ``peak_most``, into its resistor go at most ``burnt_most`` (W); ``sure`` is the
    least that it takes or burns in the mean from each cut to the next (W). The ``bounds`` by the cuts in cells are
    empty where no drives ``meet``: the peaks of one alone bound it.
    """

    def __init__(self, drives: Sequence[DriveView], on_bus: Array, peaks: Array) -> None:
        self.drives, near = drives, drives[0].tables.machine.near
        self.meet = len(drives) > 1
        self.bounds = BOUNDS if self.meet else ("", "", "")
        self.alone: list[float] = (peaks @ on_bus).tolist()
        tops = np.array([(view.points.power.max(), -view.points.power.min()) for view in drives]).T
        counted = tops > SMALL * peaks[::-1]
        self.shares = on_bus * np.divide(peaks, tops, out=np.zeros(peaks.shape), where=counted)
        beside = np.divide(peaks[::-1], tops, out=np.zeros(peaks.shape), where=counted)
        self.share_scales = np.maximum(1.0, ROUNDED * beside.max(axis=1)).tolist()
        tables = [half_lines(view) for view in drives]
        counts = [table.begin.size for table in tables]
        self.lines = lines = HalfLines(*map(np.concatenate, zip(*tables, strict=True)))
        self.inner = np.tile(INNER, (lines.begin.size // 2, 1))
        (up, down), top = np.repeat(self.shares, counts, axis=1), np.repeat(peaks[0], counts)
        high = lines.first + lines.above
        low = lines.first - lines.below
        lasting = np.maximum(lines.length, SHORT)
        end = high + lines.rise
        self.most = np.maximum(up * high, down * high)
        self.climbs = (np.maximum(up * end, down * end) - self.most) / lasting
        share = np.where(low + np.minimum(lines.rise, 0.0) > SMALL * top, up, down)
        self.least, self.grows = share * low, share * lines.rise / lasting

        at = lines.begin + np.repeat([view.driven.axis.given.shift for view in drives], counts)
        self.begin = at - TURN * np.floor((at + near) / TURN)
        self.cuts = np.sort(self.begin) + near / 2.0
        self.span = np.diff(self.cuts, append=self.cuts[0] + TURN)
        here = self.cuts[:, None]
        since = here - self.begin + TURN * (self.begin > here)
        acts = since < lines.length
        since *= acts
        self.sum_most = acts @ self.most + since @ self.climbs
        self.sum_least = acts @ self.least + since @ self.grows
        self.sum_climbs = self.span * (acts @ self.climbs)
        self.sum_grows = self.span * (acts @ self.grows)
        most = self.sum_most + np.maximum(self.sum_climbs, 0.0), -self.sum_least - np.minimum(self.sum_grows, 0.0)
        bounds = [float(each.max()) for each in most] if self.meet else self.alone
        high, low = self.sum_most + self.sum_climbs / 2.0, self.sum_least + self.sum_grows / 2.0
        self.sure: Array = np.maximum(0.0, np.maximum(low, -high))
        self.peak_most, self.burnt_most = (max(0.0, min(each)) for each in zip(self.alone, bounds, strict=True))


def cuts_table(sheet: Sheet, cuts: BusCuts) -> None:
    """Declare the lines of each drive in the halves of its intervals, and what all add up to between cuts."""
    cell, lines = CELLS["bus_cuts"], cuts.lines
    counts, numbers = [2 * drive.rows for drive in cuts.drives], [drive.driven.number for drive in cuts.drives]
    row, number = (np.repeat(each, counts).tolist() for each in (range(1, len(counts) + 1), numbers))
    first = [1 + POINTS * k + side for count in counts for k in range(count // 2) for side in (0, HALF)]
    # a difference of powers, exact to their own digits, over some degrees
    slope = sheet.sizes.get("kW", 0.0)
    cell.begin(sheet)
    cell.place(
        sheet,
        cell("axis", number),
        cell("k", first),
        *(cell(f"s{n}", shares.tolist()) for n, shares in enumerate(cuts.inner.T, 1)),
        cell("from", cuts.begin, n=number, scale=TURN),
        cell("len", lines.length, n=number, scale=TURN),
        cell("first", kw(lines.first), n=number),
        cell("rise", kw(lines.rise), n=number, short=SHORT),
        cell("above", kw(lines.above), n=number),
        cell("below", kw(lines.below), n=number),
        cell("draws", kw(cuts.most), row=row),
        cell("climbs", kw(cuts.climbs), row=row, short=SHORT, scale=slope),
        cell("least", kw(cuts.least), row=row),
        cell("grows", kw(cuts.grows), row=row, short=SHORT, scale=slope),
        cell("at", cuts.cuts, scale=TURN),
        cell("span", cuts.span, len=len(row), scale=TURN),
        cell("most", kw(cuts.sum_most), acts=ACTS, since=SINCE),
        cell("more", kw(cuts.sum_climbs), acts=ACTS),
        cell("all_least", kw(cuts.sum_least), acts=ACTS, since=SINCE),
        cell("all_more", kw(cuts.sum_grows), acts=ACTS),
        cell("sure", kw(cuts.sure)),
    )
