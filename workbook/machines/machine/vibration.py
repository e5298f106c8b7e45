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

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)
MOST = 16.0  # natural periods of a piece that these points tell, to 1e-6 of the lift
BOUND = 1e-6  # of the lift
CURVE, STEPS = 48, 96  # points of the chart, and samples of the move that it is drawn of
NEVER, NEXT_CYCLE = "never", 1e6
PER_S2 = {"mm": 1000, "°": 10000}  # stiffness over inertia as entered, to 1/s²
TO_UNIT = {"mm": ("{}*1000", "*1000"), "°": ("DEGREES({})", "*180/PI()")}


class Swing:
    """A load that swings behind an axis: what is left of each move, at its phases; angles in rad of the cycle."""

    def __init__(self, tables: AxisTables, entered: Vibration, faster: float = 1.0) -> None:
        self.tables, self.entered, self.axis = tables, entered, tables.axis.sized
        self.number, self.rows = tables.axis.number, tables.pieces
        self.speed = self.axis.speed * faster
        given = self.axis.given
        self.omega = "omega" if given.motor is None else f"drive{self.number}_omega"
        self.natural = entered.natural(given.unit)
        self.swings = math.tau * self.natural / self.speed
        self.fade = entered.damping * self.swings
        self.root = math.sqrt(1.0 - entered.damping**2)
        self.end = NEXT_CYCLE if given.repeats else TURN
        pieces = self.pieces = list(self.rows.pieces)
        self.begins = np.array([shown(piece.begin, DEGREE) for piece in pieces])
        self.lasts = np.array([piece.duration for piece in pieces])
        self.moves = np.array([int(self.rows.numbers[piece.phase] != 1) for piece in pieces])
        self.lifts = np.array([abs(self.rows.lifts[piece.phase]) for piece in pieces]) * self.moves
        self.till = np.array([self.rest_after(at) for at in self.begins]) * self.moves
        self.after = np.where(self.moves, si(self.till - self.begins, DEGREE), self.lasts)
        stops = [phase.stop for phase in given.phases]
        self.ends = {k: stop for k, stop in enumerate(stops) if given.phases[k].law != "DWL"}
        self.move = np.array([self.row_at(till) for till in self.till])

    def rest_after(self, begin: float) -> float:
        """Return where the axis rests next behind a place, in degrees; beyond the cycle that of the next."""
        rests = self.begins[self.moves == 0]
        return min([self.end, NEXT_CYCLE, *(rests + TURN * (rests < begin)).tolist()])

    def row_at(self, till: float) -> int:
        """Return the number of the phase, from 1, that ends there; 0 of none."""
        near = (k + 1 for k, end in self.ends.items() if min(abs(end - till), abs(end + TURN - till)) < 1e-6)
        return next(near, 0) if till else 0

    @property
    def numbers(self) -> range:
        """The numbers of the rows of phases."""
        return range(1, self.tables.rows + 1)

    def shown(self, base: Any) -> Any:
        """Return a position in the unit of the axis."""
        return shown(base, self.axis.unit)

    @cached_property
    def lift(self) -> list[float]:
        """The greatest lift of the move that each phase ends."""
        return [self.shown(float(self.lifts[self.move == k].max(initial=0.0))) for k in self.numbers]

    @cached_property
    def turned(self) -> list[float]:
        """How long the move lasts that each phase ends (rad)."""
        return [float(self.lasts[self.move == k].sum()) for k in self.numbers]

    @property
    def ratios(self) -> list[float]:
        """These over the natural period."""
        return [self.swings * turned / math.tau for turned in self.turned]

    @cached_property
    def parts(self) -> dict[str, Array]:
        """What each piece adds to both parts of the integral, by its points: of its polynomial, and of its sines."""
        u = self.lasts[:, None] * (NODES + 1.0) / 2.0
        tau, weights = (
            self.after[:, None] - u,
            self.lasts[:, None] * WEIGHTS / 2.0 * np.exp(-self.fade * (self.after[:, None] - u)),
        )
        curves = [piece.curves[1] for piece in self.pieces]
        velocities = {"": np.array([Curve(curve.c)(x) for curve, x in zip(curves, u, strict=True)])}
        for k, mark in enumerate(self.rows.marks):
            a, omega, phi = (np.array([piece.sines[k][n] for piece in self.pieces])[:, None] for n in range(3))
            velocities[f"s{mark}"] = a * omega * np.cos(omega * u + phi)
        turns = {"c": np.cos(self.swings * self.root * tau), "s": np.sin(self.swings * self.root * tau)}
        return {
            f"{part}{of}": np.array([math.fsum(row) for row in weights * turn * velocity])
            for of, velocity in velocities.items()
            for part, turn in turns.items()
        }

    def summed(self, part: str) -> str:
        """Return the formula of what each piece adds to a part of the integral."""
        return "]+[@pieces.".join(name for name in self.parts if name.startswith(part))

    @cached_property
    def integrals(self) -> dict[str, list[float]]:
        """Both parts of the integral of each move."""
        of = {
            part: sum((self.parts[name] for name in self.parts if name.startswith(part)), 0.0 * self.after)
            for part in "cs"
        }
        return {part: [float(of[part][self.move == k].sum()) for k in self.numbers] for part in "cs"}

    @cached_property
    def left(self) -> list[float]:
        """The vibration after each move, by the points."""
        both = zip(*self.integrals.values(), strict=True)
        return [self.shown(math.hypot(*parts) / self.root) for parts in both]

    @property
    def shares(self) -> list[float]:
        """The same in % of the lift."""
        return [100.0 * left / lift if lift else 0.0 for left, lift in zip(self.left, self.lift, strict=True)]

    @property
    def worst(self) -> int:
        """The number of the first phase, from 0, whose move leaves the greatest share."""
        least = max(self.shares) * (1.0 - ZERO) - ZERO
        return next(k for k, share in enumerate(self.shares) if share >= least)

    @cached_property
    def exact(self) -> list[float]:
        """The vibration after each move, by the exact engine."""
        velocities = [
            (piece.curves[1], piece.duration, after)
            for piece, after in zip(self.pieces, self.after.tolist(), strict=True)
        ]
        each = ([v for v, move in zip(velocities, self.move, strict=True) if move == k] for k in self.numbers)
        return [self.shown(left_by(move, self.swings, self.entered.damping)) for move in each]

    @cached_property
    def rests(self) -> list[float]:
        """The rest behind each move, in degrees."""
        begins, stops = self.begins[self.moves == 1], filled([p.stop for p in self.axis.given.phases], self.tables.rows)
        return [
            min([self.end, NEXT_CYCLE, *(begins + TURN * (begins < stop - 1e-6)).tolist()]) - stop if lift else 0.0
            for stop, lift in zip(stops, self.lift, strict=True)
        ]

    def ms(self, turned: float) -> float:
        """Return the time in which the cycle turns by so much (ms)."""
        return 1000.0 * turned / self.speed

    def later(self, left: Sequence[float]) -> list[float]:
        """Return what is left of the vibration when the next move begins."""
        return [size * math.exp(-self.fade * si(rest, DEGREE)) for size, rest in zip(left, self.rests, strict=True)]

    def settling(self, left: float) -> float | str:
        """Return the time in which a vibration has settled (ms), or that it never does."""
        most = self.entered.settled
        if most is None or left <= most:
            return 0.0
        return self.ms(math.log(left / most) / self.fade) if self.fade else NEVER

    @property
    def periods(self) -> float:
        """Natural periods in the longest piece."""
        return float((self.lasts * self.moves).max(initial=0.0)) * self.swings / math.tau

    def is_settled(self, left: Sequence[float]) -> bool:
        """Whether no more is left when the next move begins than may be."""
        return self.entered.settled is None or max(self.later(left)) <= self.entered.settled

    @property
    def limit(self) -> JudgedLimit:
        """What is left when the next move begins, as its sheet and as the exact engine have it."""
        most = math.inf if self.entered.settled is None else self.entered.settled
        sheet, exact = (LimitCheck("vibration left", max(self.later(left)), most) for left in (self.left, self.exact))
        name, unit = self.axis.given.name, self.axis.given.unit
        return JudgedLimit(f"vib{self.number}_settles", name, "vibration left", unit, sheet, exact, 0.0)

    @property
    def deviation(self) -> str:
        """The line on a vibration that is not as its sheet says, within what its points tell; empty where none is."""
        for k, (left, exact, lift) in enumerate(zip(self.left, self.exact, self.lift, strict=True), 1):
            if self.periods <= MOST and abs(left - exact) > BOUND * lift:
                unit = self.axis.given.unit
                return (
                    f"{self.axis.given.name} row {k}: {rounded(exact)} {unit} of vibration exactly, not {rounded(left)}"
                )
        return ""


