"""The sheet Switches: when each is on, what that comes to, checks; the corners of their lanes in the timing diagram."""

from typing import Any

from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.sentence import first_text
from workbook.entries.abscissa import Abscissa
from workbook.entries.phase import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.switches.entries import HALF, TIMES
from workbook.machines.machine.switches.view import Lane, named
from workbook.machines.machine.timing.phases import going_beyond
from workbook.machines.machine.timing.sheet import LANE_SHARE
from workbook.machines.machine.view import Whole

NUMBERS = range(1, TIMES + 1)
NEXT = (
    "SUMPRODUCT(MIN({0}.begin]-[begin]-360*({0}.begin]>=[begin]+360)+360*({0}.begin]<[begin])"
    "+360*({0}.t]=[t])+360*({0}.used]=0)))"
)
"""from the begin of a time to the next begin of its switch: a turn where there is no other"""
UPS = (0, 1, 1, 0)


def switches_sheet(book: Book, machine: Whole) -> None:
    """Declare the sheet, where there are switches."""
    if not machine.lanes:
        return
    period = machine.over.period
    sheet = book.sheet("Switches", f"Cylinders, valves, sensors, cam switches: when each is on over a {period}.")
    sheet.heading("Enter")
    sheet.note(f"Of a time that runs past the end of the {period}, to is less than from.")
    entries(sheet, machine)
    faults = [("wrong", "apart", "apart", "each time lasts, and is over where another begins")]
    faults += [("late", "within", "ends", "no time goes on beyond the cycle")] if machine.over.measured else []
    for fault in faults:
        sheet.checks(*(none_with(lane.number, machine.over, *fault) for lane in machine.lanes))
    sheet.not_printed_below()
    sheet.heading("Workings: the times of each switch")
    for lane in machine.lanes:
        times_of(sheet, lane, machine.over)
    corners(sheet, machine)
    sheet.print_columns = 16


def entries(sheet: Sheet, machine: Whole) -> None:
    """Declare the table of switches: a row each."""
    lanes, over = machine.lanes, machine.over

    def entry(k: int, name: str) -> list[Any]:
        return [getattr(lane.typed[k], name) for lane in lanes]

    times: list[Quantity] = []
    for t in NUMBERS:
        for label, name in ((f"on from ({t})", "start"), (f"to ({t})", "stop")):
            times.append(given(f"{name}{t}", label, "", over.unit, entry(t - 1, name), f"switches.*.on.{t - 1}.{name}",
                               format=over.format))  # fmt: skip
    shown_as, source = (calc, "in all") if over.measured else (result, "at the production rate")
    per = over.unit if over.measured else "s"
    lasting = [
        shown_as("on", "on in all", "", "°", [f"=SUM([switch{one.number}_times.span])" for one in lanes],
                 [shown(one.switch.total, DEGREE) for one in lanes]),
        result("time", "on for", over.lasting, per, "=RADIANS([on])/omega",
               [one.switch.total / machine.speed for one in lanes], source=source),
    ]  # fmt: skip
    sheet.table(
        "switches", "Switches: a row each; leave spare times empty", len(lanes),
        given("name", "switch", "", "", [lane.given.name for lane in lanes], "switches.*.name"),
        constant("k", "number", "k", "", [lane.number for lane in lanes]),
        *times,
        *(reversed(lasting) if over.measured else lasting),
        rules=[HALF],
    )  # fmt: skip
    sheet.rows(*(calc(named(one.number), f"Switch {one.number}", "", "", f"=[switches.name.{one.number}]",
                      one.given.name, align="left") for one in lanes))  # fmt: skip


