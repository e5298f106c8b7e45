"""How cells look: number formats against those of a fresh build, fonts, fills and alignments by what can be read.

Cells that are judged alike are one run, and what is told of all of a kind is told once.
"""

from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

from openpyxl.cell.text import InlineFont
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.judging.shown import taste
from workbook.judging.shown.colours import Palette, contrast, looks_passed
from workbook.judging.shown.formats import Judged, judged
from workbook.judging.shown.words import Found
from workbook.writing.write import format_of

INKS = UNKNOWN, HIDDEN, FADED = "in colours that cannot be known", "in the colour of its ground", "in a faint colour"


class Seen(NamedTuple):
    """Cells of one column, one below the other: the column of a block, or a text that says what a cell is.

    ``counts`` is whether they are verdicts, figures, units or labels: what is read otherwise there is a finding;
    ``folded`` whether a fresh build has them in a hidden column; ``verdict`` whether they say OK or FAIL.
    """

    at: Address
    last: int
    pairs: list[Pair]
    what: str
    counts: bool
    folded: bool
    verdict: bool = False

    @property
    def text(self) -> bool:
        """Whether the cells show texts."""
        return not self.pairs or any(isinstance(value_of(pair), str) for pair in self.pairs)


def seen(match: Match, found: list[Found]) -> Iterator[Seen]:
    """Yield all cells of a file that are declared, with the texts that say what they are."""
    for pairs in match.by_column():
        cell, at = pairs[0].cell, pairs[0].address
        what = f"{cell.quantity.label} ({cell.block.name})" if cell.block.is_table else cell.quantity.label
        folded, verdict = 0 < cell.block.sheet.folded <= cell.column, is_verdict(pairs[0])
        yield Seen(at, pairs[-1].address.row, pairs, what, True, folded, verdict)
    for at, word in found:
        yield Seen(at, at.row, [], word.what, word.counts, 0 < word.block.sheet.folded <= word.text.column)


def is_verdict(pair: Pair) -> bool:
    """Whether a cell says OK or FAIL."""
    cell = pair.cell
    return cell.quantity.role == "check" or (cell.block.name, cell.quantity.name) == ("checks", "verdict")


def value_of(pair: Pair) -> Any:
    """Return what a cell should show."""
    return pair.cell.expected if pair.declared_formula else pair.held


