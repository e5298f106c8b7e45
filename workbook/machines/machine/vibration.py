"""The sheet Vibration: what each move leaves in a load that swings behind its axis, and how soon that settles.

A move lasts from rest to rest, over all phases between. The cells integrate at points of each of its pieces; the engine
integrates exactly, and judges what the sheet says.
"""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from engine.drive.motor import LimitCheck
from engine.laws.base import Array
from engine.laws.extremes import Curve
from engine.laws.vibration import left_by
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.checks import ZERO
from workbook.book.declare import Book, Sheet
from workbook.book.rows import NOT_ZERO, constants, filled
from workbook.book.sentence import amount, as_shown
from workbook.entries.facts import entry_cells
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import UNTUNED, Vibration
from workbook.machines.machine.motion_tables import AxisTables
from workbook.motion.pieces import at_sample, workings_at
from workbook.template_outputs import JudgedLimit

CELLS = cell_tables(__file__)

NODES, WEIGHTS = (each / 2.0 for each in np.polynomial.legendre.leggauss(48))
MOST, BOUND = 16.0, 1e-6  # natural periods of a piece that points tell, to this share of the lift
CURVE, STEPS = 48, 96  # points of the chart, and samples of the move that it is drawn of
NEVER, NEXT_CYCLE, NEAR = "never", 1e6, 1e-6  # NEAR in degrees
PER_S2 = {"mm": 1000, "°": 10000}  # stiffness over inertia as entered, to 1/s²
TO_UNIT = {"mm": ("{}*1000", "*1000"), "°": ("DEGREES({})", "*180/PI()")}
ABOUT = "A load on a spring and a damper, which the axis moves from rest to rest."
CHART = "Vibration left by the move that leaves most, over its time by the natural period"
LIFT = "SUMPRODUCT(MAX(([@pieces.move]=[k])*[@pieces.lift]))"
UNTIL = "SUMPRODUCT(MIN({0}+360*({0}<{1}-eps)+1E6*([@pieces.moves]<>1)))"


