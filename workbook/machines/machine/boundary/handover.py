"""The phases of an axis that hand velocity over, at their place in its book: their tables and their checks.

A straight line hands its velocity to both of its neighbours, a dwell its rest. A law of two pulses has v0 and h_a times
the law while it speeds up, v1 and h_b times it from then on; h_a and h_b follow from the stroke and from the velocity
between the pulses. A polynomial is the one of its degree by Hermite's conditions. Source: LCamHdl, ProfileTypes, C_C_,
D_C_ and C_D_ laws, POLY_3, POLY_5, POLY_7.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from engine.laws.ends import ROUNDING, BoundaryValues
from engine.motion.handover import FIXED, LINE, NEVER, PULSES, STRAIGHT, Handover, handovers
from engine.motion.joining import Rates, agrees
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, calc, check, constant
from workbook.book.rows import filled, spread
from workbook.book.sentence import CheckSentence, first_text
from workbook.entries.abscissa import Abscissa
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows

SPEED, BEND = " with a velocity", " with an acceleration"
RESTS = ": it begins and ends at rest"
ONLY = ": it takes a velocity only"
KEPT = ": what it has there follows from its points"
CARRIED = "0 between rests, 1 as two pulses, 2 straight on, 3, 5, 7 as a polynomial"
BESIDE = ": its begin is entered otherwise than the straight line or dwell there has it"
DIFFERS = "IF(OR(ABS([ev]-[{0}])>check_zero*(ABS([ev])+ABS([{0}])),ABS([ea])>0),1,0)"
"""whether a velocity or an acceleration is entered that a straight line of a slope has not"""
NONE = Rates()


class AxisHandover:
    """What the phases of an axis take from their neighbours; they stand in every second row of its steps.

    ``room`` are the rows of the table of steps; ``in_row`` has the number in the motion of the step of each used row.
    """

    def __init__(self, rows: PieceRows, axis: MovingAxis, over: Abscissa) -> None:
        self.rows, self.axis, self.over, self.motion = rows, axis, over, axis.motion
        self.handed = handovers(replace(axis.joined, motion=axis.motion), axis.entered_rates, axis.given.repeats)
        self.entries = f"axis{axis.number}"
        self.required, self.kinds, self.last = rows.at.required, f"{self.entries}_kinds", f"{self.entries}_last"
        self.open, self.room = f'[axes.closes.{axis.number}]="open"', len(rows.firsts)
        self.in_row = {place: k for k, place in enumerate(axis.places)}

    def step_of(self, piece: MotionPiece) -> Handover:
        """Return the step that a piece is of."""
        return self.handed[self.in_row[piece.phase]]

    def begin_of(self, piece: MotionPiece) -> float:
        """Return the position at which the step of a piece begins."""
        return self.motion.ends[self.in_row[piece.phase]].begin.y

    def of(self, figure: Callable[[Handover], Any], spare: Any = 0.0) -> list[Any]:
        """Return a figure of each step, row by row."""
        return self.spread([figure(one) for one in self.handed], spare)

    def spread(self, values: list[Any], spare: Any = 0.0) -> list[Any]:
        """Return values of the steps in their rows."""
        return spread(values, self.axis.places, self.room, spare)

    def rate(self, order: int, name: str, label: str, symbol: str, formula: str, values: Any, of: str = "") -> Quantity:
        """Return a column of a derivative of the motion, or its position (order 0): a figure of each step, or all."""
        found = self.of(values) if callable(values) else values
        return calc(
            name, label, symbol, self.rows.at.unit(order), formula, found, scale=self.motion.size(order), source=of
        )

    def number(self, name: str, label: str, formula: str, values: Any, source: str = "", **more: Any) -> Quantity:
        """Return a column of whole numbers: a figure of each step, or all of them."""
        found = self.of(values, 0) if callable(values) else values
        return calc(name, label, "", "", formula, found, source=source, **{"format": "0", **more})

    def steps(self) -> list[Quantity]:
        """Return the columns that tables of steps begin with: row, lift, duration."""
        phases = self.rows.at.phases
        return [
            constant("k", "row", "k", "", list(range(1, self.room + 1))),
            self.rate(0, "h", "lift", "h", f"=INDEX([{phases}.h],[k])", lambda step: step.phase.lift, "of the phase"),
            calc("span", "duration", "δ", self.rows.at.x, f"=INDEX([{phases}.span],[k])",
                 self.of(lambda step: step.phase.duration), scale=self.motion.total, source="of the phase"),
        ]  # fmt: skip

    @property
    def phases(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return [(i, self.handed[k]) for i, k in enumerate(self.axis.entered, 1)]

    @property
    def before(self) -> list[Handover | None]:
        """The step before each; None before the first of a motion that does not repeat."""
        return [self.handed[-1] if self.axis.given.repeats else None, *self.handed[:-1]]

    def own(self, column: str, formula: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else a figure from here."""
        ends = self.rows.at.ends
        ended = f"INDEX([{ends}.{column}],[k])" if column else "0"
        return f"=IF(INDEX([{ends}.mode],[k])=0,{formula.removeprefix('=')},{ended})"

    def faults(self) -> list[str]:
        """Return for each step why it cannot have its ends, as its row of the table says it."""
        found, laws = [""] * len(self.handed), [phase.law for phase in self.axis.given.phases]
        for (i, one), k in zip(self.phases, self.axis.entered, strict=True):
            found[k] = f"row {i}: {laws[i - 1]} cannot {''.join(why_impossible(one))}" if one.fault else ""
        return found

    def checks(self, name: str, label: str) -> list[Quantity]:
        """Return the checks, of names and labels that begin so, that laws can have their ends and no line objects."""
        table = self.required
        texts, against = f"[{table}.fault]", f"[{table}.contrary]"
        axis, called = self.axis.given.name, f'[axes.name.{self.axis.number}]&" '
        fault = next(filter(None, self.faults()), "")
        contrary = next((f"{axis} row {i}{BESIDE}" for i, one in self.phases if one.contrary), "")
        return [
            check(f"{name}_meets", f"{label}each law meets its neighbours", f"SUM([{table}.cannot])=0", not fault,
                  says=CheckSentence(f'{called}"&INDEX({texts},{first_text(texts)})', fault and f"{axis} {fault}")),
            check(f"{name}_passes", f"{label}what is entered goes with straight lines and dwells", f"SUM({against})=0",
                  not contrary, says=CheckSentence(f'{called}row "&MATCH(1,{against},0)/2&"{BESIDE}"', contrary)),
        ]  # fmt: skip


