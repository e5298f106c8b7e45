"""Looks of the declared cells of a file, and its conditional formats, against those of a fresh build."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from openpyxl.cell.text import InlineFont
from openpyxl.formatting.rule import Rule
from openpyxl.formula.translate import Translator
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.judging.display.groups import Differences
from workbook.judging.display.looks import (
    UNKNOWN,
    UNSEEN,
    WHITE,
    LookReader,
    contrast,
    format_sections,
    look_changes,
    plain_number,
)
from workbook.judging.display.texts import QUIET, Label
from workbook.judging.matching import Match, Pair
from workbook.writing.archive import Cells, Strings
from workbook.writing.style import INK, conditional_formats
from workbook.writing.write import make_workbook


class CellStyles(Cells):
    """The numbers of the styles of a sheet's cells, by row and column, in place of cells that are written."""

    def __init__(self) -> None:
        super().__init__(Strings())
        self.numbers: dict[tuple[int, int], int] = {}

    def put(self, row: int, column: int, style: int, content: Any) -> None:
        """Keep the style of a cell."""
        self.numbers[row, column] = style

    def put_formula(self, row: int, column: int, style: int, formula: str, value: Any) -> None:
        """Keep the style of a formula cell."""
        self.numbers[row, column] = style


class FreshBook:
    """A declared book as openpyxl would save it, in memory: styles, pages and charts, without contents."""

    def __init__(self, declared: Book, model: type[BaseModel]) -> None:
        self._styles = {sheet.title: CellStyles() for sheet in declared.sheets}
        self.workbook: Any = make_workbook(declared, model, dict(self._styles))
        self.looks = LookReader(self.workbook)

    def style(self, sheet: str, row: int, column: int) -> Any:
        """Return the style of a cell, as openpyxl has it."""
        return self.workbook._cell_styles[self._styles[sheet].numbers.get((row, column), 0)]


class CellGroup(NamedTuple):
    """Cells of one column, one below the other: the column of a block, or a text that says what a cell is."""

    pairs: list[Pair]
    label: Label | None = None

    @property
    def at(self) -> Address:
        """The first cell."""
        return self.label.at if self.label else self.pairs[0].address

    @property
    def what(self) -> str:
        """The cells in words."""
        if self.label:
            return self.label.what
        quantity, block = self.pairs[0].cell.quantity, self.pairs[0].cell.block
        return f"{quantity.label} ({block.name})" if block.is_table else quantity.label

    @property
    def is_verdict(self) -> bool:
        """Whether the cells say OK or FAIL."""
        if not self.pairs:
            return False
        quantity, block = self.pairs[0].cell.quantity, self.pairs[0].cell.block
        return quantity.role == "check" or (block.name, quantity.name) == ("checks", "verdict")

    @property
    def counts(self) -> bool:
        """Whether what is read otherwise there is a finding: of figures, verdicts, labels and units, not of notes."""
        return not self.label or self.label.text.style not in QUIET

    @property
    def declared_sheet(self) -> str:
        """The title of the sheet on which the cells are declared."""
        return (self.label.block if self.label else self.pairs[0].cell.block).sheet.title

    @property
    def declared_column(self) -> int:
        """The column in which the cells are declared."""
        return self.label.text.column if self.label else self.pairs[0].cell.column

    @property
    def is_folded(self) -> bool:
        """Whether a fresh build has the cells in a hidden column."""
        block = self.label.block if self.label else self.pairs[0].cell.block
        return 0 < block.sheet.folded <= self.declared_column


