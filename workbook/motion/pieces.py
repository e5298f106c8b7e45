"""The table of a motion's pieces, columns beside phases for it, and samples: a formula for each derivative."""

from collections.abc import Callable, Sequence
from itertools import accumulate, chain
from math import perm
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.laws.piece import Sine
from engine.motion.pieces import MotionPiece, MotionPieces
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import in_scope
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import LEAST, filled, polynomial
from workbook.book.sentence import sentence_formula
from workbook.fields.units import DEGREE, shown
from workbook.motion.cells import FIRST, Cells, PieceRows, last_before, of_law
from workbook.motion.requirements import CROWDED

CELLS = cell_tables(__file__)

ABOUT = (
    "On each piece y(u) = c0 + c1 u + c2 u² + … + A sin(ωu + φ), u from its start: "
    "a piece of the phase's law, scaled by lift and duration."
)
NAMES = ("position", "slope", "quadratic", "cubic", "quartic", "quintic", "of sixth degree", "of seventh degree")
ROOM = "as sizes.motion_pieces says"
POSITION = "c0 + c1 u + … + A sin ζ"
FROM_START = "from its start; never 0, so that u⁰ is 1"
# the same by the amplitude of each derivative
SINES = "+{}*SIN({})", "+{}*COS({})", "-{}*SIN({})", "-{}*COS({})"

# of the n-th derivative of the motion: what deviations are measured by at least
Sizes = Callable[[int], float]


def phase_columns(rows: PieceRows) -> list[Quantity]:
    """Return the columns by which a table of phases tells where its pieces are."""
    count = f"{last_before('[no]', '1')}-[first]+1"
    if rows.at.ends:
        count = f"IF(INDEX([{rows.at.ends}.mode],[k])>1,1,{count})"
    return phase_table_columns(rows, FIRST, f"=IF([span]>0,{count},0)")


def phase_table_columns(rows: PieceRows, first: str | Sequence[str], pieces: str | Sequence[str]) -> list[Quantity]:
    """Return these columns by formulas for the first piece's row on Laws and for the number of pieces."""
    cell = CELLS["phase_table_columns"]
    return [
        cell("rate", list(rows.rates), x=rows.at.x),
        cell("first", list(rows.firsts), formula=first),
        cell("pieces", rows.counts, formula=pieces),
        cell("before", [*accumulate(rows.counts[:-1], initial=0)]),
    ]


def pieces_in_all(rows: PieceRows) -> Quantity:
    """Return the row that says how many pieces a motion has."""
    return CELLS["pieces_in_all"]("{at.count}", len(rows.pieces), at=rows.at)


def room_check(name: str, at: Cells, of: str, cuts: str) -> Quantity:
    """Return the check that the table of pieces has room for all ``of`` an axis, with ``cuts`` in them."""
    rows, count = f"[{at.pieces}.r.last]", f"{at.count}+{cuts}" if cuts else at.count
    texts = {"name": name, "of": of, "count": count, "rows": rows}
    return CELLS["room_check"]("{name}", True, says=sentence_formula(CROWDED, count, rows), **texts)


def pieces_table(
    sheet: Sheet, title: str, rows: PieceRows, room: int, sizes: Sizes, *more: Quantity, taken: Sequence[Quantity] = ()
) -> None:
    """Declare the table of a motion's pieces, and ``more`` columns; ``taken`` are those of what a piece takes over."""
    at, pieces = rows.at, filled(rows.pieces, room, rows.pieces[-1])
    sines = [sine(at, mark, [piece.sines[k] for piece in pieces], sizes) for k, mark in enumerate(rows.marks)]
    block = sheet.table(
        at.pieces,
        title,
        room,
        *piece_columns(rows, room),
        *scaled(rows, pieces),
        *taken,
        *(power(rows, i, pieces, sizes) for i in range(rows.powers)),
        *chain(*sines),
        *more,
        blank=f"[r]>{at.count}",
    )
    columns = {"at": "begin"} | ({"origin": "origin"} if at.opens else {})
    columns |= {from_power(order): f"c{order}:c{rows.powers - 1}" for order in range(4)}
    for mark in rows.marks:
        names = [f"om{mark}", f"ph{mark}", *(amplitude(order, mark) for order in range(4))]
        columns |= dict(zip(names, names, strict=True))
    sheet.book.name(block.name, **{in_scope(at.named(name), sheet.scope): of for name, of in columns.items()})