def swings_of(rows: Sequence[AxisTables]) -> list[Swing]:
    """Return the loads that swing."""
    return [Swing(row, row.axis.typed.vibration) for row in rows if row.axis.typed.vibration]


def vibration_sheet(book: Book, swings: Sequence[Swing]) -> None:
    """Declare the sheet, where loads swing."""
    if not swings:
        return
    sheet = book.sheet("Vibration", "What each move leaves in a load that swings behind its axis, from rest to rest.")
    for swing in swings:
        with sheet.scoped(f"vib{swing.number}_"):
            sheet.heading(
                f"Axis {swing.number}", "Leave out what is not known; a load on a spring, pushed by its base."
            )
            page(sheet, swing)
    sheet.not_printed_below()
    for swing in swings:
        with sheet.scoped(f"vib{swing.number}_"):
            sheet.heading(f"Workings: axis {swing.number}")
            workings(sheet, swing)
    nodes(book, sheet)
    sheet.print_columns = 13


def page(sheet: Sheet, swing: Swing) -> None:
    """Declare what is entered of a load, what each move leaves, and the chart."""
    e, i, unit = swing.entered, swing.number, swing.axis.given.unit
    entries = entry_cells(e, f"axes.{i - 1}.vibration", unit=unit)
    sheet.rows(*(q._replace(unit=q.unit.split(" or ")[0 if unit == "mm" else -1]) for q in entries))
    size, later = max(swing.lift) or 1.0, swing.later(swing.left)
    stiffness = f"@stiffness*{PER_S2[unit]}/@inertia"
    cell = CELLS["results"].sharing(unit=unit, i=i, omega=swing.omega, stiffness=stiffness)
    sheet.rows(
        cell("@natural", swing.natural),
        cell("@left", max(swing.left), scale=size),
        cell("@next", max(later), scale=size),
        cell("@swings", swing.swings),
        cell("@fade", swing.fade),
        cell("@damped", swing.swings * swing.root),
        cell("@end", swing.end),
    )
    moves(sheet, swing, later, size)
    checks = CELLS["checks"].sharing(i=i)
    says = amount("@next", max(later), "", f" {unit}; expected at most ").then(
        amount("@settled", e.settled or 0.0, "", f" {unit}")
    )
    reached = amount("@periods", swing.periods, "a piece lasts ", f" natural periods; expected at most {MOST:g}")
    sheet.checks(
        CELLS["tuned"]("@tuned", True, i=i, i_before=i - 1, untuned=UNTUNED),
        checks("@settles", swing.is_settled(swing.left), says=says),
        checks("@reached", swing.periods <= MOST, most=f"{MOST:g}", says=reached),
    )
    about = f"Vibration left by the move of axis {i} that leaves most, over its time by the natural period"
    lines = (
        Series("other natural frequencies", "[@curve.ratio]", "[@curve.share]"),
        Series("as it is", "[@here.ratio]", "[@here.share]", points=True, marker="circle"),
    )
    sheet.chart_row(Chart("Vibration left", "T/T_n", "% of the lift", lines, about), width=10)


