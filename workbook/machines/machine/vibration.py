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
from workbook.book.sentence import amount, rounded
from workbook.entries.facts import entry_cells
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import UNTUNED, Vibration
from workbook.machines.machine.motion_tables import AxisTables
from workbook.motion.pieces import finding, sampled
from workbook.template_outputs import JudgedLimit

CELLS = cell_tables(__file__)

NODES, WEIGHTS = (each / 2.0 for each in np.polynomial.legendre.leggauss(48))
MOST, BOUND = 16.0, 1e-6  # natural periods of a piece that these points tell, to this share of the lift
CURVE, STEPS = 48, 96  # points of the chart, and samples of the move that it is drawn of
NEVER, NEXT_CYCLE, NEAR = "never", 1e6, 1e-6  # NEAR in degrees
PER_S2 = {"mm": 1000, "°": 10000}  # stiffness over inertia as entered, to 1/s²
TO_UNIT = {"mm": ("{}*1000", "*1000"), "°": ("DEGREES({})", "*180/PI()")}
LIFT = "SUMPRODUCT(MAX(([@pieces.move]=[k])*[@pieces.lift]))"
UNTIL = "SUMPRODUCT(MIN({0}+360*({0}<{1}-eps)+1E6*([@pieces.moves]<>1)))"


class Swing:
    """A load that swings behind an axis: its pieces, and per phase the move that ends with it; angles in rad."""

    def __init__(self, tables: AxisTables, entered: Vibration, faster: float = 1.0) -> None:
        axis = self.axis = tables.axis.sized
        self.tables, self.entered, self.rows, self.i = tables, entered, tables.pieces, axis.number
        self.speed = axis.speed * (1.0 if axis.given.rate else faster)
        self.natural = entered.natural(axis.given.unit)
        self.swings, self.root = math.tau * self.natural / self.speed, math.sqrt(1.0 - entered.damping**2)
        self.fade, self.end = entered.damping * self.swings, NEXT_CYCLE if axis.given.repeats else TURN
        self.pieces = list(self.rows.pieces)
        begins, self.lasts = np.array([(shown(p.begin, DEGREE), p.duration) for p in self.pieces]).T
        self.moves = np.array([int(self.rows.numbers[piece.phase] != 1) for piece in self.pieces])
        self.lifts = np.array([abs(self.rows.lifts[piece.phase]) for piece in self.pieces]) * self.moves
        self.till = self._next(begins[self.moves == 0], begins) * self.moves
        self.after = np.where(self.moves, si(self.till - begins, DEGREE), self.lasts)
        stops, n = filled([phase.stop for phase in axis.given.phases], tables.rows), tables.rows
        self.stops = np.array(stops)
        ends = np.array(filled([p.stop if p.law != "DWL" else -TURN for p in axis.given.phases], n, -TURN))[:, None]
        self.here = (np.minimum(abs(ends - self.till), abs(ends + TURN - self.till)) < NEAR) & (self.moves > 0)
        self.lift = shown((self.here * self.lifts).max(axis=1), axis.unit)
        self.turned = self.here @ self.lasts
        self.ratios = self.swings * self.turned / math.tau
        self.rests = np.where(self.lift > 0.0, self._next(begins[self.moves == 1], self.stops - NEAR) - self.stops, 0.0)
        self.periods = float((self.lasts * self.moves).max()) * self.swings / math.tau  # in the longest piece

    def _next(self, begins: Array, places: Array) -> Array:
        """Return the first of these begins behind each place, in this cycle or the next (°)."""
        found = (begins + TURN * (begins < place) for place in places[:, None])
        return np.array([min(self.end, NEXT_CYCLE, *each.tolist()) for each in found])

    @cached_property
    def parts(self) -> dict[str, Array]:
        """What each piece adds to the integral by its points, real and imaginary: its polynomial, and its sines."""
        u = self.lasts[:, None] * (NODES + 0.5)
        curves = [piece.curves[1] for piece in self.pieces]
        velocities = {"": np.array([Curve(curve.c)(x) for curve, x in zip(curves, u, strict=True)])}
        for k, mark in enumerate(self.rows.marks):
            a, omega, phi = np.array([piece.sines[k] for piece in self.pieces]).T[:, :, None]
            velocities[f"s{mark}"] = a * omega * np.cos(omega * u + phi)
        turned = np.exp((1j * self.swings * self.root - self.fade) * (self.after[:, None] - u)) * WEIGHTS
        return {name: self.lasts * (turned * velocity).sum(axis=1) for name, velocity in velocities.items()}

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
        each = [(p.curves[1], p.duration, after) for p, after in zip(self.pieces, self.after.tolist(), strict=True)]
        moves = ([each[k] for k in np.flatnonzero(row)] for row in self.here)
        return np.array([shown(left_by(m, self.swings, self.entered.damping), self.axis.unit) for m in moves])

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
        """Return what is left of the vibration when the next move begins."""
        return left * np.exp(-self.fade * si(self.rests, DEGREE))

    def settling(self, left: float) -> float | str:
        """Return the time in which a vibration has settled (ms), or that it never does."""
        if self.entered.settled is None or left <= self.entered.settled:
            return 0.0
        return float(self.ms(math.log(left / self.entered.settled) / self.fade)) if self.fade else NEVER

    @property
    def limit(self) -> JudgedLimit:
        """What is left when the next move begins, as its sheet and as the exact engine have it."""
        most, given = self.entered.settled or math.inf, self.axis.given
        sheet, exact = (
            LimitCheck("vibration", float(self.later(left).max()), most) for left in (self.left, self.exact)
        )
        return JudgedLimit(f"vib{self.i}_settles", given.name, "vibration left", given.unit, sheet, exact, 0.0)

    @property
    def deviation(self) -> str:
        """The line on a vibration that is not as its sheet says, within what its points tell; empty where none is."""
        off = abs(self.left - self.exact) - BOUND * self.lift
        if self.periods > MOST or off.max() <= 0.0:
            return ""
        true, by_points = (rounded(float(each[off.argmax()])) for each in (self.exact, self.left))
        return f"{self.axis.given.name}: vibration of {true} {self.axis.given.unit} exactly; its sheet says {by_points}"


