"""How cells look: number formats against those of a fresh build, fonts, fills and alignments by what can be read."""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from openpyxl.cell.text import InlineFont
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.judging.shown import taste
from workbook.judging.shown.colours import Look, Palette, contrast, looks_passed
from workbook.judging.shown.formats import Judged, judged
from workbook.judging.shown.words import HEADINGS, Found
from workbook.writing.write import format_of

INKS = UNKNOWN, HIDDEN, FADED = "in colours that cannot be known", "in the colour of its ground", "in a faint colour"
PASSED = SHOWN, "FAIL coloured as passed"


class Seen(NamedTuple):
    """Cells of one column, one below the other: the column of a block, or a text that says what a cell is."""

    at: Address
    last: int  # row
    pairs: list[Pair]
    what: str
    counts: bool  # verdicts, figures, units and labels do: what is read otherwise there is a finding
    folded: bool  # whether a fresh build has them in a hidden column
    verdict: bool = False  # whether they say OK or FAIL

    def format(self, code: str, values: Iterable[Any], declared: str = "General") -> Iterator[Judged]:
        """Yield what is to be told of a number format for values of the cells, in place of the declared one."""
        q, held = self.pairs[0].cell.quantity if self.pairs else None, [v for v in values if v not in (None, "")]
        zeros = any(type(v) in (int, float) and abs(v) < 0.5 for v in held)
        for text in {isinstance(v, str) for v in held} or {q is None}:
            yield judged(code, declared, q.unit if q else "", q.symbol if q else "", text, zeros)


def seen(match: Match, found: list[Found]) -> Iterator[Seen]:
    """Yield all cells of a file that are declared, with the texts that say what they are."""
    for pairs in match.by_column():
        (block, q), at = (pairs[0].cell.block, pairs[0].cell.quantity), pairs[0].address
        verdict = q.role == "check" or (block.name, q.name) == ("checks", "verdict")
        what, folded = f"{q.label} ({block.name})" if block.is_table else q.label, block.sheet.folded
        yield Seen(at, pairs[-1].address.row, pairs, what, True, 0 < folded <= pairs[0].cell.column, verdict)
    for at, word in found:
        counts, folded = word.text.style not in (*taste.QUIET, *HEADINGS), word.block.sheet.folded
        yield Seen(at, at.row, [], word.what, counts, 0 < folded <= word.text.column)


def value_of(pair: Pair) -> Any:
    """Return what a cell should show."""
    return pair.cell.expected if pair.declared_formula else pair.held


class Told:
    """What is told of the cells of a file: of many that are shown alike, at the first of them."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, str, str, str, str], tuple[Address, str, int]] = {}

    def add(
        self, at: Address, all_said: Iterable[Judged], expected: str, what: str, counts: bool = True, cells: int = 1,
        group: str | None = None,
    ) -> None:  # fmt: skip
        """Enter what is told of some cells, the first of them ``at``; once for all of a ``group``, or of ``what``."""
        for kind, said in all_said:
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

    def judge(self, one: Seen, coloured: bool) -> None:
        """Enter what is to be told of how cells look; ``coloured`` ones have their colours from a rule."""
        styles: dict[int, list[tuple[int, Address, Any]]] = defaultdict(list)
        base = self.base(one)
        for n, at in enumerate([pair.address for pair in one.pairs] or [one.at]):
            if (cell := self._match.file.cell(at)) is not None:
                styles[id(cell._style)].append((n, at, cell))  # type: ignore[union-attr]
            for font in self._fonts.get(at, ()):
                look = self.palette.colour(font.color, base[0]), base[1]
                self._told.add(at, of_style(self.palette, look, font=font), "as built", one.what, one.counts)
        for cells in styles.values():
            _, at, cell = cells[0]
            declared = format_of(one.pairs[0].cell.quantity, self._model) if one.pairs else "General"
            values = [value_of(one.pairs[n]) for n, *_ in cells if one.pairs]
            if cell.number_format != declared and (not values or any(v not in (None, "") for v in values)):
                said = one.format(cell.number_format, values, declared)
                self._told.add(at, said, f"the number format {declared}", one.what, one.counts, len(cells))
            told = [(SHOWN if one.verdict and said == UNKNOWN else kind, said) for kind, said in self._of_style(cell)
                    if not (coloured and said in INKS)]  # fmt: skip
            self._told.add(at, told, "as built", one.what, one.counts, len(cells))
            if one.verdict and not coloured and looks_passed(base):
                self._told.add(at, [PASSED], "a colour of its own", one.what)

    def base(self, one: Seen) -> Look:
        """Return ink and ground of the first of some cells."""
        return self.palette.look(self._match.file.cell(one.at))

    def _of_style(self, cell: Any) -> list[Judged]:
        """Return what is to be told of a cell's font, border, fill and alignment."""
        style = cell._style
        key = style.fontId, style.fillId, style.alignmentId, style.borderId
        if key not in self._known:
            parts = {"font": cell.font, "border": cell.border, "alignment": cell.alignment}
            self._known[key] = list(of_style(self.palette, self.palette.look(cell), **parts))
        return self._known[key]


def of_style(palette: Palette, look: Look, **parts: Any) -> Iterator[Judged]:
    """Yield what is to be told of a font, a border, an alignment, by what they may be, and of an ink on its ground."""
    for part, attribute, usual, kind, said in taste.LOOKS:
        if parts.get(part) is not None and getattr(parts[part], attribute) not in usual:
            yield kind, said
    if (font := parts.get("font")) is not None:  # one of the theme is called as the theme says
        name = palette.fonts.get(font.scheme) or getattr(font, "rFont", None) or getattr(font, "name", None)
        name, size = str(name or "calibri").casefold(), font.sz or taste.SMALL
        if name.startswith(taste.SIGNS):
            yield SHOWN, f"in the signs of {name}"
        elif name.split()[0] not in taste.FONTS:
            yield NOTICE, f"in the font {name}"
        if not taste.SMALL <= size <= taste.LARGE:
            yield SHOWN if size < taste.LEAST_SIZE else NOTICE, f"{size:g} points high"
    yield from of_colours(look)


def of_colours(look: Look) -> Iterator[Judged]:
    """Yield what is to be told of an ink on a ground; None is a colour that cannot be known, as of a gradient."""
    ink, ground = look
    if ink is None or ground is None:
        yield NOTICE, UNKNOWN
    elif contrast(ink, ground) < taste.FAINT:
        yield (SHOWN, HIDDEN) if contrast(ink, ground) < taste.UNSEEN else (NOTICE, FADED)


def fonts_within(match: Match) -> dict[Address, list[Any]]:
    """Return the fonts of parts of texts, by the cells that show them."""
    found: dict[Address, list[Any]] = {}
    if (inspected := match.file.inspected) is None:
        return found
    for title, rows in inspected.sheets.items():
        found |= {Address(title, *at): held for at, held in rows.fonts.items()}
        for cell in rows.written if inspected.fonts else ():
            if cell.kind == "s" and cell.how is None and int(cell.value or -1) in inspected.fonts:
                found[Address(title, cell.row, cell.column)] = inspected.fonts[int(cell.value or -1)]
    made: Any = InlineFont.from_tree
    return {at: [made(one) for one in fonts] for at, fonts in found.items()}