def piece_columns(rows: PieceRows, room: int) -> list[Quantity]:
    """Return the columns of the phase of a piece, of its row on Laws, where it begins and how long it lasts."""
    at, pieces = rows.at, filled(rows.pieces, room, rows.pieces[-1])
    cell = CELLS["piece_columns"].sharing(at=at)
    length, unit, called = (
        (f"DEGREES({at.of_phase('span')})", DEGREE, "°") if at.degrees else (at.of_phase("span"), 1.0, at.x)
    )
    lasting = f"IF({at.of_end('mode')}>1,1,{of_law('d')})" if at.ends else of_law("d")
    origin, end = f"{at.of_phase('begin')}+{length}*{of_law('xi')}", shown(rows.end, unit)

    def place(name: str, figure: Callable[[MotionPiece], float], begin: str) -> Quantity:
        values = filled([shown(figure(piece), unit) for piece in rows.pieces], room, end)
        return cell(name, values, unit=called, begin=begin, scale=end)

    begin = f"MAX({at.of_phase('opens')},{origin})" if at.opens else origin
    share = cell("share", filled(MotionPieces(rows.pieces, rows.end).begins, room, 1.0))
    durations = filled([piece.duration for piece in rows.pieces], room)
    return [
        cell("r", list(range(1, room + 1))),
        cell("p", [piece.phase + 1 for piece in pieces]),
        cell("m", filled(rows.rows, room, rows.rows[-1])),
        place("begin", lambda piece: piece.begin, begin),
        *([place("origin", lambda piece: piece.origin, origin)] if at.opens else []),
        *([] if at.degrees else [share]),
        cell("d", durations, lasting=lasting, scale=rows.end),
    ]


def scaled(rows: PieceRows, pieces: Sequence[MotionPiece]) -> list[Quantity]:
    """Return the columns of what a piece of the law is scaled by: lift and 1/δ of its phase."""
    cell, phases = CELLS["scaled"].sharing(at=rows.at), [piece.phase for piece in pieces]
    lift = cell("hp", [rows.lifts[k] for k in phases])
    rate = cell("per", [rows.rates[k] for k in phases])
    return [rate] if rows.at.ends else [lift, rate]


def from_power(order: int) -> str:
    """Return the name of the columns of the coefficients from that of u^order on."""
    return f"c{order}" if order else "c"


def power(rows: PieceRows, i: int, pieces: Sequence[MotionPiece], sizes: Sizes) -> Quantity:
    """Return a coefficient of the polynomial."""
    at, table = rows.at, CELLS["power"].sharing(at=rows.at)
    values = [piece.c[i] for piece in pieces]

    def cell(name: str, **parts: Any) -> Quantity:
        return table(name, values, unit=at.unit(i), scale=sizes(i), **parts)

    if i == 0:
        drift = f"+{at.drift}*{at.of_phase('span')}*{of_law('xi')}" if at.drift else ""
        sines = "".join(f"-[A{mark}]*SIN([ph{mark}])" for mark in rows.marks)
        return cell("c0", drift=drift, sines=sines)
    if i == 1:
        sines = "".join(f"-[A{mark}]*[om{mark}]*COS([ph{mark}])" for mark in rows.marks)
        return cell("c1", drift=f"+{at.drift}" if at.drift else "", sines=sines)
    share = perm(i, 2)
    of_its_law = f"[hp]*{of_law(f'c{i - 2}')}/{share}"
    bend = f"({of_its_law}+{at.of_end(f'e{i}')})" if at.ends else of_its_law
    return cell("c{i}", i=i, label=NAMES[i], bend=bend, of=f"c{i - 2}", share=share)


def amplitude(order: int, mark: str) -> str:
    """Return the name of the column of a sine's amplitude in y, or in a derivative."""
    return f"{'d' * order}A{mark}"