class Swing:
    """A load that swings behind an axis: its pieces, and per phase the move that ends with it; angles in rad."""

    def __init__(self, tables: AxisTables, entered: Vibration, faster: float = 1.0) -> None:
        axis = self.axis = tables.axis.sized
        self.tables, self.entered, self.rows, self.i = tables, entered, tables.pieces, axis.number
        self.speed = axis.speed * (1.0 if axis.given.rate else faster)
        self.natural = entered.natural(axis.given.unit)
        self.swings = math.tau * self.natural / self.speed  # rad by rad of the cycle, as all these
        self.root = math.sqrt(1.0 - entered.damping**2)
        self.fade, self.damped = entered.damping * self.swings, self.root * self.swings
        self.end = NEXT_CYCLE if axis.given.repeats else TURN
        self.pieces = list(self.rows.pieces)
        begins, self.lasts = np.array([(shown(p.begin, DEGREE), p.duration) for p in self.pieces]).T
        steps = [piece.phase for piece in self.pieces]
        self.moves = (np.array(self.rows.numbers)[steps] != 1).astype(int)
        self.lifts = abs(np.array(self.rows.lifts)[steps]) * self.moves
        self.till = self._next(begins[self.moves == 0], begins) * self.moves
        self.after = np.where(self.moves, si(self.till - begins, DEGREE), self.lasts)
        self.periods = float((self.lasts * self.moves).max()) * self.swings / math.tau
        self._match(begins)

    def _match(self, begins: Array) -> None:
        """Find the pieces of the move that each phase ends, and how long the axis rests behind it."""
        phases, axis = self.axis.given.phases, self.axis
        self.stops = np.array(filled([phase.stop for phase in phases], self.tables.rows))
        ends = filled([p.stop if p.law != "DWL" else -TURN for p in phases], self.tables.rows, -TURN)
        off = np.array(ends)[:, None] - self.till
        self.here = (np.minimum(abs(off), abs(off + TURN)) < NEAR) & (self.moves > 0)
        self.lift = shown((self.here * self.lifts).max(axis=1), axis.unit)
        self.turned = self.here @ self.lasts
        self.ratios = self.swings * self.turned / math.tau
        behind = self._next(begins[self.moves == 1], self.stops - NEAR) - self.stops
        self.rests = np.where(self.lift > 0.0, behind, 0.0)

    def _next(self, begins: Array, places: Array) -> Array:
        """Return the first of these begins behind each place, in this cycle or the next (°)."""
        following = (begins + TURN * (begins < place) for place in places[:, None])
        return np.array([min(self.end, NEXT_CYCLE, *each.tolist()) for each in following])

    @cached_property
    def parts(self) -> dict[str, Array]:
        """Parts of the integral over each piece by its points, real and imaginary: of its polynomial and its sines."""
        u = self.lasts[:, None] * (NODES + 0.5)
        curves = [piece.curves[1] for piece in self.pieces]
        velocities = {"": np.array([Curve(curve.c)(x) for curve, x in zip(curves, u, strict=True)])}
        for k, mark in enumerate(self.rows.marks):
            a, omega, phi = np.array([piece.sines[k] for piece in self.pieces]).T[:, :, None]
            velocities[f"s{mark}"] = a * omega * np.cos(omega * u + phi)
        turned = np.exp((1j * self.damped - self.fade) * (self.after[:, None] - u)) * WEIGHTS
        return {of: self.lasts * (turned * v).sum(axis=1) for of, v in velocities.items()}

    @cached_property
    def integrals(self) -> Array:
        """The integral over each move."""
        return np.asarray(self.here @ np.sum(list(self.parts.values()), axis=0))

    @cached_property
    def left(self) -> Array:
        """The vibration after each move, by the points."""
        return np.asarray(shown(abs(self.integrals), self.axis.unit)) / self.root

    @cached_property
    def exact(self) -> Array:
        """The vibration after each move, by the exact engine."""
        both = zip(self.pieces, self.after.tolist(), strict=True)
        each = [(piece.curves[1], piece.duration, after) for piece, after in both]
        moves = ([each[k] for k in np.flatnonzero(row)] for row in self.here)
        left = [left_by(move, self.swings, self.entered.damping) for move in moves]
        return np.asarray(shown(np.array(left), self.axis.unit))

    @property
    def shares(self) -> Array:
        """The vibration after each move in % of its lift."""
        return np.asarray(100.0 * self.left / np.where(self.lift > 0.0, self.lift, 1.0))

    @property
    def worst(self) -> int:
        """The number of the first phase, from 0, whose move leaves the greatest share."""
        return int(np.argmax(self.shares >= self.shares.max() * (1.0 - ZERO) - ZERO))

    def ms(self, turned: Any) -> Any:
        """Return the time in which the cycle turns by so much (ms)."""
        return 1000.0 * turned / self.speed

    def later(self, left: Array) -> Array:
        """Return the vibration that is left when the next move begins."""
        return left * np.exp(-self.fade * si(self.rests, DEGREE))

    def settling(self, left: float) -> float | str:
        """Return the time in which a vibration has settled (ms), or that it never does."""
        if self.entered.settled is None or left <= self.entered.settled:
            return 0.0
        turned = math.log(left / self.entered.settled)
        return float(self.ms(turned / self.fade)) if self.fade else NEVER

    @property
    def limit(self) -> JudgedLimit:
        """The vibration left when the next move begins, as its sheet and as the exact engine have it."""
        most, given, what = self.entered.settled or math.inf, self.axis.given, "vibration left"
        both = (float(self.later(left).max()) for left in (self.left, self.exact))
        sheet, exact = (LimitCheck(what, left, most) for left in both)
        return JudgedLimit(f"vib{self.i}_settles", given.name, what, given.unit, sheet, exact, 0.0)

    @property
    def deviation(self) -> str:
        """The line on a vibration that is not as its sheet says, within what its points tell; empty where none is."""
        off = abs(self.left - self.exact) - BOUND * self.lift
        if self.periods > MOST or off.max() <= 0.0:
            return ""
        true, by_points = (as_shown(float(each[off.argmax()])) for each in (self.exact, self.left))
        return f"{self.axis.given.name}: vibration of {true} {self.axis.given.unit} exactly; its sheet says {by_points}"


