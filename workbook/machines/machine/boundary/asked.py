"""What a step takes from the steps beside it, in cells: the velocity of a straight line, a dwell's rest, an entry."""

from engine.laws.ends import ROUNDING, Ends
from engine.motion.handover import FIXED, LINE, STRAIGHT, Handover
from engine.motion.joining import Rates, agrees
from workbook.book.declare import Quantity, calc, constant
from workbook.machines.machine.boundary.handing import BEND, KEPT, ONLY, RESTS, SPEED, Handing, reason

DIFFERS = "IF(OR(ABS([ev]-[{0}])>check_zero*(ABS([ev])+ABS([{0}])),ABS([ea])>0),1,0)"
"""whether a velocity or an acceleration is entered that a straight line of a slope has not"""
NONE = Rates()


def asked(one: Handing) -> list[Quantity]:
    """Return the columns of what each step takes."""
    at = one.rows.at
    return [
        constant("k", "row", "k", "", list(range(1, one.room + 1))),
        calc("h", "lift", "h", at.y, f"=INDEX([{at.phases}.h],[k])", one.of(lambda step: step.phase.lift),
             scale=one.motion.size(0), source="of the phase"),
        calc("span", "duration", "δ", at.x, f"=INDEX([{at.phases}.span],[k])",
             one.of(lambda step: step.phase.duration), scale=one.motion.total, source="of the phase"),
        calc("way", "meets its neighbours' velocity", "", "",
             f"=IF([span]>0,INDEX(law_way,INDEX([{at.phases}.no],[k])),-1)",
             one.of(lambda step: step.end_mode, STRAIGHT),
             format="0", source="−1 has one, 0 cannot, 1 by two pulses, 2 has its own, 3, 5, 7 by a polynomial"),
        calc("slope", "its own velocity", "h/δ", at.unit(1),
             "=IF(AND([way]=-1,[span]>0),[h]/[span],0)", one.of(lambda step: step.slope), scale=one.motion.size(1),
             source="of a straight line"),
        *beside(one), *entered(one), *ends(one), *contrary(one), *carried_out(one),
    ]  # fmt: skip


def beside(one: Handing) -> list[Quantity]:
    """Return the columns of the steps before and after, and whether these are straight lines or dwells."""
    rows, table = [place + 1 for place in one.axis.places], one.asked
    around = rows[-1] if one.axis.given.repeats else 0
    earlier = [0, *(rows[sum(row < k for row in rows) - 1] if k > rows[0] else 0 for k in range(2, one.room + 1))]
    before = dict(zip(rows, [around, *rows[:-1]], strict=True))
    after = dict(zip(rows, [*rows[1:], rows[0] if around else 0], strict=True))
    steps = dict(zip(rows, one.handed, strict=True))

    def of(side: dict[int, int]) -> list[int]:
        return [side.get(k, 0) for k in range(1, one.room + 1)]

    def straight(side: dict[int, int]) -> list[int]:
        return [int(k > 0 and steps[k].end_mode == STRAIGHT) for k in of(side)]

    slopes = [steps[k].slope if k and steps[k].end_mode == STRAIGHT else 0.0 for k in of(before)]
    line = "=IF([{0}]>0,IF(INDEX([{1}.way],[{0}])=-1,1,0),0)"
    return [
        calc("earlier", "the last step above that lasts", "", "", "=IF([k]=1,0,IF([span-1]>0,[k]-1,[earlier-1]))",
             earlier, format="0", source="0: none"),
        calc("before", "step before", "", "",
             f"=IF([span]=0,0,IF([earlier]>0,[earlier],IF({one.open},0,{one.last})))", of(before), format="0",
             source="0: none"),
        calc("after", "step after", "", "",
             f"=IF(OR([span]=0,AND([k]={one.last},{one.open})),0,MATCH([k],[{table}.before],0))", of(after), format="0",
             source="0: none"),
        calc("line0", "straight before it", "", "", line.format("before", table), straight(before), format="0",
             source="a line or a dwell"),
        calc("slope0", "velocity of that", "", one.rows.at.unit(1),
             f"=IF([line0]=1,INDEX([{table}.slope],[before]),0)", slopes, scale=one.motion.size(1)),
        calc("line1", "straight after it", "", "", line.format("after", table), straight(after), format="0"),
    ]  # fmt: skip


