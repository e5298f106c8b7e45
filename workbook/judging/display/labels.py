"""Labels, symbols, units and headings: whether each cell is still called what it is."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

from workbook.book.address import Address
from workbook.book.declare import FIRST, Block, Sheet, Text
from workbook.judging.display import permitted
from workbook.judging.matching import MOST_BETWEEN, Match
from workbook.judging.report import LAYOUT, NOTICE, SHOWN, Report

HEADINGS = ("heading", "subheading")
ABOVE = (*HEADINGS, "header", "units", "equation")
BESIDE = ("label", "symbol", "unit", "note")
MOST_ASIDE = 6  # columns that someone may have put between a cell and the texts of its row


class Label(NamedTuple):
    """A declared text that says what a cell is: of a row, or of a column of a table."""

    text: Text
    block: Block
    what: str


LocatedLabel = tuple[Address, Label]  # a declared text, and where it stands in the file, or something else in its place


def check_labels(match: Match, report: Report) -> list[LocatedLabel]:
    """Enter texts that say something else of a cell, and as notices those that are reworded; return where they are."""
    misled = {(f.sheet, f.cell) for f in report.findings if f.kind == "name"}
    for name in match.headless:
        at = match.file.places[name].cell(0, 0)
        report.say(at, LAYOUT, "no headings", "its headings above it: move them together", f"the table {name}")
    everything, titles = [], {sheet.title.casefold() for sheet in match.declared.sheets}
    for sheet, title in match.sheets:
        if title.casefold() != sheet.title.casefold():
            kind = SHOWN if title.casefold() in titles else NOTICE
            report.say(Address(title, 1, 1), kind, title, sheet.title, "the name of the sheet")
        known = [word for word in labels_of(sheet) if word.block.name in match.file.places.keys() - match.headless]
        found, others = list(locate_labels(match, known)), defaultdict[str, set[str]](set)
        for word in known:
            others[word.text.style].add(word.text.text)
        for at, word in found:
            first = match.file.places[word.block.name].cell(0, 0)
            if not first.column or (first.sheet, first.a1) not in misled:  # column 0: the first one is gone
                check_label(match, at, word, others[word.text.style], report)
        check_unlabelled(match, sheet, report)
        everything += found
    return everything


def labels_of(sheet: Sheet) -> Iterator[Label]:
    """Yield the texts of a sheet that say what its cells are."""
    ordered = sorted(sheet.blocks, key=lambda block: (block.row, block.column))
    rows = {b.row: b for b in reversed(ordered) if not b.is_table}
    tables = [block for block in ordered if block.is_table]
    for text in (text for text in sheet.texts if text.text):
        style = text.style
        if style in HEADINGS:
            if below := next((b for b in ordered if b.row > text.row and b.column >= text.column), None):
                yield Label(text, below, f"{style} over {below.title or below.quantities[0].label}")
        elif style in ABOVE:
            above = (b for b in tables if 0 < b.row - text.row <= 4 and text.column in b.columns.values())
            if block := next(above, None):
                yield Label(text, block, f"{block.title}, {style}")
        elif style in BESIDE and text.row in rows and not text.link:
            block = rows[text.row]
            if text.column in range(FIRST, block.column + 3):
                yield Label(text, block, f"{style} of {block.quantities[0].label}")


def locate_labels(match: Match, known: Iterable[Label]) -> Iterator[LocatedLabel]:
    """Yield where texts stand: all of a line above a table, and all of one column beside cells, moved alike.

    They are the nearest in which most of these texts are found, so that a right text elsewhere excuses no wrong one.
    """
    lines = defaultdict[tuple[str, int], list[Label]](list)
    for word in known:
        offset = word.text.row - word.block.row if word.text.style in ABOVE else word.text.column - word.block.column
        lines[word.block.name if word.text.style in ABOVE else "", offset].append(word)
    for (_, offset), line in lines.items():
        furthest = MOST_BETWEEN + 4 if line[0].text.style in ABOVE else MOST_ASIDE
        best = [label_address(match, word, offset) for word in line]
        for more in range(furthest) if offset > 0 else range(0, -furthest, -1):
            found = [label_address(match, word, offset + more) for word in line]
            there = [at.row > 0 < at.column and same_text(match.file.value(at), word.text.text)
                     for word, at in zip(line, found, strict=True)]  # fmt: skip
            if 2 * sum(there) > len(line):
                best = found
                break
        yield from ((at, word) for at, word in zip(best, line, strict=True) if at.column > 0 and at.row > 0)


def label_address(match: Match, word: Label, offset: int) -> Address:
    """Return the cell so many rows or columns away from that which a text belongs to."""
    block, held = word.block, match.file.places[word.block.name]
    if word.text.style not in ABOVE:
        return held.cell(0, offset)
    column = held.cell(0, word.text.column - block.column).column
    line = [Address(held.sheet, held.row + offset, one) for one in range(held.column, 0, -1)]
    moved = next((at for at in line if same_text(match.file.value(at), word.text.text)), None)
    return moved if moved and word.text.style in HEADINGS else Address(held.sheet, held.row + offset, column)


def check_label(match: Match, at: Address, word: Label, others: set[str], report: Report) -> None:
    """Enter what is wrong with one text."""
    style, expected, held = word.text.style, word.text.text, match.file.value(at)
    text = "" if held is None else str(held)
    if same_text(held, expected):
        kind = NOTICE if permitted.GAP.search(text) else ""
    else:
        kind = unit_kind(text, expected, others) if style in ("unit", "units") else text_kind(text, expected, others)
    if kind == SHOWN or (kind == NOTICE and style not in permitted.QUIET):
        report.say(at, kind, text or None, expected, word.what)


def text_kind(held: str, expected: str, others: Iterable[str]) -> str:
    """Return of which kind other words are: another's name misleads, and so do figures, translated words do not."""
    more = set(permitted.TELLING.findall(held)) - set(permitted.TELLING.findall(expected))
    return SHOWN if more or any(same_text(held, other) for other in others) else NOTICE