def swings_of(rows: Sequence[AxisTables]) -> list[Swing]:
    """Return the loads that swing."""
    return [Swing(row, row.axis.typed.vibration) for row in rows if row.axis.typed.vibration]


def vibration_sheet(book: Book, swings: Sequence[Swing]) -> None:
    """Declare the sheet, where loads swing."""
    if not swings:
        return
    sheet = book.sheet("Vibration", "What each move leaves in a load that swings behind its axis.")
    for swing in swings:
        with sheet.scoped(f"vib{swing.i}_"):
            sheet.heading(f"Axis {swing.i}", ABOUT)
            page(sheet, swing)
    sheet.not_printed_below()
    sheet.heading("Workings: the rule of points")
    cell = CELLS["nodes"]
    cell.place(sheet, cell("x", NODES + 0.5), cell("w", WEIGHTS))
    book.name("vib_nodes", vib_x="x", vib_w="w")
    for swing in swings:
        with sheet.scoped(f"vib{swing.i}_"):
            sheet.heading(f"Workings: axis {swing.i}")
            workings(sheet, swing)
            pieces_table(sheet, swing)
    sheet.print_columns = 13


def words(swing: Swing) -> dict[str, Any]:
    """Return the parts that texts of its cells have, and the scales that these name."""
    given, t, size = swing.axis.given, swing.tables.name, float(swing.lift.max()) or 1.0
    omega = "omega" if given.motor is None else f"drive{swing.i}_omega"
    scales = {"size": size, "of_base": si(size, swing.axis.unit)}
    units = {"unit": given.unit, "base": swing.axis.base, "most": f"{MOST:g}", "omega": omega}
    return scales | units | {"i": swing.i, "t": t, "begin": f"[{t}_pieces.begin]"}


def page(sheet: Sheet, swing: Swing) -> None:
    """Declare what is entered of a load, what each move leaves, checks and chart."""
    e = swing.entered
    parts, unit, later = words(swing), swing.axis.given.unit, swing.later(swing.left)
    rows = entry_cells(e, f"axes.{swing.i - 1}.vibration", unit=unit)
    sheet.rows(*(q._replace(unit=q.unit.split(" or ")[0 if unit == "mm" else -1]) for q in rows))
    cell, most = CELLS["results"].sharing(**parts), float(later.max())
    sheet.rows(
        cell("@natural", swing.natural, stiffness=f"@stiffness*{PER_S2[unit]}/@inertia"),
        cell("@left", float(swing.left.max())),
        cell("@next", most),
    )
    cell, to_unit = CELLS["moves"].sharing(**parts), TO_UNIT[unit][0]
    until = UNTIL.format(parts["begin"], f"[{parts['t']}_taken.end.same]")
    both = {part: "]+[@pieces.".join(f"{part}{of}" for of in swing.parts) for part in "cs"}
    cell.place(
        sheet,
        cell("lift", swing.lift, lift=to_unit.format(LIFT)),
        cell("time", swing.ms(swing.turned)),
        cell("ratio", swing.ratios),
        cell("share", swing.shares),
        cell("left", swing.left, left=to_unit.format("SQRT(([c]^2+[s]^2)/(1-@damping^2))")),
        cell("pause", swing.ms(si(swing.rests, DEGREE))),
        cell("settles", [swing.settling(left) for left in swing.left.tolist()]),
        cell("next", later),
        cell("rest", swing.rests, until=until),
        cell("c", swing.integrals.real, cosines=both["c"]),
        cell("s", swing.integrals.imag, sines=both["s"]),
        blank="[lift]=0",
    )
    says = amount("@next", most, "", f" {unit}; expected at most ")
    says = says.then(amount("@settled", e.settled or 0.0, "", f" {unit}"))
    lasts = " natural periods; expected at most "
    reached = amount("@periods", swing.periods, "a piece lasts ", f"{lasts}{MOST:g}")
    cell = CELLS["checks"].sharing(**parts)
    sheet.checks(
        cell("@tuned", True, untuned=UNTUNED),
        cell("@settles", swing.limit.sheet.ok, says=says),
        cell("@reached", swing.periods <= MOST, says=reached),
    )
    lines = (
        Series("other natural frequencies", "[@curve.ratio]", "[@curve.share]"),
        Series("as it is", "[@here.ratio]", "[@here.share]", points=True, marker="circle"),
    )
    sheet.chart_row(Chart("Vibration left", "T/T_n", "% of the lift", lines, CHART), width=10)


