"""The sheet Switches: when each is on, what that comes to, checks; the corners of their lanes in the timing diagram."""

from __future__ import annotations

from typing import Any

from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.entries.abscissa import Abscissa
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.lanes import named
from workbook.machines.machine.phases import goes_beyond
from workbook.machines.machine.switching import HALF, TIMES
from workbook.machines.machine.timing import LANE_SHARE
from workbook.machines.machine.view import Whole

NUMBERS = range(1, TIMES + 1)
SPAN = '=IF(OR([start{0}]="",[stop{0}]=""),0,{1}-{2}+IF([stop{0}]<[start{0}],360,0))'
BEYOND = "IF([span{1}]>0,[span{0}]-({2}-{3}-360*INT(({2}-{3})/360)),0)"
STILL = 'IF(AND([start{0}]<>"",[stop{0}]<>"",[span{0}]<=check_zero),{0},{1})'
LATE = "IF([over{0}]>check_zero,{0},{1})"
AFTER = "IF({2}-360>check_zero,{0},{1})"
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
    sheet.checks(*(apart(lane.number, machine.over) for lane in machine.lanes))
    if machine.over.measured:
        sheet.checks(*(within(lane.number, machine.over) for lane in machine.lanes))
    sheet.not_printed_below()
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
        shown_as("on", "on in all", "", "°", f"={summed('span')}", [shown(one.switch.total, DEGREE) for one in lanes]),
        result("time", "on for", over.lasting, per, "=RADIANS([on])/timing_omega",
               [one.switch.seconds(machine.speed) for one in lanes], source=source),
    ]  # fmt: skip
    sheet.table(
        "switches", "Switches: a row each; leave spare times empty", len(lanes),
        given("name", "switch", "", "", [lane.given.name for lane in lanes], "switches.*.name"),
        constant("k", "number", "k", "", [lane.number for lane in lanes]),
        *times,
        *(reversed(lasting) if over.measured else lasting),
        *(calc(f"span{t}", f"time {t} lasts", "", "°", span(t, over), [one.spans[t - 1] for one in lanes],
               scale=TURN, format="0.0##") for t in NUMBERS),
        *(calc(f"over{t}", f"time {t} beyond another", "", "°", beyond_another(t, over), 0.0, scale=TURN,
               format="0.0##", source="on where another begins") for t in NUMBERS),
        calc("still", "does not last", "", "", f"={first(STILL)}", 0, format="0;;", source="number of the time"),
        calc("late", "goes on too long", "", "", f"={first(LATE)}", 0, format="0;;", source="number of the time"),
        *([calc("after", "goes beyond the cycle", "", "", f"={after(over)}", 0, format="0;;",
                source="number of the time")] if over.measured else []),
        rules=[HALF],
    )  # fmt: skip
    sheet.rows(*(calc(named(one.number), f"Switch {one.number}", "", "", f"=[switches.name.{one.number}]",
                      one.given.name, align="left") for one in lanes))  # fmt: skip


def summed(column: str) -> str:
    """Return the formula of the sum of a column of each time."""
    return "+".join(f"[{column}{t}]" for t in NUMBERS)


def span(t: int, over: Abscissa) -> str:
    """Return the formula of how long a time lasts."""
    return SPAN.format(t, *(over.in_degrees(f"[{end}{t}]") for end in ("stop", "start")))


def beyond_another(t: int, over: Abscissa) -> str:
    """Return the formula of how long a time goes on after another has begun."""
    begin = over.in_degrees(f"[start{t}]")
    others = ",".join(BEYOND.format(t, other, over.in_degrees(f"[start{other}]"), begin)
                      for other in NUMBERS if other != t)  # fmt: skip
    return f"=IF([span{t}]=0,0,MAX(0,{others}))"


def first(condition: str) -> str:
    """Return the formula of the number of the first time of which a condition holds; 0 of none."""
    found = "0"
    for t in reversed(NUMBERS):
        found = condition.format(t, found)
    return found


def within(i: int, over: Abscissa) -> Quantity:
    """Return the check that no time of a switch goes on beyond the cycle."""
    time = f"[switches.after.{i}]"
    last = f"CHOOSE(MAX(1,{time}),{','.join(f'MAX([switches.start{t}.{i}],[switches.stop{t}.{i}])' for t in NUMBERS)})"
    return check(f"switch{i}_within", f"Switch {i}: no time goes on beyond the cycle", f"[switches.after.{i}]=0", True,
                 rule=over.rule("switches", i, "ends"),
                 says=goes_beyond(f'[switches.name.{i}]&" time "', time, last, over))  # fmt: skip


def after(over: Abscissa) -> str:
    """Return the formula of the number of the first time that goes on beyond the cycle; 0 of none."""
    found = "0"
    for t in reversed(NUMBERS):
        found = AFTER.format(t, found, over.in_degrees(f"MAX([start{t}],[stop{t}])"))
    return found


def apart(i: int, over: Abscissa) -> Quantity:
    """Return the check that each time of a switch lasts, and is over where another begins."""
    still, late = f"[switches.still.{i}]", f"[switches.late.{i}]"
    most = over.told(f"CHOOSE(MAX(1,{late}),{','.join(f'[switches.over{t}.{i}]' for t in NUMBERS)})")
    says = (
        f'[switches.name.{i}]&" time "&IF({still}>0,{still}&" does not last",'
        f'{late}&" is on "&ROUND({most},9)&"{over.after} beyond the begin of another")'
    )
    return check(f"switch{i}_apart", f"Switch {i}: each time lasts, and is over where another begins",
                 f"{still}+{late}=0", True, rule=over.rule("switches", i, "apart"), says=says)  # fmt: skip


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
            calc(
                f"x{i}",
                f"switch {i}: {'time' if over.measured else 'angle'}",
                "",
                over.unit,
                angles(i, over),
                [over.shown(x) for x, _ in places],
                format=over.format,
            ),
            calc(f"y{i}", f"switch {i}: in the diagram", "", "", heights(i, floor, over), [y for _, y in places]),
        ]
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
        start, span = over.in_degrees(f"[switches.start{t}.{i}]"), f"[switches.span{t}.{i}]"
        begin, end = f"[switches.start{t}.{i}]", over.told(f"MIN({start}+{span},360)")
        again, rest = f"={first}", over.told(f"MAX({start}+{span}-360,0)")
        begin, end, rest = (f"=IF({span}>0,{place},0)" for place in (begin, end, rest))
        found += [begin, begin, end, end, again, again, rest, rest]
    return [*found, f"={last}"]


def heights(i: int, floor: int, over: Abscissa) -> list[str]:
    """Return the formulas of the corners' heights: on the floor of the lane, or on top of a bar that has a width."""
    line = "={}+[up]*IF({}>timing_eps,timing_lane,0)"
    found = [line.format(floor, "[cycle1.theta.last]")]
    for t in NUMBERS:
        start, span = over.in_degrees(f"[switches.start{t}.{i}]"), f"[switches.span{t}.{i}]"
        widths = f"MIN({span},360-{start})", f"({start}+{span}-360)"
        found += [line.format(floor, width) for width in widths for _ in UPS]
    return [*found, line.format(floor, "[cycle1.theta.last]")]
