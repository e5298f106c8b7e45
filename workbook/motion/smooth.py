"""The smoothness of a motion: the jumps at the begin of each of its pieces, and the check of what is asked for."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from engine.motion import Motion, Phase
from engine.motion.joining import JUMP, ORDERS, Joint, Rates, joints, scales_of, slope
from engine.motion.pieces import MotionPiece
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, Sentence, figure, quoted
from workbook.fields.units import DEGREE, shown
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import at_begin, at_place, place_columns
from workbook.motion.requirements import ABOUT, RequiredSmoothness, jump_formulas, jump_values

CELLS = cell_tables(__file__)

NOTHING: dict[str, Any] = {  # the values of the cells on a jump, by name, where nothing jumps
    **dict.fromkeys(("what", "unit", "jump", "who", "lines", "says"), ""),
    **dict.fromkeys(("before", "after", "other", "straight"), 0),
    **dict.fromkeys(("place", "size", "slope0", "slope1"), 0.0),
}


def opening(piece: MotionPiece) -> float:
    """Return u where a piece begins; 0 for a piece without duration."""
    return piece.begin - piece.origin if piece.duration else 0.0


@dataclass(frozen=True, eq=False)
class Joints:
    """The joints of a motion's pieces: the engine's, and the columns that find them.

    The piece before is taken by INDEX: of two columns that take the row above within an IF, LibreOffice 7.4 crashes.
    """

    rows: PieceRows
    required: RequiredSmoothness
    joints: Sequence[Joint]
    scales: Rates  # the size of each derivative
    phases: Sequence[Phase] = ()

    @classmethod
    def of(cls, rows: PieceRows, motion: Motion, required: RequiredSmoothness) -> Self:
        """Return the joints of a motion of phases."""
        scales = scales_of(motion)
        found_joints = joints(rows.pieces, scales, required.smooth, required.periodic)
        return cls(rows, required, found_joints, scales, motion.phases)

    def order(self) -> list[Quantity]:
        """Return the rows that say how many derivatives must be continuous, and which jumps of each are rounding."""
        scales = self.scales
        quickest = self.required.quickest or f"MAX([{self.rows.at.phases}.rate])"
        cell = CELLS["order"].sharing(order=self.required.order)
        return [
            cell("{order}", ORDERS.index(self.required.smooth) + 1, entry=self.required.entry),
            cell("{order}_v", JUMP * scales[0], largest=self.required.largest[0]),
            cell("{order}_a", JUMP * scales[1], largest=self.required.largest[1]),
            cell("{order}_j", JUMP * scales[2], quickest=quickest),
        ]

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
        joints = filled(self.joints, room, self.joints[-1]._replace(before=-1, jump=Rates(), order=0))
        cell = CELLS["lasting"].sharing(at=self.rows.at)
        sheet.table(
            self.name,
            title,
            room,
            cell("r", list(range(1, room + 1))),
            cell("n", [joint.piece_count for joint in joints]),
            cell("of", [joint.phase + 1 for joint in joints]),
            *self._ends(pieces),
            *self._rates(pieces, joints),
            *self._jumps(pieces, joints),
            blank=f"[r]>{self.rows.at.count}",
        )
        sheet.rows(*self._first())

    def _ends(self, pieces: list[MotionPiece]) -> list[Quantity]:
        """Return the columns of each piece's end, with its powers; of its begin if a motion opens within."""
        at, room = self.rows.at, len(pieces)
        if not at.opens:
            durations = np.array([piece.duration for piece in pieces])
            return place_columns(self.rows, "1", "end", f"=[{at.pieces}.d.same]", durations, pieces)
        nexts = filled((piece.begin for piece in self.rows.pieces[1:]), room, self.rows.end)
        ends = [after - piece.origin if piece.duration else 0.0 for piece, after in zip(pieces, nexts, strict=True)]
        begins, begin = [opening(piece) for piece in pieces], f"[{at.pieces}.begin.same]"
        after = f"IF([r]<{room},INDEX([{at.pieces}.begin],MIN([r]+1,{room})),{at.end})"
        from_origin = f"=IF([{at.pieces}.d.same]>0,{{}}-[{at.pieces}.origin.same],0)"
        return [
            *place_columns(self.rows, "0", "begin", from_origin.format(begin), np.array(begins), pieces),
            *place_columns(self.rows, "1", "end", from_origin.format(after), np.array(ends), pieces),
        ]

    def _rates(self, pieces: list[MotionPiece], joints: list[Joint]) -> list[Quantity]:
        """Return y', y'' and y''' at both ends of each piece."""
        cell, rows = CELLS["rates"].sharing(at=self.rows.at), self.rows
        at_begins = [np.array(opening(piece)) for piece in pieces]

        def begun(name: str, n: int) -> Quantity:
            values = [float(piece.curves[n](u)) for piece, u in zip(pieces, at_begins, strict=True)]
            begin = at_place(rows, n, "0") if rows.at.opens else at_begin(rows, n)
            return cell(name, values, begin=begin, scale=self.scales[n - 1])

        def reached(name: str, n: int) -> Quantity:
            values = [joint.end[n - 1] for joint in joints]
            return cell(name, values, end=at_place(rows, n, "1"), scale=self.scales[n - 1])

        return [begun("v0", 1), begun("a0", 2), begun("j0", 3), reached("v1", 1), reached("a1", 2), reached("j1", 3)]

    def _jumps(self, pieces: list[MotionPiece], joints: list[Joint]) -> list[Quantity]:
        """Return the columns of the jumps at the begin of each piece."""
        wraps, wrapped = self.required.wraps, len(pieces) * self.required.periodic
        last = f"[{self.name}.r.last]"
        last = f"IF({wraps},{last},0)" if wraps else last
        met = [
            (k if joint.piece_count > 1 else wrapped) * (piece.duration > 0.0)
            for k, (joint, piece) in enumerate(zip(joints, pieces, strict=True))
        ]
        cell = CELLS["jumps"].sharing(joints=self.name, order=self.required.order, at=self.rows.at)
        scales = self.scales
        return [
            cell("met", met, last=last),
            cell("dv", [joint.jump.v for joint in joints], scale=scales.v),
            cell("da", [joint.jump.a for joint in joints], scale=scales.a),
            cell("dj", [joint.jump.j for joint in joints], scale=scales.j),
            cell("order", [joint.order for joint in joints]),
        ]

    @property
    def _worst(self) -> tuple[MotionPiece, Joint] | None:
        """The first joint that is less smooth than asked, and the piece that begins there."""
        both = zip(self.rows.pieces, self.joints, strict=True)
        return next(((piece, joint) for piece, joint in both if joint.order), None)

    def _first(self) -> list[Quantity]:
        """Return the rows of the first joint that is less smooth than asked: its piece, place, size and sentence."""
        required, order, words = self.required, self.required.order, self._words()
        at, asked, named = self.rows.at, self.rows.at.required, bool(self.required.names)
        cell = CELLS["first"].sharing(order=order, joints=self.name, phases=at.phases, asked=asked, at=at)

        def row(name: str, **parts: str) -> Quantity:
            return cell(name, words[name.removeprefix("{order}_")], **parts)

        def of_piece(column: str) -> str:
            return f"INDEX([{column}],{order}_piece)"

        def slope_of(end: str) -> str:
            return jump_formulas(required, "", f"INDEX([{asked}.slope],{order}_{end})", "1")[1]

        begin, what = of_piece(f"{at.pieces}.begin"), of_piece(f"{self.name}.order")
        jump = f"ABS(INDEX([{self.name}.dv:dj],{order}_piece,{what}))"
        place, size = jump_formulas(required, begin, jump, what)
        phases = [row("{order}_before"), row("{order}_after"), row("{order}_other")]
        straight = [
            row("{order}_straight"),
            row("{order}_slope0", slope=slope_of("before")),
            row("{order}_slope1", slope=slope_of("after")),
            row("{order}_lines"),
        ]
        return [
            cell("{order}_piece", self.joints.index(self._worst[1]) + 1 if self._worst else 0),
            row("{order}_place", place=place),
            row("{order}_what"),
            row("{order}_size", size=size),
            row("{order}_unit", units=",".join(map(quoted, self.units))),
            row("{order}_jump"),
            *(phases if named or asked else []),
            *([row("{order}_who")] if named else []),
            *(straight if asked else []),
            row(
                "{order}_says",
                who=f"{order}_who&" if named else "",
                behind=quoted(required.place),
                lines=f"&{order}_lines" if asked else "",
            ),
        ]

    def check(self, name: str, label: str) -> Quantity:
        """Return the check that the motion is as smooth as asked; it names joint, jump and phase."""
        required = self.required
        head = f'{required.of[0]}&" "&' if required.of[0] else ""
        sentence = f"{required.of[1]} {self._words()['says']}".lstrip() if self._worst else ""
        says, ok = CheckSentence(f"{head}{required.order}_says", sentence), not self._worst
        return CELLS["check"]("{name}", ok, name=name, label=label, order=required.order, source=ABOUT, says=says)

    def _words(self) -> dict[str, Any]:
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
        x, jump = shown(at, DEGREE) if degrees else at, figure(size)
        slopes = self._slopes(piece, joint)
        lines = f": straight lines of {' and '.join(figure(slope) for slope in slopes)}" if slopes else ""
        what, unit = ORDERS[joint.order - 1], self.units[joint.order - 1]
        says = f"{who}at {figure(x)}{required.place}: {what} jumps by {jump} {unit}{lines}"
        return NOTHING | {
            "place": x,
            "what": what,
            "size": size,
            "unit": unit,
            "jump": Sentence(jump),
            "who": who,
            "before": joint.before + 1,
            "after": piece.phase + 1,
            "other": int(not within),
            "straight": int(bool(slopes)),
            **{f"slope{i}": slope for i, slope in enumerate(slopes)},
            "lines": Sentence(lines),
            "says": Sentence(says),
        }

    def _slopes(self, piece: MotionPiece, joint: Joint) -> tuple[float, ...]:
        """Return the slopes of the phases on both sides, where both are straight."""
        if not self.rows.at.ends:
            return ()
        used = sorted({piece_row.phase for piece_row in self.rows.pieces})
        slopes = [slope(self.phases[used.index(row)]) for row in (joint.before, piece.phase)]
        straight = tuple(jump_values(self.required, 0.0, rate, 1)[1] for rate in slopes if rate is not None)
        return straight if len(straight) > 1 else ()