def workings(sheet: Sheet, swing: Swing) -> None:
    """Declare how it swings, and the samples of the move that leaves most, with the curve of the chart."""
    worst, axis, parts = swing.worst, swing.axis, words(swing)
    lasts, lift, ratio = (float(each[worst]) for each in (swing.turned, swing.lift, swing.ratios))
    top, k = max(4.0, 1.5 * ratio), np.arange(1, STEPS + 1)
    cell = CELLS["workings"].sharing(**parts)
    rows = {name: getattr(swing, name) for name in ("swings", "fade", "damped", "end", "periods")}
    rows |= {"worst": worst + 1, "lasts": lasts, "top": top}
    sheet.rows(*(cell(f"@{name}", value) for name, value in rows.items()))
    cell = CELLS["here"]
    cell.place(sheet, cell("ratio", [ratio]), cell("share", [float(swing.shares[worst])]))
    tau, end = lasts * (1.0 - (k - 0.5) / STEPS), si(float(swing.stops[worst]) or TURN, DEGREE)
    places = end - tau + math.tau * (end < tau)
    v = axis.motion.at(places).y1
    cell = CELLS["samples"].sharing(**parts, steps=STEPS, ends=f"INDEX([{parts['t']}_taken.end],@worst)")
    cell.place(
        sheet,
        cell("k", k),
        cell("tau", tau),
        cell("theta", shown(places, DEGREE)),
        *workings_at(swing.rows, "theta", places),
        cell("v", v, slope=at_sample(swing.rows, 1), scale=axis.motion.size(1)),
    )
    ratios = top * np.arange(1, CURVE + 1) / CURVE
    w, turning = math.tau * ratios / max(ZERO, lasts), 1j * swing.root - swing.entered.damping
    turned = np.exp(np.outer(w, turning * tau)) @ v * (lasts / STEPS)
    share = 100.0 * np.asarray(shown(abs(turned), axis.unit)) / swing.root
    columns = {"ratio": ratios, "share": share / lift if lift else 0.0 * share, "w": w}
    columns |= {"c": turned.real, "s": turned.imag}
    per = TO_UNIT[axis.given.unit][1]
    cell = CELLS["curve"].sharing(**parts, points=CURVE, steps=STEPS, per=per)
    cell.place(sheet, *(cell(name, values) for name, values in columns.items()))


def pieces_table(sheet: Sheet, swing: Swing) -> None:
    """Declare which pieces move, the move of each, and what it adds to both parts of the integral."""
    room, rows, name = swing.tables.room, swing.rows, swing.rows.at.named
    factors, powers = (constants(range(least, rows.powers - 1 + least)) for least in (1, 0))
    velocity = {"": f"INDEX({name('c1')},[r],0)*{factors}*([d]*vib_x{NOT_ZERO})^{powers}"}
    for mark in rows.marks:
        height, om, ph = (f"INDEX({name(of + mark)},[r])" for of in ("dA", "om", "ph"))
        velocity[f"s{mark}"] = f"{height}*COS({om}*[d]*vib_x+{ph})"
    cell, adds = CELLS["pieces"].sharing(**words(swing)), []
    for of, both in swing.parts.items():
        texts = {"mark": of, "of": "a sine" if of else "the polynomial", "velocity": velocity[of]}
        for part, turn, values in (("c", "COS", both.real), ("s", "SIN", both.imag)):
            adds.append(cell("{part}{mark}", filled(values, room), part=part, turn=turn, **texts))
    move = (swing.here * np.arange(1, len(swing.here) + 1)[:, None]).max(axis=0)
    columns = {"lift": swing.lifts, "till": swing.till, "after": swing.after, "move": move}
    columns["d"] = swing.lasts
    cell.place(
        sheet,
        cell("r", list(range(1, room + 1))),
        cell("moves", filled(swing.moves, room, 2)),
        *(cell(name, filled(values, room)) for name, values in columns.items()),
        *adds,
        blank="[moves]=2",
    )
