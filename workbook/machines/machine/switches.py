"""Switches over the cycle: the sheet, with checks, and their bars in the timing diagram."""

from collections.abc import Iterable
from functools import cached_property
from itertools import chain
from typing import Any

from engine.timing import Switch
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart
from workbook.book.declare import FIRST, Book, Quantity, Sheet
from workbook.book.rows import filled, spread
from workbook.entries.abscissa import Abscissa
from workbook.entries.facts import table_of
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import HALF, TIMES, SwitchEntry, TimeOn
from workbook.machines.machine.places import in_degrees
from workbook.machines.machine.timing.phases import going_beyond, no_fault
from workbook.machines.machine.timing.sheet import draw_switch
from workbook.machines.machine.view import MachineView

CELLS = cell_tables(__file__)

PRINTED = 19  # columns
NUMBERS = range(1, TIMES + 1)
NEXT = (
    "SUMPRODUCT(MIN({0}.begin]-[begin]-360*({0}.begin]>=[begin]+360)+360*({0}.begin]<[begin])"
    "+360*({0}.t]=[t])+360*({0}.used]=0)))"
)
"""from the begin of a time to the next begin of its switch: a turn where there is no other"""
MIDDLE = 0.4  # height of bars in a lane


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
    def spans(self) -> list[float]:
        """Duration of each time (degrees)."""
        return self.each(shown(span, DEGREE) for span in self.switch.spans)

    @property
    def until_next(self) -> list[float]:
        """From the begin of each time to the next begin of the switch (degrees); a turn where there is no other."""
        begins = {k: start for k, (start, _) in self.entered.items()}
        return self.each(
            min(((b - a) % TURN for j, b in begins.items() if j != k), default=TURN) for k, a in begins.items()
        )

    @property
    def ends(self) -> list[float]:
        """The ends of its bars (degrees): of what is past the end of the turn, then of each time, a gap before it."""
        begins = [time.start or 0.0 for time in self.times]
        ends = [begin + span for begin, span in zip(begins, self.spans, strict=True)]
        bars = [(begin, begin, min(end, TURN)) for begin, end in zip(begins, ends, strict=True)]
        return [0.0, max(0.0, max(ends) - TURN), *chain.from_iterable(bars)]


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
    sheet.heading(f"Over the {over.period}")
    sheet.chart(draw_switches(lanes, over), FIRST, sheet.row, PRINTED - FIRST + 1, 6 + 2 * len(lanes))
    sheet.row += 6 + 2 * len(lanes)
    sheet.not_printed_below()
    sheet.heading("Workings: the times of each switch")
    for lane in lanes:
        times_of(sheet, lane, over)
    corners(sheet, lanes, over)
    sheet.print_columns = PRINTED


def entries(sheet: Sheet, lanes: list[Lane], machine: MachineView) -> None:
    """Declare the table of switches: a row each."""
    over = machine.over
    cell = CELLS["entries"].sharing(unit=over.unit)
    own = {"format": over.format, "upper_limit": over.upper_limit}

    def column(name: str, label: str, t: int) -> Quantity:
        values = [getattr(lane.typed[t - 1], name) for lane in lanes]
        return cell("{name}{t}", values, name=name, t=t, t_before=t - 1, label=label, **own)

    times = [column(*end, t) for t in NUMBERS for end in (("start", "on from"), ("stop", "to"))]
    degrees = [shown(lane.switch.total, DEGREE) for lane in lanes]
    on = cell("on", degrees, number=[lane.number for lane in lanes], limit=TURN)
    seconds = [lane.switch.total / machine.speed for lane in lanes]
    lasting = [on, cell("ms", [1000.0 * time for time in seconds], source="at the rate")._replace(name="time")]
    if over.measured:
        time = cell("time", seconds, symbol=over.lasting, source="in all")
        lasting = [time, on._replace(role="calculation")]
    delays = [switch.dead_time / 1000.0 for switch in machine.given.switches]
    shift = over.shown_formula("DEGREES([dead]/1000*omega)")
    CELLS["switches"].place(
        sheet,
        CELLS["switches"]("name", [lane.given.name for lane in lanes]),
        CELLS["switches"]("k", [lane.number for lane in lanes]),
        *times,
        *lasting,
        table_of(SwitchEntry).columns(machine.given.switches, "switches", len(lanes))("dead"),
        cell("early", [over.shown(shown(t * machine.speed, DEGREE)) for t in delays], shift=shift),
        rules=[HALF],
    )


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
        cell("span", lane.spans),
        cell("next", lane.until_next, next=NEXT.format(f"[{name}")),
        cell("wrong", "", wrong=wrong),
        *([late] if over.measured else []),
    )


def corners(sheet: Sheet, lanes: list[Lane], over: Abscissa) -> None:
    """Declare the ends of the bars of each lane: what lies behind the end of the cycle, then of each time the rest."""
    sheet.heading("Workings: bars of the timing diagram", "An empty height parts two bars.")
    cell, columns = CELLS["corners"].sharing(unit=over.unit), list[Quantity]()
    for lane in lanes:
        i, of = lane.number, f"[switch{lane.number}_times."
        past = over.shown_formula(f"MAX(0,SUMPRODUCT(MAX({of}begin]+{of}span]))-360)")
        ends = [f"=[cycle1.{over.column}.first]", f"={past}"]
        for t in NUMBERS:
            begin, span = f"{of}begin.{t}]", f"{of}span.{t}]"
            begins = f"={over.shown_formula(begin)}"
            ends += [begins, begins, f"={over.shown_formula(f'MIN({begin}+{span},360)')}"]
        height, places = len(lanes) - i + MIDDLE, [over.shown(x) for x in lane.ends]
        columns += [
            cell("x{i}", places, i=i, formula=ends, format=over.format, scale=over.length),
            cell("y{i}", [height, height, *(None, height, height) * TIMES], i=i),
        ]
    CELLS["switch_lanes"].place(sheet, *columns)


def draw_switches(lanes: list[Lane], over: Abscissa) -> Chart:
    """Return the chart of all switches over the cycle."""
    bars = [draw_switch(lane.number) for lane in lanes]
    about, heights = f"When each switch is on over {over.cycle}", (0, len(lanes), 1)
    return Chart("", over.title, "", tuple(bars), about, over.axis(30), heights, lanes=True)