def swings_of(rows: Sequence[AxisTables]) -> list[Swing]:
    """Return the loads that swing."""
    return [Swing(row, row.axis.typed.vibration) for row in rows if row.axis.typed.vibration]


def vibration_sheet(book: Book, swings: Sequence[Swing]) -> None:
    """Declare the sheet, where loads swing."""
    if not swings:
        return
    sheet = book.sheet("Vibration", "What each move leaves in a load that swings behind its axis, from rest to rest.")
    for swing in swings:
        with sheet.scoped(f"vib{swing.i}_"):
            sheet.heading(f"Axis {swing.i}", "A load on a spring and a damper, which the axis moves from rest to rest.")
            page(sheet, swing)
    sheet.not_printed_below()
    sheet.heading("Workings: the rule of points")
    cell = CELLS["nodes"]
    cell.place(sheet, cell("x", NODES + 0.5), cell("w", WEIGHTS))
    book.name("vib_nodes", vib_x="x", vib_w="w")
    for swing in swings:
        with sheet.scoped(f"vib{swing.i}_"):
            sheet.heading(f"Workings: axis {swing.i}")
            curve(sheet, swing)
            pieces_table(sheet, swing)
    sheet.print_columns = 13


def words(swing: Swing) -> dict[str, Any]:
    """Return the parts that texts of its cells have, and the scales that these name."""
    given, size = swing.axis.given, float(swing.lift.max()) or 1.0
    omega, t = "omega" if given.motor is None else f"drive{swing.i}_omega", swing.tables.name
    units = {"unit": given.unit, "base": swing.axis.base, "size": size, "of_base": si(size, swing.axis.unit)}
    return units | {"i": swing.i, "t": t, "omega": omega, "most": f"{MOST:g}", "begin": f"[{t}_pieces.begin]"}


def page(sheet: Sheet, swing: Swing) -> None:
    """Declare what is entered of a load, what each move leaves, checks and chart."""
    e, parts, unit, later = swing.entered, words(swing), swing.axis.given.unit, swing.later(swing.left)
    entries = entry_cells(e, f"axes.{swing.i - 1}.vibration", unit=unit)
    sheet.rows(*(q._replace(unit=q.unit.split(" or ")[0 if unit == "mm" else -1]) for q in entries))
    cell, most = CELLS["results"].sharing(**parts), float(later.max())
    damped = swing.swings * swing.root
    sheet.rows(
        cell("@natural", swing.natural, stiffness=f"@stiffness*{PER_S2[unit]}/@inertia"),
        *(cell(name, float(values.max())) for name, values in (("@left", swing.left), ("@next", later))),
        *(cell(f"@{name}", getattr(swing, name)) for name in ("swings", "fade")),
        *(cell("@damped", damped), cell("@end", swing.end), cell("@periods", swing.periods)),
    )
    cell, to_unit = CELLS["moves"].sharing(**parts), TO_UNIT[unit][0]
    until = UNTIL.format(parts["begin"], f"[{parts['t']}.end.same]")
    both = {part: "]+[@pieces.".join(f"{part}{of}" for of in swing.parts) for part in "cs"}
    cell.place(
        sheet,
        cell("lift", swing.lift, lift=to_unit.format(LIFT)),
        *(cell("time", swing.ms(swing.turned)), cell("ratio", swing.ratios), cell("share", swing.shares)),
        cell("left", swing.left, left=to_unit.format("SQRT(([c]^2+[s]^2)/(1-@damping^2))")),
        cell("pause", swing.ms(si(swing.rests, DEGREE))),
        cell("settles", [swing.settling(left) for left in swing.left.tolist()]),
        *(cell("next", later), cell("rest", swing.rests, until=until)),
        cell("c", swing.integrals.real, cosines=both["c"]),
        cell("s", swing.integrals.imag, sines=both["s"]),
        blank="[lift]=0",
    )
    says = amount("@next", most, "", f" {unit}; expected at most ")
    reached = amount("@periods", swing.periods, "a piece lasts ", f" natural periods; expected at most {MOST:g}")
    cell = CELLS["checks"].sharing(**parts)
    sheet.checks(
        cell("@tuned", True, i_before=swing.i - 1, untuned=UNTUNED),
        cell("@settles", swing.limit.sheet.ok, says=says.then(amount("@settled", e.settled or 0.0, "", f" {unit}"))),
        cell("@reached", swing.periods <= MOST, says=reached),
    )
    about = f"Vibration left by the move of axis {swing.i} that leaves most, over its time by the natural period"
    lines = (
        Series("other natural frequencies", "[@curve.ratio]", "[@curve.share]"),
        Series("as it is", "[@here.ratio]", "[@here.share]", points=True, marker="circle"),
    )
    sheet.chart_row(Chart("Vibration left", "T/T_n", "% of the lift", lines, about), width=10)


