"""Switches over the cycle: the sheet, with checks, and the corners of their lanes in the timing diagram."""

from collections.abc import Iterable
from functools import cached_property
from itertools import chain
from typing import Any

from engine.timing import Switch
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import filled, spread
from workbook.entries.abscissa import Abscissa
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import HALF, TIMES, SwitchEntry, TimeOn
from workbook.machines.machine.places import in_degrees
from workbook.machines.machine.timing.cycle import LANE_SHARE
from workbook.machines.machine.timing.phases import going_beyond, no_fault
from workbook.machines.machine.view import MachineView

CELLS = cell_tables(__file__)

NUMBERS = range(1, TIMES + 1)
NEXT = (
    "SUMPRODUCT(MIN({0}.begin]-[begin]-360*({0}.begin]>=[begin]+360)+360*({0}.begin]<[begin])"
    "+360*({0}.t]=[t])+360*({0}.used]=0)))"
)
"""from the begin of a time to the next begin of its switch: a turn where there is no other"""
UPS = (0, 1, 1, 0)
NONE = ((0.0, 0.0), (0.0, 0.0))  # the bars of a time that is not entered


class Lane:
    """A switch as the timing diagram shows it, bars on a lane: its times as ``typed``, and in degrees of a turn."""

    def __init__(self, given: SwitchEntry, number: int, over: Abscissa) -> None:
        self.given, self.number = given, number
        self.typed: list[TimeOn] = filled(given.on, TIMES, TimeOn())
        self.times = [in_degrees(time, over) for time in self.typed]
        self.entered = {k: time.ends for k, time in enumerate(self.times) if time.ends}

    @cached_property
    def switch(self) -> Switch:
        """The switch over a turn of the master shaft (rad)."""
        on = tuple((si(start, DEGREE), si(stop, DEGREE)) for start, stop in self.entered.values())
        return Switch(self.given.name, on)

    def each(self, values: Iterable[Any], spare: Any = 0.0) -> list[Any]:
        """Return a value for each time: those of the ones that are entered, in their order."""
        return spread(values, self.entered, TIMES, spare)

    @property
    def until_next(self) -> list[float]:
        """From the begin of each time to the next begin of the switch (degrees); a turn where there is no other."""
        begins = {k: start for k, (start, _) in self.entered.items()}
        return self.each(
            min(((b - a) % TURN for j, b in begins.items() if j != k), default=TURN) for k, a in begins.items()
        )

    def outline(self, floor: int, near: float) -> list[tuple[float, float]]:
        """Return the corners of its lane: angle (degrees) and height; a bar no wider than ``near`` is none."""
        corners = [(0.0, float(floor))]
        for bar in chain.from_iterable(self.each(self.switch.bars, NONE)):
            low, high = (shown(end, DEGREE) for end in bar)
            top = floor + (LANE_SHARE if high - low > near else 0.0)
            corners += [(low, floor), (low, top), (high, top), (high, floor)]
        return [*corners, (TURN, floor)]


def switches_sheet(book: Book, machine: MachineView) -> None:
    """Declare the sheet, where there are switches."""
    over = machine.over
    lanes = [Lane(switch, i, over) for i, switch in enumerate(machine.given.switches, 1)]
    if not lanes:
        return
    sheet = book.sheet("Switches", f"Cylinders, valves, sensors, cam switches: when each is on over a {over.period}.")
    sheet.heading("Enter", f"Of a time that runs past the end of the {over.period}, to is less than from.")
    entries(sheet, lanes, machine)
    faults = [("wrong", "apart", "each time lasts, and is over where another begins")]
    faults += [("late", "within", "no time goes on beyond the cycle")] if over.measured else []
    for column, name, condition in faults:
        for i in range(1, len(lanes) + 1):
            texts, called = f"[switch{i}_times.{column}]", f'[switches.name.{i}]&" time "'
            name_and_label = f"switch{i}_{name}", f"Switch {i}: {condition}"
            sheet.checks(no_fault(*name_and_label, texts, called))
    sheet.not_printed_below()
    sheet.heading("Workings: the times of each switch")
    for lane in lanes:
        times_of(sheet, lane, over)
    corners(sheet, lanes, over, machine.near)
    sheet.print_columns = 17


