"""The rates at which all drives of a machine hold all limits, for its first sheet."""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from engine.timing import turn_time
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import ZERO
from workbook.book.declare import Quantity, check
from workbook.book.sentence import CheckSentence, Sentence, amount, quoted
from workbook.entries.abscissa import Abscissa
from workbook.fields.units import PER_MINUTE, si
from workbook.machines.machine.axes_summary import NO_DRIVE
from workbook.machines.machine.drive.max_rate import RATE_LOOK, range_in_words
from workbook.machines.machine.drive.view import AT_NO_RATE, NONE_BINDS, DriveView, Rates

CELLS = cell_tables(__file__)

NO_RATE = quoted(AT_NO_RATE)
RATE_CHECK = "about_held"
WITHIN = (
    "AND(IF(ISNUMBER(about_lowest),about_rate>=about_lowest*(1-check_zero),0),"
    "IF(ISNUMBER(about_highest),about_rate<=about_highest*(1+check_zero),1))"
)


class AxisRates(NamedTuple):
    """The rates of the drive of an axis."""

    number: int  # of the axis, from 1
    name: str
    rates: Rates


class WholeRange(NamedTuple):
    """The rates of all drives, whose limits have the names of their axes; the axes that have them, 0 if none has."""

    rates: Rates
    low_axis: int
    high_axis: int


def whole_range(drives: Iterable[DriveView]) -> WholeRange:
    """Return the rates that all drives hold; of drives that hold none, or none together, the words for it."""
    each = [AxisRates(view.driven.axis.number, view.driven.axis.given.name, view.rates) for view in drives]
    unmet = next((axis for axis in each if axis.rates.high == AT_NO_RATE), None)
    low = first(each, lambda axis: axis.rates.low, max)
    high = unmet or first(each, lambda axis: axis.rates.high, min)
    low = low if low and low.rates.low else None
    low_limit = f"{low.name}: {low.rates.low_limit}" if low else NONE_BINDS
    high_limit = f"{high.name}: {high.rates.high_limit}" if high else NONE_BINDS
    ends = (low.rates.low if low else 0.0), (high.rates.high if high else NONE_BINDS)
    if unmet or (isinstance(ends[0], float) and isinstance(ends[1], float) and ends[0] >= ends[1]):
        ends = AT_NO_RATE, AT_NO_RATE
    return WholeRange(Rates(*ends, low_limit, high_limit), low.number if low else 0, high.number if high else 0)


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


def first(
    each: Sequence[AxisRates], end: Callable[[AxisRates], float | str], best: Callable[..., float]
) -> AxisRates | None:
    """Return the first axis that has the best of the ends that are numbers, if any is."""
    numbers = [value for one in each if isinstance(value := end(one), float)]
    return next((one for one in each if end(one) == best(numbers)), None) if numbers else None


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
    first_low = binds("axes_low.binds_low", "about_first_low")
    apart = f'IF(COUNT({most})=0,"{NONE_BINDS}",IF(MAX({least})<MIN({most}),MIN({most}),{NO_RATE}))'
    words = range_in_words(found.rates, "about_", "hold")
    cell = CELLS["range_of_rates"].sharing(unmet=unmet, no_rate=NO_RATE, least=least)
    return [
        cell("about_range", Sentence(words.text), words=words),
        cell("about_highest", high, apart=apart),
        cell("about_reached", f"cycles/min, {found.rates.high_limit}"),
        *([cell("about_shortest", shortest, no_drive=NO_DRIVE)] if over.measured else []),
        cell(
            "about_first",
            found.high_axis,
            failing=row_of(NO_RATE, most),
            most=most,
            slowest=row_of(f"MIN({most})", most),
        ),
        cell("about_binds", found.rates.high_limit, formula=binds("axes_short.binds", "about_first")),
        cell("about_lowest", found.rates.low, format=RATE_LOOK),
        cell("about_first_low", found.low_axis, fastest=row_of(f"MAX({least})", least)),
        cell("about_binds_low", found.rates.low_limit, formula=first_low),
    ]