def why_impossible(one: Handover) -> tuple[str, str, str]:
    """Return at which end a phase cannot have what is asked for, what that is, and why; nothing where it can."""
    if not one.fault:
        return "", "", ""
    begin, end = one.begin.required, one.end.required
    never, moving = one.end_mode == NEVER, bool(begin.v or end.v)
    first = begin.v if never and moving else begin.a
    return ("begin" if first else "end", SPEED if never and moving else BEND,
            RESTS if never else KEPT if one.end_mode == FIXED else ONLY)  # fmt: skip


def required_ends(one: AxisHandover) -> list[Quantity]:
    """Return the columns of what each step takes."""
    way = f"=IF([span]>0,INDEX(law_way,INDEX([{one.rows.at.phases}.no],[k])),-1)"
    return [
        *one.steps(),
        one.number("way", "meets its neighbours' velocity", way, one.of(lambda step: step.end_mode, STRAIGHT),
                   "−1 has one, 0 cannot, 1 by two pulses, 2 has its own, 3, 5, 7 by a polynomial"),
        one.rate(1, "slope", "its own velocity", "h/δ", "=IF(AND([way]=-1,[span]>0),[h]/[span],0)",
                 lambda step: step.slope, "of a straight line"),
        *neighbours(one), *ends(one), *handover_modes(one),
    ]  # fmt: skip


def straight(step: Handover | None) -> int:
    """Return whether a step is a straight line or a dwell."""
    return int(step is not None and step.end_mode == STRAIGHT)