def check_looks(match: Match, fresh: FreshBook, groups: Iterable[CellGroup], differences: Differences) -> None:
    """Enter which cells look otherwise than in a fresh build."""
    reader = LookReader(match.file.workbook)
    fonts = text_fonts(match)
    known: dict[tuple[Any, ...], list[tuple[str, str, str, bool]]] = {}
    for group in groups:
        quantity = group.pairs[0].cell.quantity if group.pairs else None
        for at, (sheet, row, column), shown in shown_cells(group):
            cell = match.file.cell(at)
            if cell is None:
                continue
            style, is_text = fresh.style(sheet, row, column), isinstance(shown, str)
            held: Any = cell._style  # type: ignore[union-attr]
            unit = quantity.unit if quantity else ""
            for font in (None, *fonts.get(at, ())):
                key = (tuple(style), tuple(held), is_text, unit, font and id(font))
                if key not in known:
                    looks = fresh.looks.cell_look(style), reader.cell_look(held, font)
                    known[key] = list(look_changes(*looks, is_text, unit))
                for name, expected, found, misleads in known[key]:
                    recoloured = group.is_verdict and name in ("ink", "ground", "number format")
                    differences.add(at, name, expected, found, group.what, group.counts and (misleads or recoloured))


def shown_cells(group: CellGroup) -> Iterator[tuple[Address, tuple[str, int, int], Any]]:
    """Yield where each cell stands in the file and in a fresh build, and what it shows."""
    if group.label:
        text = group.label.text
        yield group.at, (group.label.block.sheet.title, text.row, text.column), text.text
    for pair in group.pairs:
        value = pair.cell.expected if pair.declared_formula else pair.held
        yield pair.address, (pair.cell.block.sheet.title, pair.cell.row, pair.cell.column), value


def text_fonts(match: Match) -> dict[Address, list[Any]]:
    """Return the fonts of parts of texts, by the cells that show them."""
    fonts: dict[Address, list[Any]] = {}
    if (inspected := match.file.inspected) is None:
        return fonts
    for title, rows in inspected.sheets.items():
        fonts |= {Address(title, *at): held for at, held in rows.fonts.items()}
        for cell in rows.written if inspected.fonts else ():
            if cell.kind == "s" and cell.how is None and int(cell.value or -1) in inspected.fonts:
                fonts[Address(title, cell.row, cell.column)] = inspected.fonts[int(cell.value or -1)]
    parse: Any = InlineFont.from_tree
    return {at: [parse(font) for font in elements] for at, elements in fonts.items()}


class RuleLook(NamedTuple):
    """What a conditional format does: its kind and condition, and the look that it gives."""

    kind: str
    operator: str
    number_format: tuple[str, ...]
    ink: str
    grounds: tuple[str, ...]  # of a scale of colours several
    is_struck: bool
    hides_value: bool  # bars or icons in place of a figure