def unit_kind(held: str, expected: str, others: set[str]) -> str:
    """Return of which kind a changed unit, or symbol with one, is: another misleads, and so do exchanged ones."""
    (symbol, unit), (ours, declared) = split_unit(held), split_unit(expected)
    known = [split_unit(other) for other in others]
    stands = compare_units(unit, declared)
    exchanged = bool(unit) and stands != "same" and any(same_text(unit, other) for _, other in known)
    if stands == "other" or exchanged or (symbol != ours and any(symbol == other for other, _ in known)):
        return SHOWN
    return NOTICE if stands != "same" or symbol != ours or permitted.GAP.search(held) else ""


def split_unit(text: str) -> tuple[str, str]:
    """Return symbol and unit of ``s [mm]``; a text without brackets is a unit."""
    symbol, bracket, unit = text.partition("[")
    return (" ".join(symbol.split()), unit.strip().removesuffix("]").strip()) if bracket else ("", text.strip())


def check_unlabelled(match: Match, sheet: Sheet, report: Report) -> None:
    """Enter a unit, or figures, beside a cell whose quantity has no unit."""
    named = {(text.row, text.column) for text in sheet.texts}
    for block, held in match.placed(sheet):
        q = block.quantities[0]
        if block.is_table or q.role in ("check", "sentence") or (block.row, block.column + 1) in named:
            continue
        at = held.cell(0, 1)
        text = match.file.value(at)  # a finding where it reads as a unit, and as nothing else
        if isinstance(text, str) and at not in match.numbers and text.strip() and not parse_unit(text)[1]:
            report.say(at, SHOWN, text, None, f"unit of {q.label}")


def same_text(held: object, expected: str) -> bool:
    """Whether a cell holds a text, however its lines and spaces are broken."""
    return isinstance(held, str) and held.split() == expected.split()


# Units as people write them: the same one in another spelling, in other words, or another

PREFIXED = frozenset(["m", "g", "s", "N", "W", "J", "Pa", "Hz", "V", "A", "bar", "l", "rad", "K", "sec"])
PREFIXES = frozenset(["", "k", "M", "G", "d", "c", "m", "µ", "μ", "n"])
OTHERS = frozenset(["min", "h", "rev", "°", "deg", "rpm", "%", "‰", "°C", "°F", "t", "in", "inch", "inches", "ft",
    "mil", "lb", "lbf", "oz", "hp", "kp", "kgf", "PS"])  # fmt: skip
# turns and cycles a minute in all spellings: which of them is meant, the label says
TURNS = dict.fromkeys(("1/min", "min⁻¹", "min-1", "min^-1", "/min", "u/min", "upm", "umdr./min", "r/min", "rev/min",
    "rpm", "r.p.m.", "giri/min", "tr/min", "tr/mn", "cpm", "c/min", "cycles/min", "cycles per minute",
    "revolutions per minute", "takte/min", "hübe/min", "cicli/min", "coups/min"), "rpm")  # fmt: skip
SPELT = {"sec": "s", "deg": "°", "μm": "µm", "Pa": "N/m²", "MPa": "N/mm²", "Hz": "1/s", "W": "J/s", "l": "dm³"}
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
FACTOR = re.compile(r"([^\W\d_]+|°[CF]?|%|‰|1(?![0-9]))\^?(-?[0-9])?")


@lru_cache(maxsize=4_000)
def parse_unit(text: str) -> tuple[dict[str, int], tuple[str, ...]]:
    """Return the symbols of a unit with their powers, and the words in it that are no symbols, such as ``pieces``."""
    plain = text.strip()
    plain = TURNS.get(plain.lower(), SPELT.get(plain, plain)).translate(RAISED)
    powers, words, sign = Counter[str](), list[str](), 1
    for part in re.split(r"([/\s·*.()]+)", plain):
        if "/" in part:
            sign = -1
        elif part.strip(" ·*.()"):
            found = FACTOR.findall(part) if FACTOR.sub("", part) == "" else []
            words += [] if found else [part.casefold()]
            for name, power in found:
                *first, last = unit_symbols(name) or ("",)
                words += [] if last else [name.casefold()]
                powers.update(dict.fromkeys(first, sign))
                powers[SPELT.get(last, last)] += sign * int(power or 1)
    known = {name: power for name, power in powers.items() if power and name not in ("", "1")}
    return known, tuple(sorted(words))


def unit_symbols(text: str) -> tuple[str, ...]:
    """Return the symbol that a text is, or the two that it joins, such as Nm; nothing where it is none."""

    def known(part: str) -> bool:
        prefixed = any(part.endswith(name) and part.removesuffix(name) in PREFIXES for name in PREFIXED)
        return part == "1" or part in OTHERS or prefixed

    joined: Iterator[tuple[str, ...]] = ((text[:cut], text[cut:]) for cut in range(1, len(text)))
    return next((found for found in ((text,), *joined) if all(map(known, found))), ())


def compare_units(held: str, declared: str) -> str:
    """Return how a unit stands to the declared one: ``same``, ``reworded``, or ``other``."""
    if held.split() == declared.split():
        return "same"
    (powers, words), (ours, declared_words) = parse_unit(held), parse_unit(declared)
    if not held.strip() or (powers == ours and words and declared_words and words != declared_words):
        return "reworded"
    return "same" if (powers, words) == (ours, declared_words) else "other"