def neighbours(one: AxisHandover) -> list[Quantity]:
    """Return the columns of the steps beside each, if these are straight, and of what is entered for phases."""
    rows, table, around = [place + 1 for place in one.axis.places], one.required, one.axis.given.repeats
    earlier = [max((row for row in rows if row < k), default=0) for k in range(1, one.room + 1)]
    before, after = [rows[-1] if around else 0, *rows[:-1]], [*rows[1:], rows[0] if around else 0]
    following = [*one.handed[1:], one.handed[0] if around else None]
    line = "=IF([{0}]>0,IF(INDEX([{1}.way],[{0}])=-1,1,0),0)"
    lift = one.over.lift(one.axis.given.unit)
    v, a = (f"INDEX([{one.entries}.{name}],[row])" for name in ("velocity", "acceleration"))

    def by_rad(cell: str, order: int) -> str:
        entered = one.over.per_rad_formula(f"{cell}{lift.taken}", order)
        return f"=IF([k]<>2*[row],0,IF(ISNUMBER({cell}),{entered},0))"

    return [
        one.number("earlier", "the last step above that lasts",
                   "=IF([k]=1,0,IF([span-1]>0,[k]-1,[earlier-1]))", earlier, "0: none"),
        one.number("before", "step before", f"=IF([span]=0,0,IF([earlier]>0,[earlier],IF({one.open},0,{one.last})))",
                   one.spread(before, 0), "0: none"),
        one.number("after", "step after",
                   f"=IF(OR([span]=0,AND([k]={one.last},{one.open})),0,MATCH([k],[{table}.before],0))",
                   one.spread(after, 0), "0: none"),
        one.number("line0", "straight before it", line.format("before", table),
                   one.spread([*map(straight, one.before)], 0), "a line or a dwell"),
        one.rate(1, "slope0", "velocity of that", "", f"=IF([line0]=1,INDEX([{table}.slope],[before]),0)",
                 one.spread([step.slope if step and straight(step) else 0.0 for step in one.before])),
        one.number("line1", "straight after it", line.format("after", table),
                   one.spread([*map(straight, following)], 0)),
        one.number("row", "row of its phase", "=MAX(1,INT([k]/2))", [max(1, k // 2) for k in range(1, one.room + 1)],
                   "of a rest that before it"),
        one.number("set", "its begin is entered", f"=IF([k]<>2*[row],0,IF(COUNT({v},{a})>0,1,0))",
                   lambda step: int(step.entered is not None)),
        one.rate(1, "ev", "velocity entered", "", by_rad(v, 1), lambda step: (step.entered or NONE).v),
        one.rate(2, "ea", "acceleration entered", "", by_rad(a, 2), lambda step: (step.entered or NONE).a),
    ]  # fmt: skip


def ends(one: AxisHandover) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and whether these are settled."""
    later = f"INDEX([{one.required}.{{}}],MAX([after],1))".format
    return [
        one.number("settled0", "begin is settled", "=IF(OR([way]=-1,[before]=0,[line0]=1),1,[set])",
                   one.of(lambda step: int(step.begin.settled), 1), "by a line, a dwell, an entry"),
        one.number("settled1", "end is settled", f"=IF(OR([way]=-1,[after]=0,[line1]=1),1,{later('set')})",
                   one.of(lambda step: int(step.end.settled), 1), "likewise"),
        one.rate(1, "w0", "velocity at its begin", "v_0", "=IF([way]=-1,[slope],IF([line0]=1,[slope0],[ev]))",
                 lambda step: step.begin.required.v),
        one.rate(1, "w1", "velocity at its end", "v_1",
                 f"=IF([way]=-1,[slope],([after]>0)*IF([line1]=1,{later('slope')},{later('ev')}))",
                 lambda step: step.end.required.v),
        one.rate(2, "q0", "acceleration at its begin", "a_0", "=IF(OR([way]=-1,[line0]=1),0,[ea])",
                 lambda step: step.begin.required.a),
        one.rate(2, "q1", "acceleration at its end", "a_1", f"=IF(OR([way]=-1,[line1]=1,[after]=0),0,{later('ea')})",
                 lambda step: step.end.required.a),
        one.rate(1, "moved", "sum of |v|", "", "=ABS([w0])+ABS([w1])",
                 lambda step: abs(step.begin.required.v) + abs(step.end.required.v)),
        one.rate(2, "bent", "sum of |a|", "", "=ABS([q0])+ABS([q1])",
                 lambda step: abs(step.begin.required.a) + abs(step.end.required.a)),
    ]  # fmt: skip


def handover_modes(one: AxisHandover) -> list[Quantity]:
    """Return the columns of whether a straight line is against an entry, how a law is carried out, or why not."""

    def differs(step: Handover, line: Handover | None) -> int:
        return int(line is not None and straight(line) and not agrees(step.entered or NONE, line.slope))

    def straight_on(step: Handover) -> int:
        begin, end, d = step.begin.required, step.end.required, step.phase.duration
        return int(BoundaryValues(step.phase.lift, begin.v * d, end.v * d, begin.a * d**2, end.a * d**2).straight)

    lies = f"AND(ABS([w1]-[w0])<={ROUNDING:.0E}*ABS([w0]),ABS([h]-[w0]*[span])<={ROUNDING:.0E}*ABS([h]))"
    texts, speeds = one.spread([why_impossible(step) for step in one.handed], ("", "", "")), "AND([way]=0,[moved]>0)"
    says = (
        ("verb", "at which end", f'IF(IF({speeds},ABS([w0]),ABS([q0]))>0,"begin","end")'),
        ("what", "what it cannot have", f'IF({speeds},"{SPEED}","{BEND}")'),
        ("why", "why", f'IF([way]=0,"{RESTS}",IF([way]={FIXED},"{KEPT}","{ONLY}"))'),
    )
    return [
        one.number("off", "is entered otherwise than its own velocity", f"=IF([way]=-1,{DIFFERS.format('slope')},0)",
                   lambda step: differs(step, step)),
        one.number("off0", "or than that before it", f"=IF([line0]=1,{DIFFERS.format('slope0')},0)",
                   one.spread([differs(*both) for both in zip(one.handed, one.before, strict=True)], 0)),
        one.number("contrary", "is entered otherwise", "=IF([set]*([off]+[off0])>0,1,0)",
                   lambda step: int(step.contrary), "than a straight line there has it", format="0;;"),
        one.number("straight", "its ends are those of a straight line", f"=IF([bent]>0,0,IF({lies},1,0))",
                   one.of(straight_on, 1)),
        one.number("cannot", "cannot have such ends",
                   "=IF(OR(AND([way]=0,[moved]+[bent]>0),AND(OR([way]=1,[way]=2,[way]=3),[bent]>0)),1,0)",
                   lambda step: int(bool(step.fault)), "1 where it cannot", format="0;;"),
        one.number("mode", "is carried out",
                   f"=IF(OR([way]=-1,[way]=2,[cannot]=1,[moved]+[bent]=0),0,IF([straight]=1,{LINE},[way]))",
                   lambda step: step.mode, CARRIED),
        *(calc(name, label, "", "", f'=IF([cannot]=0,"",{formula})', [text[i] for text in texts], align="left")
          for i, (name, label, formula) in enumerate(says)),
        calc("fault", "what it says", "", "",
             f'=IF([cannot]=0,"","row "&[row]&": "&INDEX([{one.entries}.law],[row])&" cannot "&[verb]&[what]&[why])',
             one.spread(one.faults(), ""), align="left"),
    ]  # fmt: skip


def taken_by_pieces(one: AxisHandover, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table that say what a piece takes over."""
    at = one.rows.at

    def of(figure: Callable[[Handover, bool, MotionPiece], Any]) -> list[Any]:
        both = ((piece, one.step_of(piece)) for piece in one.rows.pieces)
        found = [figure(step, step.mode == PULSES and piece.number >= step.early, piece) for piece, step in both]
        return filled(found, room, found[-1])

    def half(column: str) -> str:
        return f"=IF([late]=1,INDEX([{at.ends}.{column}1],[p]),INDEX([{at.ends}.{column}0],[p]))"

    return [
        one.number("late", "in the second half", f"=IF([m]<{at.of_end('split')},0,IF({at.of_end('mode')}=1,1,0))",
                   of(lambda _, late, __: int(late))),
        one.rate(0, "hp", "lift of its half", "h", half("h"), of(lambda step, late, _: step.halves[late])),
        one.rate(1, "drift", "velocity added", "", half("d"), of(lambda step, late, _: step.drifts[late])),
        one.rate(0, "base", "position without the law", "",
                 f"={at.of_phase('y0')}+IF([late]=1,{at.of_phase('h')}-[hp]-[drift]*{at.of_phase('span')},0)",
                 of(lambda step, late, piece: step.base(late, one.begin_of(piece)))),
    ]  # fmt: skip