class PlacedRule(NamedTuple):
    """A conditional format with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: list[tuple[int, int, int, int]]

    def covers(self, group: CellGroup, whole: bool = False) -> bool:
        """Whether the rule covers some cells of a column, or all of them."""
        ends = group.pairs[0].address, group.pairs[-1].address
        first, last = (end.row for end in (ends if whole else reversed(ends)))
        return any(
            top <= first and last <= bottom and left <= ends[0].column <= right
            for top, left, bottom, right in self.ranges
        )


def check_rules(match: Match, groups: Iterable[CellGroup], is_torn: bool, differences: Differences) -> set[int]:
    """Enter conditional formats of declared cells that a fresh build has not, and those that are gone.

    Returns the rules of the file that are those of a fresh build, by their identity. In a file that is torn rules went
    with the cells that were cut.
    """
    reader = LookReader(match.file.workbook)
    fresh = {name: list(conditional_formats(block)) for name, block in match.declared.blocks.items()}
    columns: dict[str, dict[int, list[CellGroup]]] = defaultdict(lambda: defaultdict(list))
    for group in (group for group in groups if group.pairs):
        columns[group.at.sheet][group.at.column].append(group)
    known, met = set[int](), set[tuple[str, int]]()
    for placed, group in rules_by_group(match, columns):
        block, quantity = group.pairs[0].cell.block, group.pairs[0].cell.quantity
        same = [
            number
            for number, mark in enumerate(fresh[block.name])
            if quantity in mark.quantities and is_same_rule(match, mark.rule, placed, group, reader)
        ]
        if same:
            known.add(id(placed.rule))
            met |= {(block.name, same[0])} if placed.covers(group, whole=True) else set()
            continue
        look = rule_look(placed.rule, reader)
        if not (is_torn and look.number_format and not any(look.number_format)):
            misleads = rule_misleads(look, group)
            differences.add(group.at, "conditional format", "no such rule", describe_rule(look), group.what, misleads)
    for name in match.file.places.keys() & fresh.keys() if not is_torn else ():
        for number, mark in enumerate(fresh[name]):
            if (name, number) not in met:
                at = match.file.places[name].cell(0, 0)
                expected = describe_rule(rule_look(mark.rule, reader))
                differences.add(at, "conditional format", expected, "no such rule", f"the cells of {name}", False)
    return known


def rules_by_group(
    match: Match, columns: Mapping[str, Mapping[int, list[CellGroup]]]
) -> Iterator[tuple[PlacedRule, CellGroup]]:
    """Yield the conditional formats of a file, each with the declared columns of which it covers cells."""
    for sheet in match.file.workbook.worksheets:
        for area in sheet.conditional_formatting:
            ranges = [(r.min_row, r.min_col, r.max_row, r.max_col) for r in area.sqref.ranges]
            wide = [
                group
                for column, held in columns[sheet.title].items()
                if any(left <= column <= right for _, left, _, right in ranges)
                for group in held
            ]
            for placed in (PlacedRule(rule, ranges) for rule in area.rules):
                yield from ((placed, group) for group in wide if placed.covers(group))


def rule_look(rule: Rule, reader: LookReader) -> RuleLook:
    """Return what a rule does; colours in six digits, none where it leaves them."""
    look = rule.dxf
    font, fill = getattr(look, "font", None), getattr(look, "fill", None)
    code = look.numFmt.formatCode if look is not None and look.numFmt is not None else None
    bar = [rule.dataBar.color] if rule.dataBar else []
    grounds = [reader.colour(colour, UNKNOWN) for colour in (*(rule.colorScale.color if rule.colorScale else ()), *bar)]
    return RuleLook(
        str(rule.type),
        str(rule.operator or ""),
        format_sections(code)[:3] if code else (),
        reader.colour(font.color, "") if font else "",
        tuple(grounds or ([reader.ground(fill, conditional=True)] if fill else [])),
        bool(font and font.strike),
        any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)),
    )


def is_same_rule(match: Match, fresh: Rule, placed: PlacedRule, group: CellGroup, reader: LookReader) -> bool:
    """Whether a rule of a file is one of a fresh build, in condition and look."""
    held, block = placed.rule, group.pairs[0].cell.block
    if rule_look(fresh, reader) != rule_look(held, reader):
        return False
    texts = [str(text).removeprefix("=") for text in held.formula]
    if fresh.type != "expression":
        return bool(texts == fresh.formula)
    place, declared = match.file.places[block.name], f"={fresh.formula[0]}"
    first = f"A{min(top for top, *_ in placed.ranges)}"  # the cell for which its formulas are written
    moved = Translator(f"={texts[0]}", first).translate_formula(f"A{place.row}") if texts else ""
    return moved == declared or match.same_formula(declared, block, moved, place.sheet)


def rule_misleads(look: RuleLook, group: CellGroup) -> bool:
    """Whether a rule of one's own may have a figure or a verdict read otherwise, now or at other values."""
    colours = bool(look.ink or look.grounds)
    if group.is_verdict and (colours or look.number_format or look.is_struck):
        return True
    quantity = group.pairs[0].cell.quantity
    other = bool(look.number_format) and plain_number(look.number_format, quantity.unit) != ("N",)
    ink = look.ink or INK
    hidden = colours and any(contrast(ink, ground) < UNSEEN for ground in look.grounds or (WHITE,))
    return other or hidden or look.hides_value or look.is_struck


def describe_rule(look: RuleLook) -> str:
    """Return a rule in a few words."""
    gives = [
        f"number format {';'.join(look.number_format)}".replace("\0", "") if look.number_format else "",
        f"ink {look.ink}" if look.ink else "",
        f"ground {', '.join(look.grounds)}" if look.grounds else "",
        "struck out" if look.is_struck else "",
        "bars or icons in place of figures" if look.hides_value else "",
    ]
    return f"{look.kind} {look.operator}".strip() + ": " + (", ".join(filter(None, gives)) or "no look")
