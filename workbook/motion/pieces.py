"""The table of a motion's pieces, what a table of phases adds for it, and samples: one formula each derivative."""

from collections.abc import Callable, Sequence
from itertools import accumulate
from math import perm
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.laws.piece import Sine
from engine.motion.pieces import MotionPiece, PieceTable
from workbook.book.chart import in_scope
from workbook.book.declare import Quantity, Sheet, calc, check, constant
from workbook.book.rows import LEAST, NOT_ZERO, filled, polynomial
from workbook.book.sentence import spelled
from workbook.fields.units import DEGREE, shown
from workbook.motion.cells import FIRST, RAISED, Cells, PieceRows, last_before, of_law
from workbook.motion.requirements import CROWDED, ROOM_RULE

ABOUT = (
    "On each piece y(u) = c0 + c1 u + c2 u² + … + A sin(ωu + φ), u from its start: "
    "a piece of the phase's law, scaled by lift and duration."
)
NAMES = ("position", "slope", "quadratic", "cubic", "quartic", "quintic", "of sixth degree", "of seventh degree")
DERIVATIVES = ("y'", "y''", "y'''")
ROOM = "as sizes.motion_pieces says"
POSITION = "c0 + c1 u + … + A sin ζ"
SINES = "+{}*SIN({})", "+{}*COS({})", "-{}*SIN({})", "-{}*COS({})"  # the same by the amplitude of each derivative
FROM_START = "from its start; never 0, so that u⁰ is 1"

Sizes = Callable[[int], float]  # of the n-th derivative of the motion: what deviations are measured by at least


def phase_columns(rows: PieceRows) -> list[Quantity]:
    """Return the columns by which a table of phases tells where its pieces are."""
    count = f"{last_before('[no]', '1')}-[first]+1"
    if rows.at.ends:
        count = f"IF(INDEX([{rows.at.ends}.mode],[k])>1,1,{count})"
    return phase_table_columns(rows, FIRST, f"=IF([span]>0,{count},0)")


def phase_table_columns(rows: PieceRows, first: str | Sequence[str], pieces: str | Sequence[str]) -> list[Quantity]:
    """Return these columns by formulas for the first piece's row on Laws and for the number of pieces."""
    at = rows.at
    return [
        calc("rate", "per duration", "1/δ", f"1/{at.x}", "=IF([span]>0,1/[span],0)", list(rows.rates),
             source="0 if spare"),
        calc("first", "row of its law's first piece", "", "", first, list(rows.firsts), format="0", source="on Laws"),
        calc("pieces", "pieces", "", "", pieces, rows.counts, format="0"),
        calc("before", "pieces before", "", "", "=IF([k]=1,0,[before-1]+[pieces-1])",
             [*accumulate(rows.counts[:-1], initial=0)], format="0"),
    ]  # fmt: skip


def pieces_in_all(rows: PieceRows) -> Quantity:
    """Return the row that says how many pieces a motion has."""
    at = rows.at
    return calc(at.count, "Pieces in all", "", "", f"=SUM([{at.phases}.pieces])", len(rows.pieces), format="0")


def room_check(name: str, at: Cells, number: int, of: str, cuts: str) -> Quantity:
    """Return the check that the table of pieces has room for all ``of`` the axis of a number, with ``cuts`` in them."""
    rows, count = f"[{at.pieces}.r.last]", f"{at.count}+{cuts}" if cuts else at.count
    says, label = spelled(CROWDED, count, rows), f"{of}: the table of pieces has room for all"
    return check(name, label, f"{count}<={rows}", True, ROOM, f":{ROOM_RULE.format(number)}", says)


