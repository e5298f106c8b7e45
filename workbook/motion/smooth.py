"""How smooth a motion must be: what jumps at the begin of each of its pieces, and the check of what is asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from engine.motion import Motion, Phase
from engine.motion.joining import Rates, slope
from engine.motion.smoothness import ORDERS, Joint, joints, scales_of, shortfalls
from workbook.book.declare import Quantity, calc, check
from workbook.book.rows import filled
from workbook.book.sentence import Said, figure, figure_of
from workbook.entries.units import DEGREE, shown
from workbook.motion.asked import ABOUT, Smoothness
from workbook.motion.cells import PieceRows
from workbook.motion.sampled import in_piece

RATES = ("v", "a", "j")
WORDS = ",".join(f'"{word}"' for word in ORDERS)


@dataclass(frozen=True)
class Asked:
    """How smooth a motion must be.

    ``entry`` is the formula of what is entered, ``order`` the name of the cell that counts the derivatives, ``largest``
    are the formulas of the largest |y'| and |y''|. In sentences stand the motion's name ``of``, the unit of the
    abscissa behind a ``place`` and those of the derivatives: each a formula, and the text that it gives. ``wraps`` is
    the condition under which the motion repeats, which it does if it is ``periodic``. Where its phases do not stand in
    the rows in which they are entered, sentences give no ``rows``; where they have ``names``, in the column ``what``
    of their table, these stand in place of numbers. Of a motion in degrees that is told over time, ``speed`` is the
    name of the cell that says how fast it goes, and that in rad/s; ``lift`` the end of a formula that shows a lift in
    another unit than the motion's, and what that is in it.
    """

    smooth: Smoothness
    entry: str
    order: str
    largest: tuple[str, str]
    place: tuple[str, str]
    units: tuple[tuple[str, str], ...]
    of: tuple[str, str] = ("", "")
    wraps: str = ""
    periodic: bool = True
    rows: bool = True
    names: tuple[str, ...] = ()
    speed: tuple[str, float] | None = None
    lift: tuple[str, float] = ("", 1.0)


def in_time(asked: Asked, degrees: str, size: str, order: str) -> tuple[str, str]:
    """Return the formulas of a place and of a jump as sentences tell them."""
    if asked.speed is None:
        return degrees, size
    return f"RADIANS({degrees})/{asked.speed[0]}", f"{size}*{asked.speed[0]}^{order}{asked.lift[0]}"


def timed(asked: Asked, x: float, size: float, order: int) -> tuple[float, float]:
    """Return them by the engine: x is in rad where they are told over time."""
    return (x, size) if asked.speed is None else (x / asked.speed[1], size * asked.speed[1] ** order / asked.lift[1])


def ended(n: int, joint: Joint) -> float:
    """Return the n-th derivative at the end of what lasts up to a joint."""
    return joint.end[n - 1]


def jumped(n: int, joint: Joint) -> float:
    """Return the jump of the n-th derivative at a joint."""
    return joint.jump[n - 1]


class Joints:
    """The joints of a motion's pieces: the engine's, and the columns that find them.

    The piece before is taken by INDEX, not from the row above: of two columns that do so within an IF, LibreOffice 7.4
    crashes when a cell is entered and a column is then inserted.
    """

    def __init__(
        self, rows: PieceRows, asked: Asked, found: Sequence[Joint], scales: Rates, smooth: bool,
        phases: Sequence[Phase] = (),
    ) -> None:  # fmt: skip
        self.rows, self.asked, self.found, self._phases = rows, asked, tuple(found), phases
        self._scales, self._smooth = scales, smooth

    @classmethod
    def of(cls, rows: PieceRows, motion: Motion, asked: Asked) -> Joints:
        """Return the joints of a motion of phases."""
        scales = scales_of(motion)
        found = joints(rows.pieces, scales, asked.smooth, asked.periodic)
        return cls(rows, asked, found, scales, not shortfalls(motion, asked.smooth, asked.periodic), motion.phases)

    def order(self) -> Quantity:
        """Return the row that says how many derivatives must be continuous."""
        entry = self.asked.entry
        formula = f'=IF({entry}="velocity",1,IF({entry}="acceleration",2,3))'
        return calc(self.asked.order, "Derivatives that must not jump", "", "",
                    formula, ORDERS.index(self.asked.smooth) + 1, format="0")  # fmt: skip

    def columns(self, room: int) -> list[Quantity]:
        """Return the columns beside the pieces of the motion."""
        at, table, scales = self.rows.at, self.rows.at.pieces, self._scales
        opened = "([begin]-[origin])" if at.opens else ""
        until = f"(IF([r]<{room},INDEX([{table}.begin],MIN([r]+1,{room})),{at.end})-[origin])" if at.opens else "[d]"

        def of(figure: Callable[[Joint], Any], spare: Any) -> list[Any]:
            return filled((figure(joint) for joint in self.found), room, spare)

        last, wraps = self.found[-1], self.asked.wraps
        first = f"[{table}.{{0}}1.last]" if not wraps else f"IF({wraps},[{table}.{{0}}1.last],{{1}})"
        ends = [
            calc(f"{name}1", f"{word} reached", "", "",
                 f"=IF([d]>0,{in_piece(self.rows, n, until)},IF([r]=1,0,[{name}1-1]))",
                 of(partial(ended, n), last.end[n - 1]), scale=scales[n - 1],
                 source="at its end")
            for n, (name, word) in enumerate(zip(RATES, ORDERS, strict=True), 1)
        ]  # fmt: skip
        jumps = [
            calc(f"d{name}", f"jump of {word}", f"Δy{mark}", "",
                 f"=IF([d]>0,{begin}-IF([n]=1,{first.format(name, begin)},INDEX([{table}.{name}1],[r]-1)),0)",
                 of(partial(jumped, n), 0.0), scale=scales[n - 1], source="at its begin")
            for n, (name, word, mark) in enumerate(zip(RATES, ORDERS, ("'", "''", "'" "''"), strict=True), 1)
            for begin in [in_piece(self.rows, n, opened)]
        ]  # fmt: skip
        return [
            calc("n", "pieces that last, so far", "", "",
                 "=IF([r]=1,0,[n-1])+IF([d]>0,1,0)", of(lambda joint: joint.lasting, last.lasting), format="0"),
            calc("of", "phase of the last of them", "", "",
                 "=IF([d]>0,[p],IF([r]=1,0,[of-1]))", of(lambda joint: joint.phase + 1, last.phase + 1), format="0"),
            calc("from", "phase before", "", "",
                 f"=IF([d]>0,IF([n]=1,[{table}.of.last],INDEX([{table}.of],[r]-1)),0)",
                 of(lambda joint: joint.before + 1, 0), format="0"),
            *ends,
            *jumps,
            calc("order", "what jumps", "", "", self._order(), of(lambda joint: joint.order, 0), format="0",
                 source="1 y', 2 y'', 3 y" "'''"),
            calc("fault", "is less smooth than asked", "", "",
                 "=IF([order]>0,1,0)", of(lambda joint: int(joint.order > 0), 0), format="0"),
            calc("size", "by how much", "", "",
                 "=CHOOSE([order]+1,0,[dv],[da],[dj])", of(lambda joint: joint.size, 0.0), scale=max(scales)),
        ]  # fmt: skip

    def _order(self) -> str:
        v, a = self.asked.largest
        asked, j = self.asked.order, f"{a}*MAX([{self.rows.at.phases}.rate])"
        jerk = f"IF(AND({asked}>2,ABS([dj])>check_zero*{j}),3,0)"
        return f"=IF(ABS([dv])>check_zero*{v},1,IF(AND({asked}>1,ABS([da])>check_zero*{a}),2,{jerk}))"

    def check(self, name: str, label: str) -> Quantity:
        """Return the check that the motion is as smooth as asked; it names joint, jump and phase."""
        holds = f"SUM([{self.rows.at.pieces}.fault])=0"
        return check(name, label, holds, self._smooth, ABOUT, says=Said(self._says(), self._said()))

    def _says(self) -> str:
        table, asked = self.rows.at.pieces, self.asked
        row = f"MATCH(1,[{table}.fault],0)"

        def at(column: str) -> str:
            return f"INDEX([{table}.{column}],{row})"

        within = f"AND({at('from')}={at('p')},{at('n')}>1)"
        rows = f'"row "&{at("from")}&IF({within},""," to "&{at("p")})&' if asked.rows else ""
        if asked.names:
            one, other = (f"INDEX([{self.rows.at.phases}.what],{at(row)})" for row in ("from", "p"))
            rows = f'{one}&IF({within},""," to "&{other})&'
        x, jump = in_time(asked, at("begin"), f"ABS({at('size')})", at("order"))
        size = figure_of(jump)
        what = f"CHOOSE({at('order')},{WORDS})"
        begin = f'" at "&ROUND({x},9)&{asked.place[0]}'
        unit = f'" "&CHOOSE({at("order")},{",".join(formula for formula, _ in asked.units)})'
        joined = '&" "&' if asked.rows else "&"
        head = f"{asked.of[0]}{joined}" if asked.of[0] else ""
        return f'{head}{rows}{begin}&": "&{what}&" jumps by "&{size}&{unit}{self._straight(at("from"), at("p"))}'

    def _straight(self, before: str, after: str) -> str:
        """Return the end of the sentence where the phases on both sides are straight: their slopes."""
        table = self.rows.at.ends
        if not table:
            return ""
        both = f"AND(INDEX([{table}.way],{before})=-1,INDEX([{table}.way],{after})=-1)"
        slopes = (f"INDEX([{table}.slope],{row})" for row in (before, after))
        one, other = (figure_of(in_time(self.asked, "", slope, "1")[1]) for slope in slopes)
        return f'&IF({both},": straight lines of "&{one}&" and "&{other},"")'

    def _said(self) -> str:
        first = next(((piece, j) for piece, j in zip(self.rows.pieces, self.found, strict=True) if j.order), None)
        if first is None:
            return ""
        (piece, joint), asked = first, self.asked
        within = joint.before == piece.phase and joint.lasting > 1
        rows = f"row {joint.before + 1}{'' if within else f' to {piece.phase + 1}'} " if asked.rows else ""
        if asked.names:
            rows = f"{asked.names[joint.before]}{'' if within else f' to {asked.names[piece.phase]}'} "
        degrees = self.rows.at.degrees and asked.speed is None
        at, size = timed(asked, piece.begin, abs(joint.size), joint.order)
        x = figure(shown(at, DEGREE) if degrees else at)
        unit = asked.units[joint.order - 1][1]
        head = f"{asked.of[1]} " if asked.of[1] else ""
        what = ORDERS[joint.order - 1]
        jump = f"{what} jumps by {figure(size)} {unit}"
        used = sorted({one.phase for one in self.rows.pieces})
        beside = [used.index(row) for row in (joint.before, piece.phase)] if self.rows.at.ends else []
        slopes = [slope(self._phases[k]) for k in beside]
        straight = [figure(timed(asked, 0.0, one, 1)[1]) for one in slopes if one is not None]
        why = f": straight lines of {' and '.join(straight)}" if len(straight) > 1 else ""
        return f"{head}{rows}at {x}{asked.place[1]}: {jump}{why}"