def entered(one: Handing) -> list[Quantity]:
    """Return the columns of what is entered for the begin of a phase; nothing for a rest, in each odd row."""
    at, lift = one.rows.at, one.over.lift(one.axis.given.unit)
    cells = [f"INDEX([{one.entries}.{name}],[row])" for name in ("velocity", "acceleration")]

    def by_rad(order: int) -> str:
        cell = cells[order - 1]
        value = one.over.rate(f"{cell}{lift.taken}", order)
        return f"=IF([k]<>2*[row],0,IF(ISNUMBER({cell}),{value},0))"

    rows = [max(1, k // 2) for k in range(1, one.room + 1)]
    return [
        calc("row", "row of its phase", "", "", "=MAX(1,INT([k]/2))", rows, format="0",
             source="of a rest that before it"),
        calc("set", "its begin is entered", "", "", f"=IF([k]<>2*[row],0,IF(COUNT({cells[0]},{cells[1]})>0,1,0))",
             one.of(lambda step: int(step.entered is not None)), format="0"),
        calc("ev", "velocity entered", "", at.unit(1), by_rad(1), one.of(lambda step: (step.entered or NONE).v),
             scale=one.motion.size(1)),
        calc("ea", "acceleration entered", "", at.unit(2), by_rad(2), one.of(lambda step: (step.entered or NONE).a),
             scale=one.motion.size(2)),
    ]  # fmt: skip


def ends(one: Handing) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and whether these are settled."""
    at, size, table = one.rows.at, one.motion.size, one.asked

    def later(column: str) -> str:
        return f"INDEX([{table}.{column}],MAX([after],1))"

    return [
        calc("settled0", "begin is settled", "", "", "=IF(OR([way]=-1,[before]=0,[line0]=1),1,[set])",
             one.of(lambda step: int(step.begin.settled), 1), format="0", source="by a line, a dwell, an entry"),
        calc("settled1", "end is settled", "", "", f"=IF(OR([way]=-1,[after]=0,[line1]=1),1,{later('set')})",
             one.of(lambda step: int(step.end.settled), 1), format="0", source="likewise"),
        calc("w0", "velocity at its begin", "v_0", at.unit(1), "=IF([way]=-1,[slope],IF([line0]=1,[slope0],[ev]))",
             one.of(lambda step: step.begin.required.v), scale=size(1)),
        calc("w1", "velocity at its end", "v_1", at.unit(1),
             f"=IF([way]=-1,[slope],([after]>0)*IF([line1]=1,{later('slope')},{later('ev')}))",
             one.of(lambda step: step.end.required.v), scale=size(1)),
        calc("q0", "acceleration at its begin", "a_0", at.unit(2), "=IF(OR([way]=-1,[line0]=1),0,[ea])",
             one.of(lambda step: step.begin.required.a), scale=size(2)),
        calc("q1", "acceleration at its end", "a_1", at.unit(2),
             f"=IF(OR([way]=-1,[line1]=1,[after]=0),0,{later('ea')})", one.of(lambda step: step.end.required.a),
             scale=size(2)),
        calc("moved", "sum of |v|", "", at.unit(1), "=ABS([w0])+ABS([w1])",
             one.of(lambda step: abs(step.begin.required.v) + abs(step.end.required.v)), scale=size(1)),
        calc("bent", "sum of |a|", "", at.unit(2), "=ABS([q0])+ABS([q1])",
             one.of(lambda step: abs(step.begin.required.a) + abs(step.end.required.a)), scale=size(2)),
    ]  # fmt: skip


def contrary(one: Handing) -> list[Quantity]:
    """Return the columns of whether a begin is entered otherwise than a straight line has it there."""
    slopes = {k: step.slope for k, step in enumerate(one.handed) if step.end_mode == STRAIGHT}
    last = len(one.handed) - 1
    before = [slopes.get(last if one.axis.given.repeats else -1), *map(slopes.get, range(last))]

    def differs(k: int, slope: float | None) -> int:
        return int(slope is not None and not agrees(one.handed[k].entered or NONE, slope))

    steps = range(len(one.handed))
    return [
        calc("off", "is entered otherwise than its own velocity", "", "", f"=IF([way]=-1,{DIFFERS.format('slope')},0)",
             one.spread([differs(k, slopes.get(k)) for k in steps]), format="0"),
        calc("off0", "or than that before it", "", "", f"=IF([line0]=1,{DIFFERS.format('slope0')},0)",
             one.spread([differs(k, before[k]) for k in steps]), format="0"),
        calc("contrary", "is entered otherwise", "", "", "=IF([set]*([off]+[off0])>0,1,0)",
             one.of(lambda step: int(step.contrary)), format="0;;", source="than a straight line there has it"),
    ]  # fmt: skip


def carried_out(one: Handing) -> list[Quantity]:
    """Return the columns of whether a law can have such ends, why not, and how it is carried out."""

    def straight_on(step: Handover) -> int:
        begin, end, d = step.begin.required, step.end.required, step.phase.duration
        return int(Ends(step.phase.lift, begin.v * d, end.v * d, begin.a * d**2, end.a * d**2).straight)

    small = f"{ROUNDING:.0E}"
    texts = one.spread([reason(step) for step in one.handed], ("", "", ""))
    law = f"INDEX([{one.entries}.law],[row])"
    first = "IF(AND([way]=0,[moved]>0),ABS([w0]),ABS([q0]))"
    says = {
        "verb": ("at which end", f'IF({first}>0,"begin","end")'),
        "what": ("what it cannot have", f'IF(AND([way]=0,[moved]>0),"{SPEED}","{BEND}")'),
        "why": ("why", f'IF([way]=0,"{RESTS}",IF([way]={FIXED},"{KEPT}","{ONLY}"))'),
    }
    return [
        calc("straight", "its ends are those of a straight line", "", "",
             f"=IF([bent]>0,0,IF(AND(ABS([w1]-[w0])<={small}*ABS([w0]),"
             f"ABS([h]-[w0]*[span])<={small}*ABS([h])),1,0))", one.of(straight_on, 1), format="0"),
        calc("cannot", "cannot have such ends", "", "",
             "=IF(OR(AND([way]=0,[moved]+[bent]>0),AND(OR([way]=1,[way]=2,[way]=3),[bent]>0)),1,0)",
             one.of(lambda step: int(bool(step.fault))), format="0;;", source="1 where it cannot"),
        calc("mode", "is carried out", "", "",
             f"=IF(OR([way]=-1,[way]=2,[cannot]=1,[moved]+[bent]=0),0,IF([straight]=1,{LINE},[way]))",
             one.of(lambda step: step.mode), format="0",
             source="0 between rests, 1 as two pulses, 2 straight on, 3, 5, 7 as a polynomial"),
        *(calc(name, label, "", "", f'=IF([cannot]=0,"",{formula})', [text[i] for text in texts], align="left")
          for i, (name, (label, formula)) in enumerate(says.items())),
        calc("fault", "what it says", "", "",
             f'=IF([cannot]=0,"","row "&[row]&": "&{law}&" cannot "&[verb]&[what]&[why])',
             one.spread(one.faults(), ""), align="left"),
    ]  # fmt: skip