def times_of(sheet: Sheet, lane: Lane, over: Abscissa) -> None:
    """Declare the times of a switch: begin, end and duration, the next begin, and what is wrong with each."""
    i, times, after = lane.number, lane.times, over.after
    block, name = f"[switches.start1:stop{TIMES}]", f"switch{i}_times"
    start, stop = f"INDEX({block},{i},2*[t]-1)", f"INDEX({block},{i},2*[t])"
    more = f'"is on "&ROUND({over.told("[span]-[next]")},9)&"{after} beyond the begin of another"'
    wrong = f'IF([span]<=check_zero,"does not last",IF([span]-[next]>check_zero,{more},""))'
    beyond = going_beyond(over.told("MAX([begin],[end])"), over)
    late = calc("late", "beyond the cycle", "", "", f'=IF(MAX([begin],[end])-360>check_zero,{beyond},"")', "",
                align="left")  # fmt: skip
    sheet.table(
        name, f"Switch {i}: its times in degrees of the {over.period}", TIMES,
        constant("t", "time", "", "", list(NUMBERS)),
        calc("used", "is entered", "", "", f'=IF(OR({start}="",{stop}=""),0,1)', [int(time.told) for time in times],
             format="0"),
        calc("begin", "on from", "", "°", f"={over.in_degrees(start)}", [time.start or 0.0 for time in times],
             scale=TURN, format="0.0##"),
        calc("end", "to", "", "°", f"={over.in_degrees(stop)}", [time.stop or 0.0 for time in times], scale=TURN,
             format="0.0##"),
        calc("span", "lasts", "", "°", "=IF([used]=0,0,[end]-[begin]+IF([end]<[begin],360,0))", lane.spans, scale=TURN,
             format="0.0##"),
        calc("next", "to the next begin", "", "°", f"=IF([used]=0,0,{NEXT.format(f'[{name}')})", lane.until_next,
             scale=TURN, format="0.0##"),
        calc("wrong", "what is wrong", "", "", f'=IF([used]=0,"",{wrong})', "", align="left"),
        *([late] if over.measured else []),
    )  # fmt: skip


def none_with(i: int, over: Abscissa, column: str, name: str, rule: str, says: str) -> Quantity:
    """Return the check that no time of a switch has a text in a column; the first that has is told."""
    texts = f"[switch{i}_times.{column}]"
    at = first_text(texts)
    return check(f"switch{i}_{name}", f"Switch {i}: {says}", f'COUNTIF({texts},"?*")=0', True,
                 rule=over.rule("switches", i, rule),
                 says=f'[switches.name.{i}]&" time "&{at}&" "&INDEX({texts},{at})')  # fmt: skip


def corners(sheet: Sheet, machine: Whole) -> None:
    """Declare the corners of each lane: where it begins, two bars of four corners for each time, where it ends."""
    about = f"A bar for each time, and another for what of it lies behind the end of the {machine.over.period}."
    sheet.heading("Workings: lanes of the timing diagram", about)
    n, over = len(machine.lanes), machine.over
    ups = [0, *(up for _ in NUMBERS for _ in (1, 2) for up in UPS), 0]
    columns: list[Quantity] = []
    for lane in machine.lanes:
        i, floor = lane.number, n - lane.number
        places = lane.outline(floor, LANE_SHARE, machine.near)
        columns += [
            calc(f"x{i}", f"switch {i}: {'time' if over.measured else 'angle'}", "", over.unit, angles(i, over),
                 [over.shown(x) for x, _ in places], format=over.format),
            calc(f"y{i}", f"switch {i}: in the diagram", "", "", heights(i, floor), [y for _, y in places]),
        ]  # fmt: skip
    sheet.table(
        "switch_lanes", "Corners of the lanes", len(ups),
        constant("k", "corner", "k", "", list(range(1, len(ups) + 1))),
        constant("up", "on", "", "", ups, source="1 where a bar is"),
        *columns,
    )  # fmt: skip


def angles(i: int, over: Abscissa) -> list[str]:
    """Return the formulas of the corners' places of a switch."""
    first, last = (f"[cycle1.{over.column}.{end}]" for end in ("first", "last"))
    found = [f"={first}"]
    for t in NUMBERS:
        start, span = (f"[switch{i}_times.{name}.{t}]" for name in ("begin", "span"))
        begin, end = f"[switches.start{t}.{i}]", over.told(f"MIN({start}+{span},360)")
        again, rest = f"={first}", over.told(f"MAX({start}+{span}-360,0)")
        begin, end, rest = (f"=IF({span}>0,{place},0)" for place in (begin, end, rest))
        found += [begin, begin, end, end, again, again, rest, rest]
    return [*found, f"={last}"]


def heights(i: int, floor: int) -> list[str]:
    """Return the formulas of the corners' heights: on the floor of the lane, or on top of a bar that has a width."""
    line = "={}+[up]*IF({}>eps,timing_lane,0)"
    widths = ["[cycle1.theta.last]"]
    for t in NUMBERS:
        start, span = (f"[switch{i}_times.{name}.{t}]" for name in ("begin", "span"))
        widths += [width for width in (f"MIN({span},360-{start})", f"({start}+{span}-360)") for _ in UPS]
    return [line.format(floor, width) for width in (*widths, "[cycle1.theta.last]")]
