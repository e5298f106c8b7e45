"""How smooth a motion must be: what jumps at the begin of each of its pieces, and the check of what is asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from engine.motion import Motion, Phase
from engine.motion.joining import Rates, slope
from engine.motion.pieces import MotionPiece
from engine.motion.smoothness import JUMP, ORDERS, Joint, joints, scales_of, shortfalls
from workbook.book.declare import Quantity, Sheet, calc, check, constant
from workbook.book.rows import filled
from workbook.book.sentence import Said, Sentence, figure, first_text
from workbook.entries.units import DEGREE, shown
from workbook.motion.asked import ABOUT, Asked, in_time, timed
from workbook.motion.cells import PieceRows
from workbook.motion.sampled import at_begin, at_place, place_columns

RATES = ("v", "a", "j")
WORDS = ",".join(f'"{word}"' for word in ORDERS)


class Told(NamedTuple):
    """What the table of joints tells of a jump: where it is, how large, between whom, slopes, and the sentence."""

    x: float
    jump: str
    who: str
    lines: str
    says: str


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

    def order(self) -> list[Quantity]:
        """Return the rows that say how many derivatives must be continuous, and which jumps of each are rounding."""
        entry, (v, a), scales = self.asked.entry, self.asked.largest, self._scales
        jerk = f"{self.asked.order}_a*{self.asked.quickest or f'MAX([{self.rows.at.phases}.rate])'}"
        lost = (f"check_zero*{v}", f"check_zero*{a}", jerk)
        formula = f'=IF({entry}="velocity",1,IF({entry}="acceleration",2,3))'
        return [
            calc(self.asked.order, "Derivatives that must not jump", "", "", formula,
                 ORDERS.index(self.asked.smooth) + 1, format="0"),
            *(calc(f"{self.asked.order}_{name}", f"A jump of {word} up to this is none", "", "", f"={formula}",
                   JUMP * scale)
              for name, word, formula, scale in zip(RATES, ORDERS, lost, scales, strict=True)),
        ]  # fmt: skip

    @property
    def name(self) -> str:
        """The name of the table of joints."""
        return self.rows.at.pieces.replace("_pieces", "_joints")

    def table(self, sheet: Sheet, title: str, room: int) -> None:
        """Declare the table of what jumps at the begin of each piece, and what each row says of that."""
        sheet.table(
            self.name, title, room,
            constant("r", "piece", "r", "", list(range(1, room + 1))),
            *self._lasting(room), *self._ends(room), *self._rates(room), *self._jumps(room), *self._sentences(room),
            blank=f"[r]>{self.rows.at.count}",
        )  # fmt: skip

    def _of(self, figure: Callable[[Joint], Any], spare: Any, room: int) -> list[Any]:
        return filled((figure(joint) for joint in self.found), room, spare)

    def _lasting(self, room: int) -> list[Quantity]:
        """Return which pieces last, and which phases meet where they begin."""
        at, last = self.rows.at, self.found[-1]
        durations = [piece.duration for piece in self.rows.pieces]
        phases = self.rows.column(lambda piece: piece.phase + 1, room)
        return [
            calc("d", "duration", "d", at.x, f"=INDEX([{at.pieces}.d],[r])", filled(durations, room),
                 scale=self.rows.end),
            calc("p", "phase", "", "", f"=INDEX([{at.pieces}.p],[r])", phases, format="0"),
            calc("n", "pieces that last, so far", "", "", "=IF([r]=1,0,[n-1])+IF([d]>0,1,0)",
                 self._of(lambda joint: joint.lasting, last.lasting, room), format="0"),
            calc("of", "phase of the last of them", "", "", "=IF([d]>0,[p],IF([r]=1,0,[of-1]))",
                 self._of(lambda joint: joint.phase + 1, last.phase + 1, room), format="0"),
            calc("from", "phase before", "", "",
                 f"=IF([d]>0,IF([n]=1,[{self.name}.of.last],INDEX([{self.name}.of],[r]-1)),0)",
                 self._of(lambda joint: joint.before + 1, 0, room), format="0"),
        ]  # fmt: skip

    def _ends(self, room: int) -> list[Quantity]:
        """Return where each piece ends, with the powers of that; of a motion that opens within one, its begin too."""
        at, pieces = self.rows.at, self.rows.pieces
        if not at.opens:
            ends = filled([piece.duration for piece in pieces], room)
            return place_columns(self.rows, "1", "end", "=[d]", np.array(ends), "[r]", self._taken(room))
        nexts = [*(piece.begin for piece in pieces[1:]), self.rows.end]
        ends = [after - piece.origin if piece.duration else 0.0 for piece, after in zip(pieces, nexts, strict=True)]
        begins = [piece.begin - piece.origin if piece.duration else 0.0 for piece in pieces]
        begin, origin = (f"INDEX([{at.pieces}.{name}],[r])" for name in ("begin", "origin"))
        after = f"IF([r]<{room},INDEX([{at.pieces}.begin],MIN([r]+1,{room})),{at.end})"
        taken = self._taken(room)
        return [
            *place_columns(self.rows, "0", "begin", f"=IF([d]>0,{begin}-{origin},0)", np.array(filled(begins, room)),
                           "[r]", taken),
            *place_columns(self.rows, "1", "end", f"=IF([d]>0,{after}-{origin},0)", np.array(filled(ends, room)),
                           "[r]", taken),
        ]  # fmt: skip

    def _taken(self, room: int) -> list[MotionPiece]:
        """Return the piece of each row; spare rows have the last."""
        return filled(self.rows.pieces, room, self.rows.pieces[-1])

    def _rates(self, room: int) -> list[Quantity]:
        """Return y', y'' and y''' at both ends of each piece."""
        rows, last, opens = self.rows, self.found[-1], self.rows.at.opens
        begins = [piece.begin - piece.origin if piece.duration else 0.0 for piece in self._taken(room)]

        def begun(n: int) -> list[float]:
            pairs = zip(self._taken(room), begins, strict=True)
            return [float(piece.derivative(n, np.array(u))) for piece, u in pairs]

        def begin(n: int) -> str:
            return at_place(rows, n, "0", "[r]") if opens else at_begin(rows, n, "[r]")

        names = list(zip(RATES, ORDERS, strict=True))
        return [
            *(calc(f"{name}0", word, "", "", f"={begin(n)}", begun(n), scale=self._scales[n - 1],
                   source="at its begin") for n, (name, word) in enumerate(names, 1)),
            *(calc(f"{name}1", f"{word} reached", "", "",
                   f"=IF([d]>0,{at_place(rows, n, '1', '[r]')},IF([r]=1,0,[{name}1-1]))",
                   self._of(partial(ended, n), last.end[n - 1], room), scale=self._scales[n - 1], source="at its end")
              for n, (name, word) in enumerate(names, 1)),
        ]  # fmt: skip

    def _jumps(self, room: int) -> list[Quantity]:
        """Return what jumps where each piece begins."""
        wraps, marks = self.asked.wraps, ("'", "''", "'''")

        def before(name: str) -> str:
            last = f"[{self.name}.{name}1.last]"
            first = f"IF({wraps},{last},[{name}0])" if wraps else last
            return f"IF([n]=1,{first},INDEX([{self.name}.{name}1],[r]-1))"

        return [
            *(calc(f"d{name}", f"jump of {word}", f"Δy{mark}", "", f"=IF([d]>0,[{name}0]-{before(name)},0)",
                   self._of(partial(jumped, n), 0.0, room), scale=self._scales[n - 1], source="at its begin")
              for n, (name, word, mark) in enumerate(zip(RATES, ORDERS, marks, strict=True), 1)),
            calc("order", "what jumps", "", "", self._order(), self._of(lambda joint: joint.order, 0, room),
                 format="0", source="1 y', 2 y'', 3 y" "'''"),
            calc("size", "by how much", "", "", "=CHOOSE([order]+1,0,[dv],[da],[dj])",
                 self._of(lambda joint: joint.size, 0.0, room), scale=max(self._scales)),
        ]  # fmt: skip

    def _order(self) -> str:
        asked = self.asked.order
        v, a, j = (f"{asked}_{name}" for name in RATES)
        jerk = f"IF(({asked}>2)*(ABS([dj])>{j}),3,0)"
        return f"=IF(ABS([dv])>{v},1,IF(({asked}>1)*(ABS([da])>{a}),2,{jerk}))"

    def _sentences(self, room: int) -> list[Quantity]:
        """Return where each jump is and how large, as sentences tell them, and the sentence itself."""
        asked, pieces = self.asked, self.rows.at.pieces
        x, size = in_time(asked, f"INDEX([{pieces}.begin],[r])", "ABS([size])", "[order]")
        unit = f"CHOOSE([order],{','.join(formula for formula, _ in asked.units)})"
        what = f"CHOOSE([order],{WORDS})"
        straight = "&[lines]" if self.rows.at.ends else ""
        says = f'[who]&"at "&ROUND([x],9)&{asked.place[0]}&": "&{what}&" jumps by "&[jump]&" "&{unit}{straight}'
        told = [self._told(piece, joint) for piece, joint in zip(self.rows.pieces, self.found, strict=True)]
        none = Told(0.0, "", "", "", "")
        each = filled(told, room, none)
        return [
            calc("x", "at, as told", "", "", f"=IF([order]=0,0,{x})", [one.x for one in each]),
            calc("jump", "by, as told", "", "",
                 f'=IF([order]=0,"",IF({size}<1000000000,ROUND({size},9)&"","beyond 1E9"))',
                 [one.jump for one in each]),
            calc("who", "between", "", "", self._who(), [one.who for one in each]),
            *self._lines(each),
            calc("says", "what is less smooth than asked", "", "", f'=IF([order]=0,"",{says})',
                 [one.says for one in each]),
        ]  # fmt: skip

    def _who(self) -> str:
        """Return the formula of the rows, or phases, between which a jump is."""
        asked, within = self.asked, "AND([from]=[p],[n]>1)"
        if asked.names:
            one, other = (f"INDEX([{self.rows.at.phases}.what],{row})" for row in ("MAX([from],1)", "[p]"))
            return f'=IF([order]=0,"",{one}&IF({within},""," to "&{other})&" ")'
        if asked.rows:
            return f'=IF([order]=0,"","row "&[from]&IF({within},""," to "&[p])&" ")'
        return '=""'

    def _lines(self, each: Sequence[Told]) -> list[Quantity]:
        """Return the columns of the slopes, where the phases on both sides are straight."""
        table = self.rows.at.asked
        if not table:
            return []
        slopes = (f"INDEX([{table}.slope],{row})" for row in ("MAX([from],1)", "[p]"))
        one, other = (in_time(self.asked, "", slope, "1")[1] for slope in slopes)
        both = f"INDEX([{table}.way],MAX([from],1))+INDEX([{table}.way],[p])=-2"
        return [
            calc("straight", "straight lines meet", "", "", f"=IF([order]=0,0,IF({both},1,0))",
                 [int(bool(one.lines)) for one in each], format="0;;"),
            calc("lines", "their slopes", "", "",
                 f'=IF([straight]=0,"",": straight lines of "&ROUND({one},9)&" and "&ROUND({other},9))',
                 [one.lines for one in each]),
        ]  # fmt: skip

    def check(self, name: str, label: str) -> Quantity:
        """Return the check that the motion is as smooth as asked; it names joint, jump and phase."""
        says, asked = f"[{self.name}.says]", self.asked
        head = f'{asked.of[0]}&" "&' if asked.of[0] else ""
        told = [self._told(piece, joint).says for piece, joint in zip(self.rows.pieces, self.found, strict=True)]
        first = next((f"{asked.of[1]} {one}".lstrip() for one in told if one), "")
        return check(name, label, f'COUNTIF({says},"?*")=0', self._smooth, ABOUT,
                     says=Said(f'{head}INDEX({says},{first_text(says)})', first))  # fmt: skip

    def _told(self, piece: MotionPiece, joint: Joint) -> Told:
        """Return what the row of a piece tells of the jump where it begins."""
        asked = self.asked
        if not joint.order:
            return Told(0.0, "", "", "", "")
        within = joint.before == piece.phase and joint.lasting > 1
        who = f"row {joint.before + 1}{'' if within else f' to {piece.phase + 1}'} " if asked.rows else ""
        if asked.names:
            who = f"{asked.names[joint.before]}{'' if within else f' to {asked.names[piece.phase]}'} "
        degrees = self.rows.at.degrees and asked.speed is None
        at, size = timed(asked, piece.begin, abs(joint.size), joint.order)
        x, jump, lines = shown(at, DEGREE) if degrees else at, figure(size), self._straight(piece, joint)
        what, unit = ORDERS[joint.order - 1], asked.units[joint.order - 1][1]
        says = f"{who}at {figure(x)}{asked.place[1]}: {what} jumps by {jump} {unit}{lines}"
        return Told(x, Sentence(jump), who, Sentence(lines), Sentence(says))

    def _straight(self, piece: MotionPiece, joint: Joint) -> str:
        """Return the end of the sentence where the phases on both sides are straight: their slopes."""
        if not self.rows.at.ends:
            return ""
        used = sorted({one.phase for one in self.rows.pieces})
        slopes = [slope(self._phases[used.index(row)]) for row in (joint.before, piece.phase)]
        straight = [figure(timed(self.asked, 0.0, one, 1)[1]) for one in slopes if one is not None]
        return f": straight lines of {' and '.join(straight)}" if len(straight) > 1 else ""