def moves(sheet: Sheet, swing: Swing, later: list[float], size: float) -> None:
    """Declare a row for each phase: what the move that it ends leaves."""
    given, t, rows = swing.axis.given, swing.tables.name, swing.tables.rows
    to_unit = TO_UNIT[given.unit][0]
    begin = f"[{t}_pieces.begin]"
    until = f"SUMPRODUCT(MIN({begin}+360*({begin}<[{t}.end.same]-eps)+1E6*([@pieces.moves]<>1)))"
    laws = [p.law if lift else "" for p, lift in zip(given.phases, swing.lift, strict=False)]
    cell = CELLS["moves"].sharing(t=t, unit=given.unit, base=swing.axis.base, omega=swing.omega)
    cell.place(
        sheet,
        cell("law", filled(laws, rows, "")),
        cell("lift", swing.lift, lift=to_unit.format("SUMPRODUCT(MAX(([@pieces.move]=[k])*[@pieces.lift]))")),
        cell("time", [swing.ms(turned) for turned in swing.turned]),
        cell("ratio", swing.ratios),
        cell("share", swing.shares, scale=100.0),
        cell("left", swing.left, left=to_unit.format("SQRT(([c]^2+[s]^2)/(1-@damping^2))"), scale=size),
        cell("pause", [swing.ms(si(rest, DEGREE)) for rest in swing.rests]),
        cell("settles", [swing.settling(left) for left in swing.left]),
        cell("next", later, scale=size),
        cell("rest", swing.rests, until=until, scale=TURN),
        cell("c", swing.integrals["c"], cosines=swing.summed("c"), scale=si(size, swing.axis.unit)),
        cell("s", swing.integrals["s"], sines=swing.summed("s"), scale=si(size, swing.axis.unit)),
        blank="[lift]=0",
    )


