"""Differences between a file and a fresh build of the same inputs, the alike in a line, and which mislead."""

import re
from collections.abc import Container, Mapping
from functools import cache
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.judging.display.flat import Flat, differing
from workbook.judging.report import NOTICE, SHOWN, Report

# the attributes of which a difference is a finding; of all others it is a notice
OF_ALL = re.compile(
    r"number format|legible|font strike val|font charset val|border diagonal.*"  # of cells
    r"|kind|another line of a declared name|line .* (x|y|strokes|drawn)|labels .* formatCode"  # of charts
    r"|axis [xy] (scaling .*|numFmt formatCode|dispUnits.*)|hidden rows|size"
    r"|.* show(Formulas|Zeros|Objects)|.* date1904"  # of views
)
OF_VERDICTS = re.compile(r"font color|fill .*|decimals|sight|conditional format")
OF_RULES = re.compile(
    r".*(another number|strike|in place of figures|one colour).*"
)  # of conditional formats of figures
TURNS = re.compile(r"^(U|Umdr|rev|tr|giri|Takte|c|cycles)\.?/min$")  # as our users say it
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")  # what a translation leaves as it is


class Subject(NamedTuple):
    """The owner of an attribute, in words; of a verdict more differences mislead, of a remark none."""

    words: str
    is_verdict: bool = False
    is_remark: bool = False
    group: str = ""  # apart from which its differences are reported, such as those of a chart


class Differences:
    """Differences of what is shown, by sheet, attribute, and what is expected and held."""

    def __init__(self) -> None:
        self._groups: dict[tuple[str, str, str, str, str, str], tuple[Address, str, int]] = {}

    def compare(self, at: Address, subject: Subject, fresh: Flat, held: Flat) -> None:
        """Enter the attributes that differ."""
        self.tell(at, subject, differing(fresh, held))

    def tell(self, at: Address, subject: Subject, pairs: Mapping[str, tuple[Any, Any]]) -> None:
        """Enter attributes with what is expected and held; the table says which mislead."""
        for name, (expected, held) in pairs.items():
            self.add(at, subject, name, expected, held, misleads(subject, name, str(held)))

    def add(self, at: Address, subject: Subject, attribute: str, expected: Any, held: Any, misleads: bool) -> None:
        """Enter a difference; what misleads a reader is a finding."""
        kind = SHOWN if misleads else NOTICE
        key = at.sheet, kind, attribute, str(expected), str(held), subject.group
        first, words, count = self._groups.get(key, (at, subject.words, 0))
        self._groups[key] = first, words, count + 1

    def enter(self, report: Report) -> None:
        """Enter all into a report, a line for each group: ``number format: 0.00 → 0%, 12 cells``."""
        for (_, kind, attribute, expected, held, _), (at, words, count) in self._groups.items():
            more = f", {count:,} cells" if count > 1 else ""
            report.say(at, kind, held or "none", expected or "none", f"{attribute} of {words}{more}")


def misleads(subject: Subject, attribute: str, held: str) -> bool:
    """Whether a difference of an attribute may have a figure, a curve or a verdict read otherwise."""
    if subject.is_remark:
        return False
    if attribute == "conditional format" and OF_RULES.fullmatch(held):
        return True
    return bool(OF_ALL.fullmatch(attribute) or (subject.is_verdict and OF_VERDICTS.fullmatch(attribute)))


def text_misleads(expected: str, held: str, others: Container[str]) -> bool:
    """Whether a text says what belongs elsewhere: another's words, other figures, or another unit in brackets."""
    more = set(TELLING.findall(held)) - set(TELLING.findall(expected))
    units = [text.partition("[")[2].rstrip("] ") for text in (expected, held)]
    return bool(more) or held in others or (all(units) and not is_same_unit(*units))


def is_same_unit(unit: str, other: str) -> bool:
    """Whether two units are the same, however they are spelled."""
    return unit.split() == other.split() or (unit_size(unit) is not None and unit_size(unit) == unit_size(other))


def is_unit(text: str) -> bool:
    """Whether a text reads as a unit, or as a figure with its unit."""
    return bool(TELLING.search(text)) or unit_size(text) is not None


@cache
def unit_size(text: str) -> tuple[Any, float] | None:
    """Return dimension and size of a unit in SI; None for words that are no unit."""
    from workbook.dimensions.units import size_of  # here, since pint takes a third of a second to load

    return size_of(TURNS.sub("1/min", text))