def entries(sheet: Sheet, lanes: list[Lane], machine: MachineView) -> None:
    """Declare the table of switches: a row each."""
    over = machine.over
    cell = CELLS["entries"].sharing(unit=over.unit)
    own = {"format": over.format, "upper_limit": over.upper_limit}

    def column(name: str, label: str, t: int) -> Quantity:
        values = [getattr(lane.typed[t - 1], name) for lane in lanes]
        return cell("{name}{t}", values, name=name, t=t, t_before=t - 1, label=label, **own)

    times = [column(*end, t) for t in NUMBERS for end in (("start", "on from"), ("stop", "to"))]
    on = cell(
        "on", [shown(lane.switch.total, DEGREE) for lane in lanes], number=[*range(1, len(lanes) + 1)], limit=TURN
    )
    lasts, factor, look = [lane.switch.total / machine.speed for lane in lanes], "", {}
    if not over.measured:
        lasts, factor, look = [1000.0 * time for time in lasts], "1000*", {"unit": "ms", "source": "at the rate"}
    time = cell("time", lasts, symbol=over.lasting, factor=factor, **look)
    lasting = [time._replace(source="in all"), on._replace(role="calculation")] if over.measured else [on, time]
    CELLS["switches"].place(
        sheet,
        CELLS["switches"]("name", [lane.given.name for lane in lanes]),
        CELLS["switches"]("k", [lane.number for lane in lanes]),
        *times,
        *lasting,
        rules=[HALF],
    )
    cell = CELLS["switches"]
    sheet.rows(*(cell("switch{i}_name", lane.given.name, i=lane.number) for lane in lanes))


def times_of(sheet: Sheet, lane: Lane, over: Abscissa) -> None:
    """Declare the times of a switch: begin, end and duration, the next begin, and the fault of each."""
    cell = CELLS["times_of"]
    i, times, after = lane.number, lane.times, over.after
    block, name = f"[switches.start1:stop{TIMES}]", f"switch{i}_times"
    start, stop = f"INDEX({block},{i},2*[t]-1)", f"INDEX({block},{i},2*[t])"
    more = f'"is on "&ROUND({over.shown_formula("[span]-[next]")},9)&"{after} beyond the begin of another"'
    wrong = f'IF([span]<=check_zero,"does not last",IF([span]-[next]>check_zero,{more},""))'
    beyond = going_beyond(over.shown_formula("MAX([begin],[end])"), over)
    late = cell("late", "", beyond=beyond)

    cell.sharing(i=i, period=over.period).place(
        sheet,
        cell("t", list(NUMBERS)),
        cell("used", lane.each([1] * len(lane.entered), 0), start=start, stop=stop),
        cell("begin", [time.start or 0.0 for time in times], since=over.degrees_formula(start)),
        cell("end", [time.stop or 0.0 for time in times], to=over.degrees_formula(stop)),
        cell("span", lane.each(shown(span, DEGREE) for span in lane.switch.spans)),
        cell("next", lane.until_next, next=NEXT.format(f"[{name}")),
        cell("wrong", "", wrong=wrong),
        *([late] if over.measured else []),
    )


def corners(sheet: Sheet, lanes: list[Lane], over: Abscissa, near: float) -> None:
    """Declare the corners of each lane: where it begins, two bars of four corners for each time, where it ends."""
    about = f"A bar for each time, and another for what of it lies behind the end of the {over.period}."
    sheet.heading("Workings: lanes of the timing diagram", about)
    ups = [0, *UPS * 2 * TIMES, 0]
    columns: list[Quantity] = []
    first, last = (f"=[cycle1.{over.column}.{end}]" for end in ("first", "last"))
    for i, lane in enumerate(lanes, 1):
        floor, angles, widths = len(lanes) - i, [first], ["[cycle1.theta.last]"]
        for t in NUMBERS:
            start, span = (f"[switch{i}_times.{name}.{t}]" for name in ("begin", "span"))
            begin, end = f"[switches.start{t}.{i}]", over.shown_formula(f"MIN({start}+{span},360)")
            rest = over.shown_formula(f"MAX({start}+{span}-360,0)")
            begin, end, rest = (f"=IF({span}>0,{place},0)" for place in (begin, end, rest))
            angles += [begin, begin, end, end, first, first, rest, rest]
            widths += [width for width in (f"MIN({span},360-{start})", f"({start}+{span}-360)") for _ in UPS]
        heights = [f"={floor}+[up]*IF({width}>eps,timing_lane,0)" for width in (*widths, widths[0])]
        places = lane.outline(floor, near)
        columns += [
            CELLS["corners"](
                "x{i}",
                [over.shown(x) for x, _ in places],
                i=i,
                place="time" if over.measured else "angle",
                unit=over.unit,
                formula=[*angles, last],
                format=over.format,
            ),
            CELLS["corners"]("y{i}", [y for _, y in places], i=i, formula=heights),
        ]
    CELLS["switch_lanes"].place(sheet, CELLS["switch_lanes"]("up", ups), *columns)