def sine(at: Cells, mark: str, sines: Sequence[Sine], sizes: Sizes) -> list[Quantity]:
    """Return amplitude, frequency and phase of a sine ``sines`` in pieces, and its amplitude in each derivative."""
    cell = CELLS["sine"].sharing(at=at, mark=mark, words=" of the second sine" if mark else "")
    amplitudes, omegas, phases = ([sine_values[k] for sine_values in sines] for k in range(3))

    def of_a_sine(formula: str) -> str:
        return f"IF({at.of_end('mode')}>1,0,{formula})" if at.ends else formula

    def derived(name: str, order: int) -> Quantity:
        values = [a * omega**order for a, omega, _ in sines]
        return cell(name, values, unit=at.unit(order), scale=sizes(order))

    return [
        cell("A{mark}", amplitudes, scale=sizes(0)),
        cell("om{mark}", omegas, omega=of_a_sine(f"{of_law(f'omega{mark}')}*[per]")),
        cell("ph{mark}", phases, phi=of_a_sine(of_law(f"phi{mark}"))),
        derived("dA{mark}", 1),
        derived("ddA{mark}", 2),
        derived("dddA{mark}", 3),
    ]


def workings_at(rows: PieceRows, x: str, values: Array, of: str = "", suffix: str = "") -> list[Quantity]:
    """Return the workings of samples at a column ``x``, with its ``values``: the piece, u in it, arguments of sines."""
    at, place = rows.at, MotionPieces(rows.pieces, rows.end).located(values)
    cell, q = CELLS["finding"].sharing(at=at, of=of, suffix=suffix), f"[q{suffix}]"
    local = f"[{x}]-INDEX({at.named('origin' if at.opens else 'at')},{q})"
    return [
        cell("q{suffix}", place.piece + 1.0, piece=at.piece(x)),
        cell("u{suffix}", place.u + LEAST, local=f"RADIANS({local})" if at.degrees else local),
        *arguments(rows, suffix, q, sine_arguments([rows.pieces[k] for k in place.piece], place.u), of),
    ]


def sine_arguments(pieces: Sequence[MotionPiece], u: Array) -> Array:
    """Return the arguments ωu + φ of the sines of pieces, each at its u."""
    _, omega, phi = np.array([piece.sines for piece in pieces]).T
    return np.asarray(omega * u + phi)


def arguments(rows: PieceRows, suffix: str, q: str, angles: Sequence[Any] | Array, of: str = "") -> list[Quantity]:
    """Return the columns of the arguments of the sines at places u of pieces, whose row ``q`` names."""
    cell = CELLS["arguments"].sharing(suffix=suffix, of=of)

    def argument(mark: str, which: str, values: Any) -> Quantity:
        omega, phi = of_row(rows, f"om{mark}", q), of_row(rows, f"ph{mark}", q)
        return cell("x{mark}{suffix}", values, mark=mark, which=which, omega=omega, phi=phi)

    sines = zip(rows.marks, ("", "second "), angles, strict=False)
    return [argument(*sine) for sine in sines]


def of_row(rows: PieceRows, name: str, q: str = "") -> str:
    """Return the formula of a figure of a piece, whose row ``q`` names; where it is empty, of that of the same row."""
    return f"INDEX({rows.at.named(name)},{q})" if q else f"[{rows.at.pieces}.{name}.same]"


def at_sample(rows: PieceRows, order: int, suffix: str = "") -> str:
    """Return the formula, without its =, of a derivative at a sample: coefficients times powers of u, and sines."""
    return at_place(rows, order, suffix, f"[q{suffix}]")


def place_columns(
    rows: PieceRows, suffix: str, of: str, formula: str, u: Array, pieces: Sequence[MotionPiece], q: str = ""
) -> list[Quantity]:
    """Return the columns of a place u in each piece, of the row ``q`` or else the same, and the arguments of sines."""
    cell, values = CELLS["place_columns"], u + LEAST
    return [
        cell("u{suffix}", values, suffix=suffix, of=of, x=rows.at.x, place=formula, scale=rows.end),
        *arguments(rows, suffix, q, sine_arguments(pieces, u), f"{of}: "),
    ]


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