def curve(sheet: Sheet, swing: Swing) -> None:
    """Declare the curve of the chart, and the samples of the move that it is drawn of."""
    worst, axis, parts = swing.worst, swing.axis, words(swing)
    lasts, lift, ratio = (float(each[worst]) for each in (swing.turned, swing.lift, swing.ratios))
    top, k = max(4.0, 1.5 * ratio), np.arange(1, STEPS + 1)
    cell = CELLS["chart"].sharing(**parts)
    sheet.rows(cell("@worst", worst + 1), cell("@lasts", lasts), cell("@top", top))
    cell = CELLS["here"]
    cell.place(sheet, cell("ratio", [ratio]), cell("share", [float(swing.shares[worst])]))
    tau, end = lasts * (1.0 - (k - 0.5) / STEPS), si(float(swing.stops[worst]) or TURN, DEGREE)
    places = end - tau + math.tau * (end < tau)
    v = axis.motion.at(places).y1
    cell = CELLS["samples"].sharing(**parts, steps=STEPS, ends=f"INDEX([{parts['t']}.end],@worst)")
    cell.place(
        sheet,
        *(cell("k", k), cell("tau", tau), cell("theta", shown(places, DEGREE)), *finding(swing.rows, "theta", places)),
        cell("v", v, slope=sampled(swing.rows, 1), scale=axis.motion.size(1)),
    )
    ratios = top * np.arange(1, CURVE + 1) / CURVE
    w = math.tau * ratios / max(ZERO, lasts)
    turned = np.exp(np.outer(w, (1j * swing.root - swing.entered.damping) * tau)) @ v * (lasts / STEPS)
    share = 100.0 * np.asarray(shown(abs(turned), axis.unit)) / swing.root / (lift or 1.0)
    cell = CELLS["curve"].sharing(**parts, points=CURVE, steps=STEPS, per=TO_UNIT[axis.given.unit][1])
    columns = {"ratio": ratios, "share": share if lift else 0.0 * share, "w": w, "c": turned.real, "s": turned.imag}
    cell.place(sheet, *(cell(name, values) for name, values in columns.items()))


def pieces_table(sheet: Sheet, swing: Swing) -> None:
    """Declare which pieces move, the move that each belongs to, and what it adds to both parts of the integral."""
    room, rows = swing.tables.machine.room, swing.rows
    factors, powers = (constants(range(least, rows.powers - 1 + least)) for least in (1, 0))
    velocity = {"": f"INDEX({rows.at.named('c1')},[r],0)*{factors}*([d]*vib_x{NOT_ZERO})^{powers}"}
    for mark in rows.marks:
        height, om, ph = (f"INDEX({rows.at.named(f'{name}{mark}')},[r])" for name in ("dA", "om", "ph"))
        velocity[f"s{mark}"] = f"{height}*COS({om}*[d]*vib_x+{ph})"
    cell, adds = CELLS["pieces"].sharing(**words(swing)), []
    for of, values in swing.parts.items():
        texts = {"mark": of, "of": "a sine" if of else "the polynomial", "velocity": velocity[of]}
        for part, name, turn, one in (("c", "real", "COS", values.real), ("s", "imaginary", "SIN", values.imag)):
            adds.append(cell("{part}{mark}", filled(one, room), part=part, words=name, turn=turn, **texts))
    move = (swing.here * np.arange(1, len(swing.here) + 1)[:, None]).max(axis=0)
    columns = {"lift": swing.lifts, "till": swing.till, "after": swing.after, "move": move, "d": swing.lasts}
    cell.place(
        sheet,
        cell("r", list(range(1, room + 1))),
        cell("moves", filled(swing.moves, room, 2)),
        *(cell(name, filled(values, room)) for name, values in columns.items()),
        *adds,
        blank="[moves]=2",
    )