def workings(sheet: Sheet, swing: Swing) -> None:
    """Declare the curve of the chart, with the move that it is drawn of, and the pieces."""
    worst, shares = swing.worst, swing.shares
    top, lift, unit = max(4.0, 1.5 * swing.ratios[worst]), swing.lift[worst], swing.axis.unit
    step, size = swing.turned[worst] / STEPS, si(lift or 1.0, unit)
    cell = CELLS["reached"].sharing(t=swing.tables.name, most=f"{MOST:g}", omega=swing.omega, steps=STEPS)
    sheet.rows(
        cell("@periods", swing.periods),
        cell("@worst", worst + 1),
        cell("@lasts", swing.turned[worst]),
        cell("@step", step),
        cell("@top", top),
    )
    cell = CELLS["here"]
    cell.place(sheet, cell("ratio", [swing.ratios[worst]]), cell("share", [shares[worst]], scale=100.0))
    tau, v = samples(sheet, swing)
    ratios = top * np.arange(1, CURVE + 1) / CURVE
    w = math.tau * ratios / max(ZERO, swing.turned[worst])
    turned = np.exp(np.outer(w, -(swing.entered.damping + 1j * swing.root) * tau)) @ v * step
    words = {"lift": "INDEX([@moves.lift],@worst)", "per": TO_UNIT[swing.axis.given.unit][1]}
    cell = CELLS["curve"].sharing(base=swing.axis.base, points=CURVE, **words)
    cell.place(
        sheet,
        cell("ratio", ratios),
        cell("share", 100.0 * swing.shown(np.abs(turned)) / swing.root / (lift or 1.0), scale=100.0),
        cell("w", w),
        cell("c", turned.real, scale=size),
        cell("s", -turned.imag, scale=size),
    )
    pieces_table(sheet, swing, size)


def samples(sheet: Sheet, swing: Swing) -> tuple[Array, Array]:
    """Declare samples of the move that leaves most; return how long before its end they are, and their velocities."""
    rows, axis, k = swing.rows, swing.axis, np.arange(1, STEPS + 1)
    tau = swing.turned[swing.worst] * (1.0 - (k - 0.5) / STEPS)
    end = si(filled([p.stop for p in axis.given.phases], swing.tables.rows, TURN)[swing.worst], DEGREE)
    places = end - tau + math.tau * (end < tau)
    v = axis.motion.at(places).y1
    cell = CELLS["samples"].sharing(steps=STEPS, base=axis.base, ends=f"INDEX([{swing.tables.name}.end],@worst)")
    cell.place(
        sheet,
        cell("k", k),
        cell("tau", tau, scale=math.tau),
        cell("theta", shown(places, DEGREE), scale=TURN),
        *finding(rows, "theta", places),
        cell("v", v, slope=sampled(rows, 1), scale=axis.motion.size(1)),
    )
    return tau, v


def pieces_table(sheet: Sheet, swing: Swing, size: float) -> None:
    """Declare which pieces move, the move that each belongs to, and what it adds to both parts of the integral."""
    room, t, rows = swing.tables.machine.room, swing.tables.name, swing.rows
    cell = CELLS["pieces"].sharing(i=swing.number, t=t, base=swing.axis.base, begin=f"[{t}_pieces.begin]")
    factors, powers = (constants(range(least, rows.powers - 1 + least)) for least in (1, 0))
    velocity = {"": f"INDEX({rows.at.named('c1')},[r],0)*{factors}*([d]*vib_x{NOT_ZERO})^{powers}"}
    for mark in rows.marks:
        height, om, ph = (f"INDEX({rows.at.named(f'{name}{mark}')},[r])" for name in ("dA", "om", "ph"))
        velocity[f"s{mark}"] = f"{height}*COS({om}*[d]*vib_x+{ph})"
    columns = [
        cell(
            "{part}{mark}",
            filled(values, room),
            part=name[0],
            mark=name[1:],
            words="real" if name[0] == "c" else "imaginary",
            of="its sine" if name[1:] else "its polynomial",
            turn="COS" if name[0] == "c" else "SIN",
            velocity=velocity[name[1:]],
            scale=size,
        )
        for name, values in swing.parts.items()
    ]
    cell.place(
        sheet,
        cell("r", list(range(1, room + 1))),
        cell("moves", filled(swing.moves, room, 2)),
        cell("lift", filled(swing.lifts, room), scale=size),
        cell("till", filled(swing.till, room)),
        cell("after", filled(swing.after, room)),
        cell("move", filled(swing.move, room, 0)),
        cell("d", filled(swing.lasts, room)),
        *columns,
        blank="[moves]=2",
    )


def nodes(book: Book, sheet: Sheet) -> None:
    """Declare the points of a piece and what they count."""
    cell = CELLS["nodes"]
    sheet.heading("Workings: the rule of points")
    cell.place(sheet, cell("x", (NODES + 1.0) / 2.0), cell("w", WEIGHTS / 2.0))
    book.name("vib_nodes", vib_x="x", vib_w="w")
