"""Units of cells from labels and unit cells; what cannot be added, and conversions that are missing or there twice."""

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from functools import cached_property, lru_cache

from workbook.audit.finding import Finding, many
from workbook.audit.lines import Lines, cell_text
from workbook.audit.view import View, numbers_of
from workbook.book.address import Address
from workbook.dimensions.rules import UNKNOWN, Judged, Term, UnitWalk
from workbook.dimensions.units import NONE, POWERS, dimension_of, powers

BRACKETS = re.compile(r"(?:(?<=\s)\(|^\(|\[)([^\])(\[]{1,12})[\])]")
BEHIND = re.compile(r"(?:,|\bin)\s+([^\s,]{1,8})$")
NOTHING = frozenset("- – 1 / . —".split())
GRAVITY = frozenset("9.81 9.80665 9.807 9.8".split())
ACCELERATION = Term(dimension_of("m/s²"))
NUMBERS = "25 30 32 36 60 64 90 120 180 270 360 3600 6000 9549 9550 60000 25.4 0.0254 3.6 9.55"
CONVERTING = frozenset(map(float, [*GRAVITY, *NUMBERS.split()]))
# degrees an hour, hours a day, days a year: 15 converts nothing else
RATES = frozenset([15.0, 24.0, 365.0])
# 6 ppm
MILLIONTHS = re.compile(r"(?<![\w.$])(?!(?:1|60|3600)[/*])\d+(?:\.\d+)?(?:/1000000|\*1e-06)(?!\d)")
WORDS = frozenset(
    ("m mm cm dm km µm μm um nm in inch ft kg g t mg lb s ms min h d N kN mN MN Nm kNm mNm Nmm Ncm W kW MW "
     "mW J kJ MJ Wh kWh V mV kV A mA Ω ohm H mH F µF nF Hz kHz rpm rad mrad deg ° C K Pa kPa MPa GPa bar mbar l L ml "
     "% ‰ Ws Nms pieces cycles").split()
)  # fmt: skip
INDEX = re.compile(r"^1/|[a-zA-ZµΩ]\^?-?[1-4](?!\d)")  # where a unit has digits


class Units:
    """The unit of each figure, as far as the workbook tells it."""

    def __init__(self, view: View) -> None:
        self.view = view

    @cached_property
    def of(self) -> dict[Address, str]:
        """The units by cells: right of a figure, in brackets left of it, or over its column."""
        units, ended = {}, set()
        for cell, (left, above) in sorted(self.view.headings.items(), key=lambda row: (row[0].sheet, row[0].row)):
            own = unit_in_text(self.view.texts[left]) if left and self.is_row(left, cell) else ""
            if own and above and own != self.over(above):
                ended.add(above)  # rows that have units of their own
            over = self.over(above) if above and above not in ended else ""
            if unit := self.right(cell) or unit_in_text(self.view.beside(cell)) or over:
                units[cell] = unit
        return units

    def is_row(self, label: Address, cell: Address) -> bool:
        """Whether nothing but figures stands between a label and a cell of its row."""
        return all(self.view.figure(cell._replace(column=k)) for k in range(label.column + 1, cell.column))

    def right(self, cell: Address) -> str:
        """Return the unit in the cell right of a figure, where most texts there are units."""
        other = cell._replace(column=cell.column + 1)
        text = self.view.texts.get(other, "")
        return text if text and (cell.sheet, other.column) in self.unit_columns and is_unit(text) else ""

    @cached_property
    def unit_columns(self) -> set[tuple[str, int]]:
        """The columns whose texts, right of figures, are units."""
        counts: dict[tuple[str, int], list[bool]] = defaultdict(list)
        for cell in self.view.headings:
            other = cell._replace(column=cell.column + 1)
            if other in self.view.texts:
                counts[cell.sheet, other.column].append(is_unit(self.view.texts[other]))
        return {line for line, units in counts.items() if sum(units) * 5 >= 3 * len(units)}

    def over(self, heading: Address) -> str:
        """Return the unit in the heading of a column."""
        text = self.view.texts[heading]
        return unit_in_text(text) or (text if heading in self.bare else "")

    @cached_property
    def bare(self) -> set[Address]:
        """The texts in rows of nothing but units; of a row of single letters, which may be symbols, none."""
        rows = defaultdict(list)
        for cell in self.view.texts:
            rows[cell.sheet, cell.row].append(cell)
        units = [c for c in rows.values() if len(c) > 1 and all(is_unit(self.view.texts[t]) for t in c)]
        return {c for cells in units if any(len(self.view.texts[t]) > 1 for t in cells) for c in cells}

    @cached_property
    def checked(self) -> dict[Address, str]:
        """The contradictions of dimensions, in words, by cell."""
        units = {cell: "1" if unit in NOTHING else unit for cell, unit in self.of.items()}
        return Walk(self.view.contents, units).walk(self.view.order[0]).wrong


