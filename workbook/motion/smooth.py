"""How smooth a motion must be: what jumps at the begin of each of its pieces, and the check of what is asked for."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from engine.motion import Motion, Phase
from engine.motion.joining import JUMP, ORDERS, Joint, Rates, joints, scales_of, slope
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, Sheet, calc, check, constant
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, Sentence, figure, quoted
from workbook.fields.units import DEGREE, shown
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import at_begin, at_place, place_columns
from workbook.motion.requirements import ABOUT, RequiredSmoothness, jump_formulas, jump_values

RATES = ("v", "a", "j")
NOTHING: dict[str, Any] = {  # the values of the cells on a jump, by name, where nothing jumps
    **dict.fromkeys(("what", "unit", "jump", "who", "lines", "says"), ""),
    **dict.fromkeys(("before", "after", "other", "straight"), 0),
    **dict.fromkeys(("place", "size", "slope0", "slope1"), 0.0),
}
EMPTY = '""'
WORDS = ",".join(f'"{word}"' for word in ORDERS)


def opening(piece: MotionPiece) -> float:
    """Return u where a piece begins; 0 of one without duration."""
    return piece.begin - piece.origin if piece.duration else 0.0


@dataclass(frozen=True, eq=False)
class Joints:
    """The joints of a motion's pieces: the engine's, and the columns that find them.

    The piece before is taken by INDEX: of two columns that take the row above within an IF, LibreOffice 7.4 crashes.
    """

    rows: PieceRows
    required: RequiredSmoothness
    found: Sequence[Joint]
    scales: Rates  # the size of each derivative
    phases: Sequence[Phase] = ()

    @classmethod
    def of(cls, rows: PieceRows, motion: Motion, required: RequiredSmoothness) -> Self:
        """Return the joints of a motion of phases."""
        scales = scales_of(motion)
        found = joints(rows.pieces, scales, required.smooth, required.periodic)
        return cls(rows, required, found, scales, motion.phases)

    def order(self) -> list[Quantity]:
        """Return the rows that say how many derivatives must be continuous, and which jumps of each are rounding."""
        entry, (v, a), scales = self.required.entry, self.required.largest, self.scales
        jerk = f"{self.required.order}_a*{self.required.quickest or f'MAX([{self.rows.at.phases}.rate])'}"
        lost = (f"check_zero*{v}", f"check_zero*{a}", jerk)
        formula = f'=IF({entry}="velocity",1,IF({entry}="acceleration",2,3))'
        return [
            calc(self.required.order, "Derivatives that must not jump", "", "", formula,
                 ORDERS.index(self.required.smooth) + 1, format="0"),
            *(calc(f"{self.required.order}_{name}", f"A jump of {word} up to this is none", "", "", f"={formula}",
                   JUMP * scale) for name, word, formula, scale in zip(RATES, ORDERS, lost, scales, strict=True)),
        ]  # fmt: skip

    @property
    def units(self) -> Sequence[str]:
        """The units of the derivatives in sentences."""
        return self.required.units or [self.rows.at.unit(order) for order in range(1, len(ORDERS) + 1)]

    @property
    def name(self) -> str:
        """The name of the table of joints."""
        return self.rows.at.pieces.replace("_pieces", "_joints")

    def table(self, sheet: Sheet, title: str, room: int) -> None:
        """Declare the table of what jumps at the begin of each piece, and rows on the first jump that is too much."""
        pieces = filled(self.rows.pieces, room, replace(self.rows.pieces[-1], duration=0.0))
        found = filled(self.found, room, self.found[-1]._replace(before=-1, jump=Rates(), order=0))
        sheet.table(
            self.name, title, room,
            constant("r", "piece", "k", "", list(range(1, room + 1))),
            *self._lasting(pieces, found), *self._ends(pieces), *self._rates(pieces, found),
            *self._jumps(pieces, found), blank=f"[r]>{self.rows.at.count}",
        )  # fmt: skip
        sheet.rows(*self._first())

    def _lasting(self, pieces: list[MotionPiece], found: list[Joint]) -> list[Quantity]:
        """Return which pieces last, and which phases meet where they begin."""
        at = self.rows.at
        return [
            calc("d", "duration", "d", at.x, f"=[{at.pieces}.d.same]", [piece.duration for piece in pieces],
                 scale=self.rows.end),
            calc("p", "phase", "", "", f"=[{at.pieces}.p.same]", [piece.phase + 1 for piece in pieces], format="0"),
            calc("n", "pieces that last, so far", "", "", "=IF([r]=1,0,[n-1])+IF([d]>0,1,0)",
                 [joint.piece_count for joint in found], format="0"),
            calc("of", "phase of the last of them", "", "", "=IF([d]>0,[p],IF([r]=1,0,[of-1]))",
                 [joint.phase + 1 for joint in found], format="0"),
            calc("from", "phase before", "", "",
                 f"=IF([d]>0,IF([n]=1,[{self.name}.of.last],INDEX([{self.name}.of],[r]-1)),0)",
                 [joint.before + 1 for joint in found], format="0"),
        ]  # fmt: skip

    def _ends(self, pieces: list[MotionPiece]) -> list[Quantity]:
        """Return where each piece ends, with the powers of that; of a motion that opens within one, its begin too."""
        at, room = self.rows.at, len(pieces)
        if not at.opens:
            return place_columns(self.rows, "1", "end", "=[d]", np.array([piece.duration for piece in pieces]), pieces)
        nexts = filled((piece.begin for piece in self.rows.pieces[1:]), room, self.rows.end)
        ends = [after - piece.origin if piece.duration else 0.0 for piece, after in zip(pieces, nexts, strict=True)]
        begins, begin = [opening(piece) for piece in pieces], f"[{at.pieces}.begin.same]"
        after = f"IF([r]<{room},INDEX([{at.pieces}.begin],MIN([r]+1,{room})),{at.end})"
        from_origin = f"=IF([d]>0,{{}}-[{at.pieces}.origin.same],0)"
        return [*place_columns(self.rows, "0", "begin", from_origin.format(begin), np.array(begins), pieces),
                *place_columns(self.rows, "1", "end", from_origin.format(after), np.array(ends), pieces)]  # fmt: skip

    def _rates(self, pieces: list[MotionPiece], found: list[Joint]) -> list[Quantity]:
        """Return y', y'' and y''' at both ends of each piece."""
        rows = self.rows

        def begun(n: int) -> list[float]:
            return [float(piece.curves[n].at(np.array(opening(piece)))) for piece in pieces]

        def begin(n: int) -> str:
            return at_place(rows, n, "0") if rows.at.opens else at_begin(rows, n)

        names = list(zip(RATES, ORDERS, strict=True))
        return [
            *(calc(f"{name}0", word, "", "", f"={begin(n)}", begun(n), scale=self.scales[n - 1],
                   source="at its begin") for n, (name, word) in enumerate(names, 1)),
            *(calc(f"{name}1", f"{word} reached", "", "",
                   f"=IF([d]>0,{at_place(rows, n, '1')},IF([r]=1,0,[{name}1-1]))",
                   [joint.end[n - 1] for joint in found], scale=self.scales[n - 1], source="at its end")
              for n, (name, word) in enumerate(names, 1)),
        ]  # fmt: skip

    def _jumps(self, pieces: list[MotionPiece], found: list[Joint]) -> list[Quantity]:
        """Return the columns of the jumps at the begin of each piece."""
        wraps, marks = self.required.wraps, ("'", "''", "'''")
        last, wrapped = f"[{self.name}.r.last]", len(pieces) * self.required.periodic
        last = f"IF({wraps},{last},0)" if wraps else last
        met = [
            (k if joint.piece_count > 1 else wrapped) * (piece.duration > 0.0)
            for k, (joint, piece) in enumerate(zip(found, pieces, strict=True))
        ]
        cell = self.required.order
        jerk = f"IF(({cell}>2)*(ABS([dj])>{cell}_j),3,0)"
        order = f"=IF(ABS([dv])>{cell}_v,1,IF(({cell}>1)*(ABS([da])>{cell}_a),2,{jerk}))"
        return [
            calc("met", "row of the piece before", "", "", f"=IF([d]>0,IF([n]=1,{last},[r]-1),0)",
                 met, format="0", source="0: none"),
            *(calc(f"d{name}", f"jump of {word}", f"Δy{mark}", "",
                   f"=IF([met]>0,[{name}0]-INDEX([{self.name}.{name}1],[met]),0)",
                   [joint.jump[n - 1] for joint in found], scale=self.scales[n - 1], source="at its begin")
              for n, (name, word, mark) in enumerate(zip(RATES, ORDERS, marks, strict=True), 1)),
            calc("order", "what jumps", "", "", order, [joint.order for joint in found],
                 format="0", source="1 y', 2 y'', 3 y" "'''"),
            calc("size", "by how much", "", "", "=CHOOSE([order]+1,0,[dv],[da],[dj])",
                 [joint.size for joint in found], scale=max(self.scales)),
        ]  # fmt: skip

    @property
    def _worst(self) -> tuple[MotionPiece, Joint] | None:
        """The first joint that is less smooth than asked, and the piece that begins there."""
        both = zip(self.rows.pieces, self.found, strict=True)
        return next(((piece, joint) for piece, joint in both if joint.order), None)

    def _first(self) -> list[Quantity]:
        """Return the rows of the first joint that is less smooth than asked: its piece, place, size and sentence."""
        required, name, told = self.required, self.required.order, self._told()

        def at(column: str) -> str:
            return f"INDEX([{column}],{name}_piece)"

        order = at(f"{self.name}.order")
        x, size = jump_formulas(required, at(f"{self.rows.at.pieces}.begin"), f"ABS({at(f'{self.name}.size')})", order)
        units = ",".join(map(quoted, self.units))
        who, straight = self._who(), self._straight_lines()
        number = self.found.index(self._worst[1]) + 1 if self._worst else 0
        says = (
            f'{f"{name}_who&" if who else ""}"at "&ROUND({name}_place,9)&{quoted(required.place)}&": "&{name}_what'
            f'&" jumps by "&{name}_jump&" "&{name}_unit{f"&{name}_lines" if straight else ""}'
        )
        phases = [
            ("before", "Phase before", at(f"{self.name}.from")),
            ("after", "Phase that begins or goes on", at(f"{self.name}.p")),
            ("other", "Another phase begins: 1 yes, 0 no",
             f"IF(OR({name}_before<>{name}_after,{at(f'{self.name}.n')}=1),1,0)"),
        ]  # fmt: skip
        rows = [
            ("place", "Where it begins", x),
            ("what", "What jumps there", f"CHOOSE({order},{WORDS})"),
            ("size", "It jumps by", size),
            ("unit", "in", f"CHOOSE({order},{units})"),
            ("jump", "as told", f'IF({name}_size<1000000000,ROUND({name}_size,9)&"","beyond 1E9")'),
            *(phases if who or straight else []),
            *([("who", "Between", who)] if who else []),
            *straight,
            ("says", "What is less smooth than asked", says),
        ]
        first = f"ROUND(1/SUMPRODUCT(MAX(([{self.name}.order]>0)/[{self.name}.r])),0)"
        return [
            calc(f"{name}_piece", "First piece that begins less smoothly than asked", "", "",
                 f"=IF(SUM([{self.name}.order])=0,0,{first})", number, format="0", source="0 where none does"),
            *(calc(f"{name}_{mark}", label, "", "",
                   f"=IF({name}_piece=0,{EMPTY if NOTHING[mark] == '' else 0},{formula})", told[mark])
              for mark, label, formula in rows),
        ]  # fmt: skip

    def _who(self) -> str:
        """Return the formula of the phases between which the first jump is; nothing where they have no names."""
        name = self.required.order
        one, two = (f"INDEX([{self.rows.at.phases}.what],{name}_{end})" for end in ("before", "after"))
        return f'{one}&IF({name}_other=1," to "&{two},"")&" "' if self.required.names else ""

    def _straight_lines(self) -> list[tuple[str, str, str]]:
        """Return the rows of the slopes on both sides of the first jump, where both are straight."""
        table, name = self.rows.at.required, self.required.order
        if not table:
            return []
        both = "+".join(f"INDEX([{table}.way],{name}_{end})" for end in ("before", "after"))

        def slope_of(end: str) -> str:
            _, formula = jump_formulas(self.required, "", f"INDEX([{table}.slope],{name}_{end})", "1")
            return f"{name}_straight*{formula}"

        says = f'": straight lines of "&ROUND({name}_slope0,9)&" and "&ROUND({name}_slope1,9)'
        return [
            ("straight", "Two straight lines meet there", f"IF({both}=-2,1,0)"),
            ("slope0", "Slope of the first", slope_of("before")),
            ("slope1", "Slope of the second", slope_of("after")),
            ("lines", "as told", f'IF({name}_straight=1,{says},"")'),
        ]

    def check(self, name: str, label: str) -> Quantity:
        """Return the check that the motion is as smooth as asked; it names joint, jump and phase."""
        required = self.required
        head = f'{required.of[0]}&" "&' if required.of[0] else ""
        said = f"{required.of[1]} {self._told()['says']}".lstrip() if self._worst else ""
        says = CheckSentence(f"{head}{required.order}_says", said)
        return check(name, label, f"{required.order}_piece=0", not self._worst, ABOUT, says=says)

    def _told(self) -> dict[str, Any]:
        """Return the values of the cells on the first joint that is less smooth than required, by name."""
        required = self.required
        if not self._worst:
            return NOTHING
        piece, joint = self._worst
        within = joint.before == piece.phase and joint.piece_count > 1
        names = required.names
        who = f"{names[joint.before]}{'' if within else f' to {names[piece.phase]}'} " if names else ""
        degrees = self.rows.at.degrees and required.speed is None
        at, size = jump_values(required, piece.begin, abs(joint.size), joint.order)
        x, jump, slopes = shown(at, DEGREE) if degrees else at, figure(size), self._slopes(piece, joint)
        lines = f": straight lines of {' and '.join(figure(one) for one in slopes)}" if slopes else ""
        what, unit = ORDERS[joint.order - 1], self.units[joint.order - 1]
        says = f"{who}at {figure(x)}{required.place}: {what} jumps by {jump} {unit}{lines}"
        return NOTHING | {
            "place": x, "what": what, "size": size, "unit": unit, "jump": Sentence(jump), "who": who,
            "before": joint.before + 1, "after": piece.phase + 1, "other": int(not within),
            "straight": int(bool(slopes)), **{f"slope{i}": slope for i, slope in enumerate(slopes)},
            "lines": Sentence(lines), "says": Sentence(says),
        }  # fmt: skip

    def _slopes(self, piece: MotionPiece, joint: Joint) -> tuple[float, ...]:
        """Return the slopes of the phases on both sides, where both are straight."""
        if not self.rows.at.ends:
            return ()
        used = sorted({one.phase for one in self.rows.pieces})
        slopes = [slope(self.phases[used.index(row)]) for row in (joint.before, piece.phase)]
        straight = tuple(jump_values(self.required, 0.0, one, 1)[1] for one in slopes if one is not None)
        return straight if len(straight) > 1 else ()
