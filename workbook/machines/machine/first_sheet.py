"""The axes of a machine in short, and the rates at which all drives hold all limits, for its first sheet."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from engine.drive.motor import Reserve
from engine.timing import turn_time
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import colour
from workbook.book.checks import ZERO
from workbook.book.declare import Quantity, Sheet, check
from workbook.book.public_names import ENTERED
from workbook.book.sentence import CheckSentence, Sentence, amount, figure, quoted
from workbook.entries.abscissa import Abscissa
from workbook.fields.units import PER_MINUTE, PERCENT, shown, si
from workbook.machines.machine.drive.max_rate import RATE_LOOK, range_in_words
from workbook.machines.machine.drive.view import AT_NO_RATE, NONE_BINDS, DriveView, Rates
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.timing.sheet import units
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)

WHOLE = 100.0  # % of a limit
NO_DRIVE = "–"
ON_A_PAGE = 8  # axes at most, of which all is printed on one page in letters that can be read
NO_RATE = quoted(AT_NO_RATE)
RATE_CHECK = "about_held"
WITHIN = (
    "AND(IF(ISNUMBER(about_lowest),about_rate>=about_lowest*(1-check_zero),0),"
    "IF(ISNUMBER(about_highest),about_rate<=about_highest*(1+check_zero),1))"
)


def axes_summary(sheet: Sheet, machine: MachineView, drives: Mapping[int, DriveView]) -> None:
    """Declare a row for each axis of the table ``axes``: its travel and rates, and its motor where there are drives."""
    axes, symbols = machine.axes, machine.over.symbols
    reaches = [[shown(end, axis.unit) for end in axis.motion.reach] for axis in axes]
    number = [axis.number for axis in axes]
    speed, acceleration = (units(machine, order) for order in (1, 2))
    of_motors = motors(axes, drives) if drives else []
    sheet.one_page = len(axes) <= ON_A_PAGE
    cell = CELLS["axes_short"].sharing(number=number)
    block = cell.place(
        sheet,
        cell("axis", [axis.given.name for axis in axes])._replace(inks=tuple(map(colour, number))),
        cell("group", [axis.given.group or "" for axis in axes]),
        *of_motors[:2],
        cell("travel", [high - low for low, high in reaches], unit=units(machine)),
        cell("v", [axis.max_velocity for axis in axes], symbol=symbols[1], unit=speed),
        cell("a", [axis.max_acceleration for axis in axes], symbol=symbols[2], unit=acceleration),
        *of_motors[2:-2],
    )
    if drives:
        sheet.workings(block, "axes_low", "", sheet.print_columns + 2, *of_motors[-2:])


def gaps_summary(sheet: Sheet, gaps: Sequence[ClearanceView]) -> None:
    """Declare the least gap of each clearance, and where it is."""
    if not gaps:
        return
    over = gaps[0].over
    size, unit = max(gap.size for gap in gaps), ", ".join(dict.fromkeys(gap.unit for gap in gaps))
    cell = CELLS["gaps_short"].sharing(n=[gap.number for gap in gaps], unit=unit, over=over)
    cell.place(
        sheet,
        cell("name", [gap.given.name for gap in gaps]),
        cell("gap", [gap.least for gap in gaps], scale=size),
        cell("least", [gap.given.least for gap in gaps]),
        cell("at", [over.shown(gap.place) for gap in gaps], scale=over.length, format=over.format),
    )


def least_gap(gaps: Sequence[ClearanceView]) -> list[Quantity]:
    """Return the least of all gaps, if there are any of the same unit, and which it is."""
    if len({gap.unit for gap in gaps}) != 1:
        return []
    gap, row = min(gaps, key=lambda gap: gap.least), "MATCH(about_gap,[gaps_short.gap],0)"
    name = f"INDEX([gaps_short.name],{row})" if gaps[1:] else "[gaps_short.name.1]"
    cell = CELLS["least_gap"].sharing(unit=gap.unit, name=name)
    size = max(gap.size for gap in gaps)
    return [cell("about_gap", gap.least, scale=size), cell("about_gap_of", f"{gap.unit}, {gap.given.name}")]


def motors(axes: Sequence[MovingAxis], drives: Mapping[int, DriveView]) -> list[Quantity]:
    """Return the columns on motors: what each is and uses of each limit, the highest and then the lowest rate."""
    cell, numbers = CELLS["motors"], [axis.number for axis in axes]
    scopes = [f"drive{number}_" for number in numbers]
    reserves = {number: view.reserve for number, view in drives.items()}

    def column(name: str, value: Callable[[DriveView, Reserve], Any], **more: Any) -> Quantity:
        values = [value(drives[i], reserves[i]) if i in drives else NO_DRIVE for i in numbers]
        quantity = cell(name, values, drive=scopes, **more)
        formulas = zip(numbers, quantity.formula or (), strict=True)
        return quantity._replace(formula=[text if i in drives else f'="{NO_DRIVE}"' for i, text in formulas])

    def used(name: str, share: Callable[[DriveView, Reserve], float]) -> Quantity:
        return column(name, lambda view, reserve: shown(share(view, reserve), PERCENT), limit=WHOLE)

    return [
        column("motor", lambda view, _: view.driven.entered_motor.name or ENTERED, entered=ENTERED),
        column(
            "reducer",
            lambda view, _: (
                view.driven.entered.reducer.name or Sentence(f"i = {figure(round(view.driven.reducer.ratio, 3))}")
            ),
        ),
        used("of_rated", lambda _, reserve: reserve.rms_torque.use),
        used("of_peak", lambda _, reserve: reserve.peak_torque.use),
        used("of_speed", lambda _, reserve: reserve.speed.use),
        used("of_reducer", lambda view, _: max(check.use for check in view.reducer_checks[:2])),
        used("of_inertia", lambda view, _: view.inertia_ratio / view.driven.limits.inertia_ratio),
        column("sized", lambda view, _: view.rate),
        column("highest", lambda view, _: view.rates.high),
        column("binds", lambda view, _: view.rates.high_limit),
        column("lowest", lambda view, _: view.rates.low, format=RATE_LOOK),
        column("binds_low", lambda view, _: view.rates.low_limit),
    ]


class WholeRange(NamedTuple):
    """The rates of all drives, whose limits have the names of their axes; the axes that have them, 0 if none has."""

    rates: Rates
    low_axis: int
    high_axis: int


def whole_range(drives: Iterable[DriveView]) -> WholeRange:
    """Return the rates that all drives hold; of drives that hold none, or none together, the words for it."""
    each = list(drives)
    unmet = next((view for view in each if view.rates.high == AT_NO_RATE), None)
    lows = (view for view in each if isinstance(view.rates.low, float) and view.rates.low)
    low = max(lows, key=lambda view: view.rates.low, default=None)
    highs = (view for view in each if isinstance(view.rates.high, float))
    high = unmet or min(highs, key=lambda view: view.rates.high, default=None)
    low_limit = f"{low.driven.axis.given.name}: {low.rates.low_limit}" if low else NONE_BINDS
    high_limit = f"{high.driven.axis.given.name}: {high.rates.high_limit}" if high else NONE_BINDS
    ends = (low.rates.low if low else 0.0), (high.rates.high if high else NONE_BINDS)
    if unmet or (isinstance(ends[0], float) and isinstance(ends[1], float) and ends[0] >= ends[1]):
        ends = AT_NO_RATE, AT_NO_RATE
    axes = (view.driven.number if view else 0 for view in (low, high))
    return WholeRange(Rates(*ends, low_limit, high_limit), *axes)


def hold_at(rate: float, found: Rates) -> bool:
    """Return whether a range holds a rate (cycles/min), to a rounding."""
    if isinstance(found.low, str) or rate < found.low * (1.0 - ZERO):
        return False
    return isinstance(found.high, str) or rate <= found.high * (1.0 + ZERO)


def rate_check(found: Rates, rate: float) -> Quantity:
    """Return the check that the machine's rate (cycles/min) is within the range of all drives."""
    words, limits = range_in_words(found, "about_", "hold"), [found.low_limit, found.high_limit]
    binding = ", ".join(limits[limits[0] == NONE_BINDS :])
    both = 'IF(about_first_low>0,about_binds_low&", ","")&about_binds'
    return check(
        RATE_CHECK,
        "The drives hold the rate",
        WITHIN,
        hold_at(rate, found),
        says=amount("about_rate", rate, "runs at ", "; the drives ").then(
            CheckSentence(f'about_range&" ("&{both}&")"', f"{words.text} ({binding})")
        ),
    )


