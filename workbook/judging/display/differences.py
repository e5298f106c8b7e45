"""Differences between a file and a fresh build of the same inputs, the alike in a line, and which mislead."""

import re
from collections.abc import Container
from functools import cache
from typing import Any, Literal, NamedTuple

from workbook.book.address import Address
from workbook.judging.display.flat import Flat, Shown, is_same, usual_value
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, SHOWN, Report

# the attributes of which a difference is a finding, with what is held; of all others it is a notice
FINDINGS = (
    re.compile(
        r"(number format|legible|font strike val|font charset val|border diagonal.*"  # of cells
        r"|kind|another line of a declared name|line .* (x|y|strokes|drawn)|labels .* formatCode"  # of charts
        r"|axis [xy] (scaling .*|numFmt formatCode|dispUnits.*)|rows that it draws"
        r"|sheet name of another|.* show(Formulas|Zeros|Objects)|.* date1904): .*"
        r"|conditional format: .*(another number|strike|showValue off).*"
    ),
    re.compile(r"(font color|fill .*|decimals|conditional format): .*"),  # of verdicts
    re.compile(r"sight: .*"),  # of verdicts that fail, or of the book
)
VERDICTS = {"verdict": 1, "failing": 2}  # more tables for a kind
TEXT = re.compile("(.* )?(text|title)")  # attributes that are read, and judged by what they say
COPY = "figures of its own"  # what LibreOffice has of a chart that it took off its cells
TURNS = re.compile(r"^(U|Umdr|rev|tr|giri|Takte|c|cycles)\.?/min$")  # as our users say it
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")  # what a translation leaves as it is


class Subject(NamedTuple):
    """The owner of attributes, in words, and what it is; what else is written beside it misleads in its place."""

    words: str
    kind: Literal["", "verdict", "failing", "remark", "unit", "entry"] = ""
    others: Container[str] = frozenset()
    group: str = ""  # apart from which its differences are reported, such as those of a chart


class Differences:
    """Differences of what is shown, by sheet, attribute, and what is expected and held."""

    def __init__(self, match: Match) -> None:
        self.match = match
        self._groups: dict[tuple[str, str, str, str, str, str], tuple[Address, str, int]] = {}

    def compare(self, at: Address, of: Subject, fresh: Flat, held: Flat, part: str = "") -> None:
        """Enter the attributes of a subject, or of a part of it, that differ."""
        for name, pair in self.differing(fresh, held).items():
            self.add(at, of, part + name, *pair)

    def differing(self, fresh: Flat, held: Flat) -> Flat:
        """Return expected and held values, in pairs, of the attributes that differ."""
        usual = {key: usual_value(key) for key in {**fresh, **held}}
        pairs = {key: (fresh.get(key, value), held.get(key, value)) for key, value in usual.items()}
        return {key: pair for key, pair in pairs.items() if not self.is_same(key, *pair)}

    def is_same(self, key: str, ours: Any, theirs: Any) -> bool:
        """Whether two values show the same; a text that follows a cell is written out as LibreOffice saves it."""
        if not isinstance(ours, Shown):
            return is_same(key, ours, theirs)
        if not isinstance(theirs, Shown):
            return bool(ours.words == theirs)
        return self.match.same(ours.meaning, theirs.meaning)

    def add(self, at: Address, subject: Subject, attribute: str, ours: Any, theirs: Any) -> None:
        """Enter a difference; what misleads a reader is a finding."""
        expected, held = str(ours), str(theirs)
        kind = SHOWN if misleads(subject, attribute, expected, held) else NOTICE
        key = at.sheet, kind, attribute, expected, held, subject.group
        first, words, count = self._groups.get(key, (at, subject.words, 0))
        self._groups[key] = first, words, count + 1

    def enter(self, report: Report) -> None:
        """Enter all into a report, a line for each group: ``number format: 0.00 → 0%, 12 cells``."""
        for (_, kind, attribute, expected, held, _), (at, words, count) in self._groups.items():
            what = f"{attribute} of {words}" + (f", {count:,} cells" if count > 1 else "")
            report.add_at(at, kind, held or "none", expected or "none", what)


def misleads(subject: Subject, attribute: str, expected: str, held: str) -> bool:
    """Whether a difference of an attribute may have a figure, a curve or a verdict read otherwise."""
    if TEXT.fullmatch(attribute):
        if held.split() == expected.split():
            return False
        if subject.kind == "unit":
            return is_unit(held) and not is_same_unit(held, expected)
        return text_misleads(expected, held, subject)
    tables = FINDINGS[: 1 + VERDICTS.get(subject.kind, 0)] if subject.kind != "remark" else ()
    return held != COPY and any(table.fullmatch(f"{attribute}: {held}") for table in tables)


def text_misleads(expected: str, held: str, subject: Subject) -> bool:
    """Whether a text says what belongs elsewhere: another's words, other figures, or another unit in brackets."""
    if not held:  # without its label nobody knows what an entry is
        return subject.kind == "entry"
    more = set(TELLING.findall(held)) - set(TELLING.findall(expected))
    units = [text.partition("[")[2].rstrip("] ") for text in (expected, held)]
    return bool(more) or held in subject.others or (all(units) and not is_same_unit(*units))


def is_same_unit(unit: str, other: str) -> bool:
    """Whether two units are the same, however they are spelled."""
    sizes = unit_size(unit), unit_size(other)
    return unit.split() == other.split() or (sizes[0] is not None and sizes[0] == sizes[1])


def is_unit(text: str) -> bool:
    """Whether a text reads as a unit, or as a figure with its unit."""
    return bool(TELLING.search(text)) or unit_size(text) is not None


@cache
def unit_size(text: str) -> tuple[Any, float] | None:
    """Return dimension and size of a unit in SI; None for words that are no unit."""
    # here, since pint takes a third of a second to load
    from workbook.dimensions.units import size_of

    return size_of(TURNS.sub("1/min", text))
