"""Bounds of the power on the common DC bus: between two cuts of any drive each takes at most what its interval does."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Sheet
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, shown
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

CUTS = (
    "Between two cuts of any drive each takes at most what it takes in the half of an interval that it is in: the sums "
    "bound the bus, whatever its samples miss."
)
HALF = POINTS // 2  # points from the begin of an interval to its middle, and from there to its end
SMALL = 1e-9  # share of a drive's larger peak up to which the other is none; the cells' check_zero
kw = partial(shown, unit=KW)


def half_powers(view: DriveView) -> Array:
    """Return begin and length (°) of halves of a drive's intervals, its largest power each way in them (W): four rows.

    Spare halves are at the end of the cycle, without length.
    """
    x, power, rows = shown(view.load.x, DEGREE), view.points.power, 2 * view.rows
    halves = [np.stack([each[:, : HALF + 1], each[:, HALF:]], axis=1).reshape(-1, HALF + 1) for each in (x, power)]
    begin, length = halves[0][:, 0], halves[0][:, -1] - halves[0][:, 0]
    ways = (np.maximum(way.max(axis=1), 0.0) for way in (halves[1], -halves[1]))
    last = float(power[-1, -1])
    return np.array(
        [
            filled(each, rows, spare)
            for each, spare in zip((begin, length, *ways), (TURN, 0.0, max(last, 0.0), max(-last, 0.0)), strict=True)
        ]
    )


class BusCuts:
    """Bounds of the power on the bus between the ``cuts`` of all its drives, the begins of halves of their intervals.

    ``begin`` and ``end`` of these halves of all drives in degrees of the master shaft, what its drive ``draws`` and
    ``returns`` in each at most (W); from each cut to the next what all have ``drawn`` and ``returned`` at most.
    ``shares`` are the ``peaks`` of each drive, on the mains and in its resistor (W), over the largest powers at its
    points: 0 for a drive that is not ``on_bus``.
    """

    def __init__(self, drives: Sequence[DriveView], on_bus: Array, peaks: Array) -> None:
        self.drives, near = drives, drives[0].tables.machine.near
        tables = [half_powers(view) for view in drives]
        tops, counts = np.array([table[2:].max(axis=1) for table in tables]).T, [table.shape[1] for table in tables]
        counted = tops > SMALL * peaks[::-1]
        self.shares = on_bus * np.divide(peaks, tops, out=np.zeros(peaks.shape), where=counted)
        begin, length, *powers = np.concatenate(tables, axis=1)
        late = np.array([view.driven.axis.given.shift for view in drives])
        at = begin + np.repeat(late, counts)
        self.begin = at - TURN * np.floor((at + near) / TURN)
        self.end = self.begin + length
        self.draws, self.returns = np.repeat(self.shares, counts, axis=1) * np.array(powers)
        self.cuts = np.sort(self.begin)
        behind = self.cuts[:, None] + near / 2.0
        acts = ((self.begin < behind) & (behind < self.end)) | (behind + TURN < self.end)
        self.drawn, self.returned = acts @ self.draws, acts @ self.returns
        self.both = np.minimum(self.drawn, self.returned)
        self.span = np.diff(self.cuts, append=self.cuts[0] + TURN)

    @property
    def most(self) -> float:
        """The most that the bus takes from the mains (W)."""
        return float(self.drawn.max())

    @property
    def most_back(self) -> float:
        """The most that goes into its resistor (W)."""
        return float(self.returned.max())

    @property
    def saved(self) -> float:
        """The most that drives take of what others return, in the mean (W)."""
        return float(self.span @ self.both / TURN)


def cuts_table(sheet: Sheet, cuts: BusCuts) -> None:
    """Declare what each drive takes and returns at most in each half of its intervals, and all between cuts."""
    cell = CELLS["bus_cuts"]
    each = [(row, drive.driven.number) for row, drive in enumerate(cuts.drives, 1) for _ in range(2 * drive.rows)]
    first = [1 + POINTS * k + side for drive in cuts.drives for k in range(drive.rows) for side in (0, HALF)]
    numbers = [number for _, number in each]
    acts = "(([bus_cuts.from]<[at]+eps/2)*([at]+eps/2<[bus_cuts.to])+([at]+360+eps/2<[bus_cuts.to]))"
    at = "INDEX(drive{0}_at,[k])+[axes_taken.late.{0}]"
    powers = ",".join(f"INDEX(drive{{0}}_P,[k]+{n})" for n in range(HALF + 1))
    sheet.heading("Bounds of the power of the bus", CUTS)
    sheet.table(
        "bus_cuts",
        "Halves of the intervals of all drives, and what they add up to between all cuts",
        len(each),
        cell("row", list(range(1, len(each) + 1))),
        cell("axis", numbers),
        cell("k", first),
        cell(
            "from",
            cuts.begin,
            formula=[f"={at.format(n)}-360*INT(({at.format(n)}+eps)/360)" for n in numbers],
            scale=TURN,
        ),
        cell(
            "to",
            cuts.end,
            formula=[f"=[from]+INDEX(drive{n}_at,[k]+{HALF})-INDEX(drive{n}_at,[k])" for n in numbers],
            scale=TURN,
        ),
        cell("draws", kw(cuts.draws), formula=[f"=[power.up.{row}]*MAX(0,{powers.format(n)})" for row, n in each]),
        cell(
            "returns", kw(cuts.returns), formula=[f"=0-[power.down.{row}]*MIN(0,{powers.format(n)})" for row, n in each]
        ),
        cell("at", cuts.cuts, scale=TURN),
        cell("span", cuts.span, len=len(each), scale=TURN),
        cell("most", kw(cuts.drawn), acts=acts),
        cell("back", kw(cuts.returned), acts=acts),
        cell("both", kw(cuts.both)),
    )