def rates_in_words(found: WholeRange) -> CheckSentence:
    """Return the sentence of the rates that all drives hold, and of the limit that is reached first."""
    words = range_in_words(found.rates, "about_", "hold").text
    says = '" The drives "&about_range&"; reached first: "&about_binds&"."'
    return CheckSentence(says, f" The drives {words}; reached first: {found.rates.high_limit}.")


def range_of_rates(found: WholeRange, axes: int, over: Abscissa) -> list[Quantity]:
    """Return the results of the whole machine: the rates at which all drives hold all limits, and who binds."""
    most, least = "[axes_short.highest]", "[axes_low.lowest]"

    def binds(limit: str, row: str) -> str:
        """Return the formula of an axis and of a limit of it, by its row, which is 0 if there is none."""
        names = "[axes_short.axis]", f"[{limit}]"
        axis, what = (f"{name[:-1]}.1]" if axes == 1 else f"INDEX({name},{row})" for name in names)
        return f'=IF({row}=0,"{NONE_BINDS}",{axis}&": "&{what})'

    def row_of(value: str, column: str) -> str:
        """Return the formula of the first row that has a value in a column."""
        return "1" if axes == 1 else f"MATCH({value},{column},0)"

    high = found.rates.high
    # IronCalc lacks it of one cell
    unmet = f"{most}={NO_RATE}" if axes == 1 else f"COUNTIF({most},{NO_RATE})>0"
    shortest = turn_time(si(high, PER_MINUTE)) if isinstance(high, float) else NO_DRIVE
    slowest = row_of(f"MIN({most})", most)
    first_low = binds("axes_low.binds_low", "about_first_low")
    apart = f'IF(COUNT({most})=0,"{NONE_BINDS}",IF(MAX({least})<MIN({most}),MIN({most}),{NO_RATE}))'
    words = range_in_words(found.rates, "about_", "hold")
    cell = CELLS["range_of_rates"].sharing(unmet=unmet, no_rate=NO_RATE, least=least)
    return [
        cell("about_range", Sentence(words.text), words=words),
        cell("about_highest", high, apart=apart),
        cell("about_reached", f"cycles/min, {found.rates.high_limit}"),
        *([cell("about_shortest", shortest, no_drive=NO_DRIVE)] if over.measured else []),
        cell("about_first", found.high_axis, failing=row_of(NO_RATE, most), most=most, slowest=slowest),
        cell("about_binds", found.rates.high_limit, formula=binds("axes_short.binds", "about_first")),
        cell("about_lowest", found.rates.low, format=RATE_LOOK),
        cell("about_first_low", found.low_axis, fastest=row_of(f"MAX({least})", least)),
        cell("about_binds_low", found.rates.low_limit, formula=first_low),
    ]
