"""How cells look: number formats against those of a fresh build, fonts, fills and alignments by what can be read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from openpyxl.cell.text import InlineFont
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, SHOWN
from workbook.judging.shown import taste
from workbook.judging.shown.colours import BLACK, WHITE, Look, Palette, contrast
from workbook.judging.shown.formats import Judged, judged
from workbook.judging.shown.seen import Seen, Told, value_of
from workbook.writing.write import format_of

INKS = UNKNOWN, HIDDEN, FADED = "in colours that cannot be known", "in the colour of its ground", "in a faint colour"


class Looks:
    """The looks of the cells of a file; ``model`` is that of the machine's entries."""

    def __init__(self, match: Match, model: type[BaseModel], told: Told) -> None:
        self._match, self._model, self._told = match, model, told
        self.palette = Palette(match.file.workbook)
        self._known: dict[tuple[int, ...], list[Judged]] = {}
        self._fonts = fonts_within(match)

    def judge(self, seen: Seen, coloured: bool) -> None:
        """Enter what is to be told of how cells look; ``coloured`` ones have their colours from a rule."""
        styles: dict[int, list[Any]] = {}
        addresses = [pair.address for pair in seen.pairs] or [seen.at]
        for n, address in enumerate(addresses):
            cell = self._match.file.cell(address)
            if cell is not None:
                styles.setdefault(id(cell._style), []).append((n, cell))  # type: ignore[union-attr]
            for font in self._fonts.get(address, ()):
                for one in of_font(font, self.palette, self.base(seen).ground):
                    self._told.add(address, one, "as built", seen.what, seen.counts)
        for cells in styles.values():
            n, cell = cells[0]
            for found, expected in self._formats(seen, cell, [n for n, _ in cells]):
                self._told.add(addresses[n], found, expected, seen.what, seen.counts, len(cells))
            for kind, said in self._of_style(cell):
                if not (coloured and said in INKS):
                    sure = SHOWN if seen.verdict and said == UNKNOWN else kind
                    self._told.add(addresses[n], (sure, said), "as built", seen.what, seen.counts, len(cells))
            if seen.verdict and not coloured and self.base(seen).green:
                self._told.add(addresses[n], (SHOWN, "FAIL coloured as passed"), "a colour of its own", seen.what)

    def _formats(self, seen: Seen, cell: Any, rows: list[int]) -> Iterator[tuple[Judged, str]]:
        """Yield what is to be told of the number format of some of the cells, with that of a fresh build."""
        code = cell.number_format
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

    def base(self, seen: Seen) -> Look:
        """Return ink and ground of the first of some cells, by its own style."""
        cell = self._match.file.cell(seen.at)
        if cell is None or not cell.has_style:
            return Look(BLACK, WHITE)
        return Look(self.palette.colour(cell.font.color, BLACK), self.palette.ground(cell.fill, WHITE))

    def _of_style(self, cell: Any) -> list[Judged]:
        """Return what is to be told of a cell's font, fill and alignment."""
        style = cell._style
        key = style.fontId, style.fillId, style.alignmentId
        if key not in self._known:
            ground = self.palette.ground(cell.fill, WHITE)
            self._known[key] = [*of_font(cell.font, self.palette, ground), *of_alignment(cell.alignment)]
        return self._known[key]


def of_font(font: Any, palette: Palette, ground: Any) -> Iterator[Judged]:
    """Yield what is to be told of a font on a ground."""
    name = str(getattr(font, "rFont", None) or getattr(font, "name", None) or "calibri").casefold()
    if font.strike:
        yield SHOWN, "struck out"
    if name.startswith(taste.SIGNS) or font.charset == taste.SYMBOLS:
        yield SHOWN, f"in the signs of {name}"
    elif name.split()[0] not in taste.FONTS:
        yield NOTICE, f"in the font {name}"
    size = font.sz or taste.SMALL
    if size < taste.SMALL:
        yield SHOWN if size < taste.LEAST_SIZE else NOTICE, f"{size:g} points high"
    effects = ("outline", "shadow", "condense", "extend", "vertAlign")
    for effect in (one for one in effects if getattr(font, one) not in (None, False, "baseline")):
        yield NOTICE, f"written with the effect {effect}"
    yield from of_colours(palette.colour(font.color, BLACK), ground)


def of_colours(ink: Any, ground: Any) -> Iterator[Judged]:
    """Yield what is to be told of an ink on a ground; None is a colour that cannot be known, as of a gradient."""
    if ink is None or ground is None:
        yield NOTICE, UNKNOWN
    elif contrast(ink, ground) < taste.FAINT:
        hidden = contrast(ink, ground) < taste.UNSEEN
        yield (SHOWN, HIDDEN) if hidden else (NOTICE, FADED)


def of_alignment(alignment: Any) -> Iterator[Judged]:
    """Yield what is to be told of an alignment."""
    if alignment.horizontal == "fill":
        yield SHOWN, "repeated over its cell"
    if (alignment.indent or 0) > taste.MOST_INDENT:
        yield SHOWN, "indented out of its cell"
    if alignment.horizontal in ("distributed", "justify"):
        yield NOTICE, "spread over its cell"
    for odd, said in ((alignment.textRotation, "turned"), (alignment.readingOrder == 2, "from right to left"),
                      (alignment.shrinkToFit, "shrunk to its cell")):  # fmt: skip
        if odd:
            yield NOTICE, said


def fonts_within(match: Match) -> dict[Address, list[Any]]:
    """Return the fonts of parts of texts, by the cells that show them."""
    found: dict[Address, list[Any]] = {}
    inspected = match.file.inspected
    if inspected is None:
        return found
    made: Any = InlineFont.from_tree
    fonts: dict[int, list[Any]] = {n: [made(one) for one in held] for n, held in inspected.fonts.items()}
    for title, rows in inspected.sheets.items():
        for (row, column), held in rows.fonts.items():
            found[Address(title, row, column)] = [made(one) for one in held]
        for cell in rows.written if fonts else ():
            if cell.kind == "s" and cell.how is None and int(cell.value or -1) in fonts:
                found[Address(title, cell.row, cell.column)] = fonts[int(cell.value or -1)]
    return found