@lru_cache(maxsize=10_000)
def is_unit(text: str) -> bool:
    """Whether a text is a unit, or a dash for none: of words that engineers write, so that symbols are none."""
    plain = text.strip(" []()")
    if plain in NOTHING:
        return True
    words = re.findall(r"[^\W\d_]+|[%‰°]", plain.translate(POWERS))
    if not words or len(plain) > 12 or re.search(r"\d", INDEX.sub("", plain.translate(POWERS))):
        return False
    dimension = dimension_of(plain) if all(word in WORDS for word in words) else None
    return dimension is not None and abs(powers(dimension).get("[mass]", 0)) <= 1  # "H Wh/m2" is a symbol and a unit


@lru_cache(maxsize=10_000)
def unit_in_text(text: str) -> str:
    """Return the unit in brackets in a text, or behind a comma or ``in`` at its end."""
    found = [*BRACKETS.findall(text), *BEHIND.findall(text.strip())]
    return next((unit.strip() for unit in found if is_unit(unit)), "")


class Walk(UnitWalk):
    """Units run through all formulas, but for those with numbers that may have a unit of their own."""

    def judge(self, shape: str, terms: tuple[Term, ...]) -> Judged:
        """Return the term of a formula and its faults; 9.81 has the unit of an acceleration, or none."""
        numbers = numbers_of(shape)[1]
        has_unit = MILLIONTHS.search(shape) or any(may_have_unit(number) for number in numbers)
        if has_unit or "LOG" in shape or "10^" in shape:
            return UNKNOWN, ()  # decibels; a density, 0.05 s
        if not (gravity := GRAVITY.intersection(numbers)):
            return super().judge(shape, terms)
        pattern = r"(?<![\w.])(?:" + "|".join(map(re.escape, gravity)) + r")(?![\w.])"
        text = re.sub(pattern, f"A{len(terms) + 1}", shape)
        results = [super(Walk, self).judge(text, (*terms, way)) for way in (ACCELERATION, Term(NONE))]
        if len({term for term, _ in results}) > 1:
            return UNKNOWN, () if any(not faults for _, faults in results) else results[0][1]
        return min(results, key=lambda result: len(result[1]))


@lru_cache(maxsize=10_000)
def may_have_unit(number: str) -> bool:
    """Whether a number that is a count, or a part of a whole number, is no usual conversion: a density, 0.05 s."""
    value = float(number)
    return (
        not converts(value)
        and (value in RATES or value > 16 or value < 1)
        and (value.is_integer() or (1 / value).is_integer())
    )


@lru_cache(maxsize=10_000)
def converts(value: float) -> bool:
    """Whether a number is a count, a half, a quarter or such, a power of ten, or converts units."""
    small = value.is_integer() and value <= 16 and value not in RATES
    power = value > 0 and (math.log10(value) % 1.0) in (0.0, 1.0)
    return small or power or value in (0.125, 0.25, 0.5, 1.5) or value in CONVERTING


def dimensions(lines: Lines, units: Units) -> Iterator[Finding]:
    """Yield formulas whose units do not go together, each form of a column once."""
    yield from once(lines, ((cell, "dimension", why) for cell, why in units.checked.items()))


def once(lines: Lines, rows: Iterable[tuple[Address, str, str]]) -> Iterator[Finding]:
    """Yield a finding for the first cell of each form in a column, with how many others have the same."""
    view, groups = lines.view, defaultdict[tuple[str, int, str, str, str], list[Address]](list)
    for cell, rule, why in rows:
        groups[cell.sheet, cell.column, view.forms[cell].skeleton, rule, why].append(cell)
    for (_, _, _, rule, why), cells in groups.items():
        first = min(cells)
        yield Finding(first, rule, why + many(cells), "high", view.text(first))


def wandering(lines: Lines, units: Units) -> Iterator[Finding]:
    """Yield patterns whose reference moves through figures of unlike units."""
    view = lines.view
    for stretch in lines.stretches:
        for n in range(0, len(stretch.modes), 2):
            areas = [view.forms[c].areas[n // 2] for c in stretch.cells[:4]]
            if not areas[0].single or not stretch.modes[n] or not stretch.down:
                continue
            found = Counter(dimension_of(units.of[a.first]) for a in areas if a.first in units.of)
            if len(found) > 1:
                why = f"its reference to {areas[0].a1} moves along, to {areas[1].a1} of another unit"
                yield Finding(stretch.cells[1], "moved-off", why, "high", cell_text(view, areas[1].first))
                break


RULES = (dimensions, wandering)