class Told:
    """What is told of the cells of a file: of many that are shown alike, at the first of them."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, str, str, str, str], tuple[Address, str, int]] = {}

    def add(
        self, at: Address, judged: Judged, expected: str, what: str, counts: bool = True, cells: int = 1,
        group: str | None = None,
    ) -> None:  # fmt: skip
        """Enter what is told of some cells, the first of them ``at``; once for all of a ``group``, or of ``what``."""
        kind, said = judged
        if kind:
            key = at.sheet, kind if counts else NOTICE, said, expected, what if group is None else group
            first, name, count = self._told.get(key, (at, what, 0))
            self._told[key] = first, name, count + cells

    def enter(self, report: Report) -> None:
        """Enter all into a report."""
        for (_, kind, said, expected, _), (at, what, count) in self._told.items():
            more = f", and {count - 1:,} more cells" if count > 1 else ""
            report.say(at, kind, said, expected, what + more)


class Looks:
    """The looks of the cells of a file; ``model`` is that of the machine's entries."""

    def __init__(self, match: Match, model: type[BaseModel], told: Told) -> None:
        self._match, self._model, self._told = match, model, told
        self.palette = Palette(match.file.workbook)
        self._known: dict[tuple[int, ...], list[Judged]] = {}
        self._fonts = fonts_within(match)

    def judge(self, seen: Seen, coloured: bool) -> None:
        """Enter what is to be told of how cells look; ``coloured`` ones have their colours from a rule."""
        styles: dict[int, list[Any]] = defaultdict(list)
        addresses = [pair.address for pair in seen.pairs] or [seen.at]
        base = self.palette.look(self._match.file.cell(seen.at))
        for n, address in enumerate(addresses):
            if (cell := self._match.file.cell(address)) is not None:
                styles[id(cell._style)].append((n, cell))  # type: ignore[union-attr]
            for font in self._fonts.get(address, ()):
                for one in of_font(font, self.palette), of_colours(self.palette.colour(font.color, base[0]), base[1]):
                    for said in one:
                        self._told.add(address, said, "as built", seen.what, seen.counts)
        for cells in styles.values():
            n, cell = cells[0]
            for found, expected in self._formats(seen, cell.number_format, [n for n, _ in cells]):
                self._told.add(addresses[n], found, expected, seen.what, seen.counts, len(cells))
            for kind, text in self._of_style(cell):
                if not (coloured and text in INKS):
                    sure = SHOWN if seen.verdict and text == UNKNOWN else kind
                    self._told.add(addresses[n], (sure, text), "as built", seen.what, seen.counts, len(cells))
            if seen.verdict and not coloured and looks_passed(base):
                self._told.add(addresses[n], (SHOWN, "FAIL coloured as passed"), "a colour of its own", seen.what)

    def _formats(self, seen: Seen, code: str, rows: list[int]) -> Iterator[tuple[Judged, str]]:
        """Yield what is to be told of the number format of some of the cells, with that of a fresh build."""
        if not seen.pairs:
            yield judged(code, "General", text=True), "General"
            return
        q = seen.pairs[0].cell.quantity
        declared = format_of(q, self._model)
        if code != declared:
            values = [value_of(seen.pairs[n]) for n in rows]
            zeros = any(type(v) in (int, float) and abs(v) < 0.5 for v in values)
            for text in {isinstance(v, str) for v in values if v is not None and v != ""}:
                yield judged(code, declared, q.unit, q.symbol, text, zeros), f"the number format {declared}"

    def _of_style(self, cell: Any) -> list[Judged]:
        """Return what is to be told of a cell's font, border, fill and alignment."""
        style = cell._style
        key = style.fontId, style.fillId, style.alignmentId, style.borderId
        if key not in self._known:
            parts = {"border": cell.border, "alignment": cell.alignment}
            colours = of_colours(*self.palette.look(cell))
            self._known[key] = [*of_font(cell.font, self.palette), *of_parts(parts), *colours]
        return self._known[key]


def of_parts(parts: dict[str, Any]) -> Iterator[Judged]:
    """Yield what is to be told of fonts, borders and alignments by the list of what they may be."""
    for part, attribute, usual, kind, said in taste.LOOKS:
        if part in parts and getattr(parts[part], attribute) not in usual:
            yield kind, said


def of_font(font: Any, palette: Palette) -> Iterator[Judged]:
    """Yield what is to be told of a font but for its colour; one of the theme is called as the theme says."""
    name = palette.fonts.get(font.scheme) or getattr(font, "rFont", None) or getattr(font, "name", None) or "calibri"
    name, size = str(name).casefold(), font.sz or taste.SMALL
    if name.startswith(taste.SIGNS):
        yield SHOWN, f"in the signs of {name}"
    elif name.split()[0] not in taste.FONTS:
        yield NOTICE, f"in the font {name}"
    if not taste.SMALL <= size <= taste.LARGE:
        yield SHOWN if size < taste.LEAST_SIZE else NOTICE, f"{size:g} points high"
    yield from of_parts({"font": font})


def of_colours(ink: Any, ground: Any) -> Iterator[Judged]:
    """Yield what is to be told of an ink on a ground; None is a colour that cannot be known, as of a gradient."""
    if ink is None or ground is None:
        yield NOTICE, UNKNOWN
    elif contrast(ink, ground) < taste.FAINT:
        hidden = contrast(ink, ground) < taste.UNSEEN
        yield (SHOWN, HIDDEN) if hidden else (NOTICE, FADED)


def fonts_within(match: Match) -> dict[Address, list[Any]]:
    """Return the fonts of parts of texts, by the cells that show them."""
    found: dict[Address, list[Any]] = {}
    inspected = match.file.inspected
    if inspected is None:
        return found
    for title, rows in inspected.sheets.items():
        found |= {Address(title, *at): held for at, held in rows.fonts.items()}
        for cell in rows.written if inspected.fonts else ():
            if cell.kind == "s" and cell.how is None and int(cell.value or -1) in inspected.fonts:
                found[Address(title, cell.row, cell.column)] = inspected.fonts[int(cell.value or -1)]
    made: Any = InlineFont.from_tree
    return {at: [made(one) for one in fonts] for at, fonts in found.items()}