def pieces_table(
    sheet: Sheet, title: str, rows: PieceRows, room: int, sizes: Sizes, *more: Quantity, taken: Sequence[Quantity] = ()
) -> None:
    """Declare the table of a motion's pieces, and ``more`` columns; ``taken`` are those of what a piece takes over."""
    at = rows.at
    place, span = f"MAX(0,MIN([r],{at.count})-1)", at.of_phase("span")
    length, unit, called = (f"DEGREES({span})", DEGREE, "°") if at.degrees else (span, 1.0, at.x)
    lasting = f"IF({at.of_end('mode')}>1,1,{of_law('d')})" if at.ends else of_law("d")
    pieces = filled(rows.pieces, room, rows.pieces[-1])

    def begins(name: str, label: str, formula: str, figure: Callable[[MotionPiece], float]) -> Quantity:
        values = filled([shown(figure(piece), unit) for piece in rows.pieces], room, shown(rows.end, unit))
        return calc(name, label, "", called, f"=IF([r]>MAX(1,{at.count}),{at.end},{formula})", values,
                    scale=shown(rows.end, unit), source="spare rows: the end")  # fmt: skip

    origin = f"{at.of_phase('begin')}+{length}*{of_law('xi')}"
    opened = [begins("origin", "u counts from", origin, lambda piece: piece.origin)] if at.opens else []
    begin = f"MAX({at.of_phase('opens')},{origin})" if at.opens else origin
    share = calc("share", "begins at this share of the whole", "", "", f"=[begin]/{at.end}",
                 filled(PieceTable(rows.pieces, rows.end).begins, room, 1.0), source="spare rows: 1")  # fmt: skip
    block = sheet.table(
        at.pieces, title, room,
        constant("r", "piece", "k", "", list(range(1, room + 1))),
        calc("p", "phase", "", "", f'=COUNTIF([{at.phases}.before],"<="&{place})', [one.phase + 1 for one in pieces],
             format="0", source="the last with no more before it"),
        calc("m", "row on Laws", "", "", f"={at.of_phase('first')}+{place}-{at.of_phase('before')}",
             filled(rows.rows, room, rows.rows[-1]), format="0"),
        begins("begin", "begins at", begin, lambda piece: piece.begin),
        *opened, *([] if at.degrees else [share]),
        calc("d", "duration", "d", at.x, f"=IF([r]>{at.count},0,{span}*{lasting})",
             filled([piece.duration for piece in rows.pieces], room), scale=rows.end),
        *scaled(rows, pieces),
        *taken,
        *(power(rows, i, pieces, sizes) for i in range(rows.powers)),
        *(column for k, mark in enumerate(rows.marks)
          for column in sine(at, mark, [piece.sines[k] for piece in pieces], sizes)),
        *more,
        blank=f"[r]>{at.count}",
    )  # fmt: skip
    columns = {"at": "begin"} | ({"origin": "origin"} if at.opens else {})
    columns |= {from_power(order): f"c{order}:c{rows.powers - 1}" for order in range(4)}
    for mark in rows.marks:
        names = [f"om{mark}", f"ph{mark}", *(amplitude(order, mark) for order in range(4))]
        columns |= dict(zip(names, names, strict=True))
    sheet.book.name(block.name, **{in_scope(at.named(name), sheet.scope): of for name, of in columns.items()})


def scaled(rows: PieceRows, pieces: Sequence[MotionPiece]) -> list[Quantity]:
    """Return the columns of what a piece of the law is scaled by: lift and 1/δ of its phase."""
    at, phases = rows.at, [piece.phase for piece in pieces]
    lift = calc("hp", "lift of its phase", "h", at.y, f"={at.of_phase('h')}", [rows.lifts[k] for k in phases])
    rate = calc("per", "per duration", "1/δ", f"1/{at.x}", f"={at.of_phase('rate')}", [rows.rates[k] for k in phases])
    return [rate] if at.ends else [lift, rate]


def from_power(order: int) -> str:
    """Return the name of the columns of the coefficients from that of u^order on."""
    return f"c{order}" if order else "c"


def power(rows: PieceRows, i: int, pieces: Sequence[MotionPiece], sizes: Sizes) -> Quantity:
    """Return a coefficient of the polynomial."""
    at = rows.at
    h, per, velocity = "[hp]", "[per]", at.drift
    if i == 0:
        drift = f"+{velocity}*{at.of_phase('span')}*{of_law('xi')}" if velocity else ""
        sines = "".join(f"-[A{mark}]*SIN([ph{mark}])" for mark in rows.marks)
        formula, source = f"={at.base}+{h}*{of_law('s')}{drift}{sines}", "y_0 + h s_k − A sin φ"
    elif i == 1:
        drift = f"+{velocity}" if velocity else ""
        sines = "".join(f"-[A{mark}]*[om{mark}]*COS([ph{mark}])" for mark in rows.marks)
        formula, source = f"={h}*{of_law('v')}*{per}{drift}{sines}", "h v_k/δ − A ω cos φ"
    else:
        share = perm(i, 2)
        own, source = f"{h}*{of_law(f'c{i - 2}')}/{share}", f"h c{i - 2}/({share} δ^{i})"
        formula = f"=({own}+{at.of_end(f'e{i}')})*{per}^{i}" if at.ends else f"={own}*{per}^{i}"
    values = [piece.c[i] for piece in pieces]
    return calc(f"c{i}", NAMES[i], f"c{i}", at.unit(i), formula, values, scale=sizes(i), source=source)


def amplitude(order: int, mark: str) -> str:
    """Return the name of the column of a sine's amplitude in y, or in a derivative."""
    return f"{'d' * order}A{mark}"


def sine(at: Cells, mark: str, found: Sequence[Sine], sizes: Sizes) -> tuple[Quantity, ...]:
    """Return amplitude, frequency and phase of a sine ``found`` in pieces, and its amplitude in each derivative."""
    h, per, words = "[hp]", "[per]", " of the second sine" if mark else ""

    def of_a_sine(formula: str) -> str:
        return f"=IF({at.of_end('mode')}>1,0,{formula})" if at.ends else f"={formula}"

    return (
        calc(f"A{mark}", f"amplitude{words}", f"A{mark}", at.y,
             f"=0-{h}*{of_law(f'ps{mark}')}", [a for a, _, _ in found], scale=sizes(0), source="−h P/ω²"),
        calc(f"om{mark}", f"frequency{words}", f"ω{mark}", f"rad/{at.x}",
             of_a_sine(f"{of_law(f'omega{mark}')}*{per}"), [omega for _, omega, _ in found], source="ω/δ"),
        calc(f"ph{mark}", f"phase{words}", f"φ{mark}", "rad",
             of_a_sine(of_law(f"phi{mark}")), [phi for *_, phi in found]),
        *(calc(amplitude(order, mark), f"amplitude of {symbol}{words}", "", at.unit(order),
               f"=[{amplitude(order - 1, mark)}]*[om{mark}]",
               [a * omega**order for a, omega, _ in found], scale=sizes(order), source=f"A{mark} ω{RAISED[order]}")
          for order, symbol in enumerate(DERIVATIVES, 1)),
    )  # fmt: skip


def finding(rows: PieceRows, x: str, values: Array, of: str = "", suffix: str = "") -> list[Quantity]:
    """Return the workings of samples at a column ``x``, with its ``values``: the piece, u in it, arguments of sines."""
    at, place = rows.at, PieceTable(rows.pieces, rows.end).located(values)
    q = f"q{suffix}"
    local = f"[{x}]-INDEX({at.named('origin' if at.opens else 'at')},[{q}])"
    return [
        calc(q, f"{of}piece", "q", "",
             f"={at.piece(x)}", place.piece + 1.0, format="0", source="last start at or below"),
        calc(f"u{suffix}", f"{of}within piece", "u", at.x,
             f"={f'RADIANS({local})' if at.degrees else local}{NOT_ZERO}", place.u + LEAST, source=FROM_START),
        *arguments(rows, suffix, f"[{q}]", turned([rows.pieces[k] for k in place.piece], place.u), of),
    ]  # fmt: skip


def turned(pieces: Sequence[MotionPiece], u: Array) -> Array:
    """Return the arguments ωu + φ of the sines of pieces, each at its u."""
    _, omega, phi = np.array([piece.sines for piece in pieces]).T
    return np.asarray(omega * u + phi)


def arguments(rows: PieceRows, suffix: str, q: str, angles: Sequence[Any] | Array, of: str = "") -> list[Quantity]:
    """Return the columns of the arguments of the sines at places u of pieces, whose row ``q`` names."""
    return [
        calc(f"x{mark}{suffix}", f"{of}argument of the {which}sine", "ζ", "rad",
             f"={of_row(rows, f'om{mark}', q)}*[u{suffix}]+{of_row(rows, f'ph{mark}', q)}", angles[k],
             source="ωu + φ")
        for k, (mark, which) in enumerate(zip(rows.marks, ("", "second "), strict=False))
    ]  # fmt: skip


def of_row(rows: PieceRows, name: str, q: str = "") -> str:
    """Return the formula of a figure of a piece, whose row ``q`` names; where it is empty, of that of the same row."""
    return f"INDEX({rows.at.named(name)},{q})" if q else f"[{rows.at.pieces}.{name}.same]"


def sampled(rows: PieceRows, order: int, suffix: str = "") -> str:
    """Return the formula, without its =, of a derivative at a sample: coefficients times powers of u, and sines."""
    return at_place(rows, order, suffix, f"[q{suffix}]")


def place_columns(
    rows: PieceRows, suffix: str, of: str, formula: str, u: Array, pieces: Sequence[MotionPiece], q: str = ""
) -> list[Quantity]:
    """Return the columns of a place u in each piece, of the row ``q`` or else the same, and the arguments of sines."""
    return [
        calc(f"u{suffix}", f"{of}: u", "u", rows.at.x, f"{formula}{NOT_ZERO}", u + LEAST, scale=rows.end,
             source=FROM_START),
        *arguments(rows, suffix, q, turned(pieces, u), f"{of}: "),
    ]  # fmt: skip


def at_place(rows: PieceRows, order: int, suffix: str, q: str = "") -> str:
    """Return the formula, without its =, of a derivative at a place in a piece, whose row ``q`` names."""
    name, last = from_power(order), rows.powers - 1
    several = f"INDEX({rows.at.named(name)},{q},0)" if q else of_row(rows, f"c{order}:c{last}")
    text = polynomial(several, f"[u{suffix}]", rows.powers, order)
    for mark in rows.marks:
        text += SINES[order].format(of_row(rows, amplitude(order, mark), q), f"[x{mark}{suffix}]")
    return text


def at_begin(rows: PieceRows, order: int) -> str:
    """Return the formula, without its =, of a derivative where the piece of the same row begins."""
    text = f"{perm(order)}*" if order > 1 else ""
    text += of_row(rows, f"c{order}")
    for mark in rows.marks:
        text += SINES[order].format(of_row(rows, amplitude(order, mark)), of_row(rows, f"ph{mark}"))
    return text
