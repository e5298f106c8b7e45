"""Cells of a file and of a fresh build as a reader sees them: style, sight, conditional formats, validation."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from openpyxl import Workbook
from openpyxl.formula.translate import Translator
from openpyxl.worksheet.cell_range import CellRange
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Block, Quantity
from workbook.book.quantity import OK
from workbook.judging.display.charts import compare_charts
from workbook.judging.display.differences import VERDICTS, Differences, Subject
from workbook.judging.display.flat import (
    BLACK,
    WHITE,
    Flat,
    Shown,
    flatten,
    format_by_number,
    format_sections,
    in_words,
    plain_number,
    text_section,
)
from workbook.judging.display.sheets import SheetView, compare_sheets
from workbook.judging.display.texts import QUIET, Label, compare_texts
from workbook.judging.matching import Match, Pair
from workbook.judging.report import Report
from workbook.reading.contents import Cells
from workbook.reading.package import Anchor
from workbook.reading.rows import LAST_ROW, MAIN
from workbook.writing import archive
from workbook.writing.archive import Strings
from workbook.writing.write import make_workbook

OVERALL = ("overall", "status")  # verdicts of the book and of each sheet, always to be in sight
NOTHING: Mapping[str, Any] = MappingProxyType({})
NO_RULE = "no such rule"
# as .ods has it in each rule
LIKE_CELLS = {"font name val": "Calibri", "font sz val": "11", "font color": BLACK}
# defaults, which LibreOffice writes
OF_BARS = {"minLength": "10", "maxLength": "90", "showValue": "1"}
UNSHOWN = ("priority", "dxfId", "sqref")  # attributes of rules
DEFAULTS = ("0", "between", "stop")  # values of attributes of rules, which some programs write


class CellStyles(archive.Cells):
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


class Overlay(NamedTuple):
    """A conditional format or validation, in words, with the ranges of cells that it covers."""

    rule: Any
    words: str
    ranges: Collection[CellRange]

    def covers(self, column: int, first: int, last: int) -> bool:
        """Whether any of its ranges covers rows of a column, from ``first`` to ``last``."""
        there = (held for held in self.ranges if held.min_col <= column <= held.max_col)
        return any(held.min_row <= first and last <= held.max_row for held in there)


class BookLooks:
    """A workbook as it looks: the file, with its drawings by sheet, or a fresh build, with its styles by cell."""

    def __init__(
        self,
        workbook: Workbook,
        drawings: Mapping[str, Iterable[Anchor]] = NOTHING,
        styles: Mapping[str, CellStyles] = NOTHING,
    ) -> None:
        self.workbook: Any = workbook
        self._styles = styles
        self.views = dict[str, SheetView]()
        self.rules, self.validations = dict[str, list[Overlay]](), dict[str, list[Overlay]]()
        for sheet in self.workbook.worksheets:
            title, checks = sheet.title, sheet.data_validations.dataValidation
            self.views[title] = SheetView(sheet, drawings.get(title, ()))
            rules = [(rule, area) for area in sheet.conditional_formatting for rule in area.rules]
            self.rules[title] = [Overlay(r, rule_words(r), at.sqref.ranges) for r, at in rules]
            held = [(rule, attribute_words(rule)) for rule in checks]
            self.validations[title] = [Overlay(*rule, rule[0].sqref.ranges) for rule in held]

    def style(self, at: Address) -> Any:
        """Return the style of a cell of a fresh build, as openpyxl has it."""
        number = self._styles[at.sheet].numbers.get((at.row, at.column), 0)
        return self.workbook._cell_styles[number]

    def validation(self, at: Address) -> str:
        """Return the validation of a cell in words; nothing of a cell without."""
        rules = self.validations[at.sheet]
        return next((rule.words for rule in rules if rule.covers(at.column, at.row, at.row)), "")

    def look(self, style: Any, is_text: bool, unit: str) -> Flat:
        """Return the attributes of a style of openpyxl's, with its number format as it shows a text or a quantity."""
        code = format_by_number(self.workbook, style.numFmtId)
        meaning = text_section(code) if is_text else plain_number(code, unit)
        look = Flat({"number format": Shown(meaning, code)})
        look |= {} if is_text else {"decimals": Shown(format_sections(code)[:3], code)}
        for name in ("font", "fill", "border", "alignment", "protection"):
            parts = getattr(self.workbook, f"_{name}s")
            look |= flatten(parts[getattr(style, f"{name}Id")].to_tree(name), name)
        ground = look.get("fill patternFill patternType") or WHITE
        if ground == "solid":
            ground = look.get("fill patternFill fgColor", BLACK)
            look.pop("fill patternFill bgColor", None)
        is_lost = (look.get("font color") or BLACK) == ground
        return look | {"legible": "no" if is_lost else "yes"}


def check_display(match: Match, model: type[BaseModel], computed: Cells, report: Report) -> None:
    """Enter what is shown otherwise than in a fresh build of the same inputs; what misleads a reader is a finding.

    ``model`` is that of the entries; ``computed`` are the formula cells' values, where there are none the engine's.
    """
    styles = {sheet.title: CellStyles() for sheet in match.declared.sheets}
    fresh = BookLooks(make_workbook(match.declared, model, dict(styles)), styles=styles)
    differences = Differences(match)
    held = BookLooks(match.file.workbook, match.file.inspected.drawings)
    labels = compare_texts(report, differences)
    compare_cells(fresh, held, labels, computed, differences)
    compare_rules(fresh, held, differences)
    compare_sheets(fresh.workbook, differences)
    compare_charts(fresh.workbook, held.views, differences)
    differences.enter(report)


class Spot(NamedTuple):
    """A cell in the file, the same in a fresh build, and what it shows."""

    at: Address
    fresh: Address
    subject: Subject
    value: Any
    quantity: Quantity | None = None  # none of a text that says what a cell is


def find_spots(match: Match, labels: Iterable[Label]) -> Iterator[Spot]:
    """Yield the declared cells, and the declared texts."""
    for label in labels:
        text, title = label.text, label.block.sheet.title
        subject = Subject(label.what, "remark" if text.style in QUIET else "")
        yield Spot(label.at, Address(title, text.row, text.column), subject, text.text)
    for pairs in match.columns:
        subject = subject_of(pairs[0])
        for cell, at, held, has_formula in pairs:
            fresh = Address(cell.block.sheet.title, cell.row, cell.column)
            yield Spot(at, fresh, subject, cell.expected if has_formula else held, cell.quantity)


def subject_of(pair: Pair) -> Subject:
    """Return the column of a cell in words, and whether it says OK or FAIL, of the book or a sheet always in sight."""
    quantity, block = pair.cell.quantity, pair.cell.block
    name = f"{quantity.label} ({block.name})" if block.is_table else quantity.label
    if block.name.rstrip("0123456789") in OVERALL:
        return Subject(name, "failing")
    is_verdict = quantity.role == "check" or (block.name, quantity.name) == ("checks", "verdict")
    return Subject(name, "verdict" if is_verdict else "")


def compare_cells(
    fresh: BookLooks, held: BookLooks, labels: list[Label], computed: Cells, differences: Differences
) -> None:
    """Enter which declared cells look otherwise than in a fresh build, are out of sight, or have another validation."""
    match = differences.match
    fonts, known = text_fonts(match), dict[tuple[Any, ...], Flat]()
    for spot in find_spots(match, labels):
        at, subject, cell = spot.at, spot.subject, match.file.cell(spot.at)
        style = fresh.style(spot.fresh)
        theirs: Any = cell._style if cell is not None else style  # type: ignore[union-attr]
        how = isinstance(spot.value, str), spot.quantity.unit if spot.quantity else ""
        key = (id(style), id(theirs), *how)  # which cells of a book share
        if key not in known:
            known[key] = differences.differing(fresh.look(style, *how), held.look(theirs, *how))
            if "number format" in known[key]:
                known[key].pop("decimals", None)
        is_wrong = subject.kind in VERDICTS and computed.get(at, spot.value) != OK
        subject = subject._replace(kind="failing") if is_wrong else subject
        for name, pair in known[key].items():
            differences.add(at, subject, name, *pair)
        if cause := hidden_by(fresh, held, spot, is_wrong):
            differences.add(at, subject, "sight", "in sight", f"hidden by {cause}")
        if at in fonts:
            differences.compare(at, subject, {}, {"fonts of its parts": fonts[at]})
        if spot.quantity and spot.quantity.role == "input":
            ours, theirs = fresh.validation(spot.fresh), held.validation(at)
            differences.compare(at, subject, {"validation": ours}, {"validation": theirs})


def hidden_by(fresh: BookLooks, held: BookLooks, spot: Spot, is_wrong: bool) -> str:
    """Return what hides a cell, but in a fresh build; a hidden sheet hides verdicts that are ``is_wrong``."""
    view, page = held.views[spot.at.sheet], fresh.views[spot.fresh.sheet]
    cause = view.hidden_by(spot.at.row, spot.at.column)
    cause = cause or ("a hidden sheet" if is_wrong and view.is_hidden else "")
    return cause if cause and not page.hidden_by(spot.fresh.row, spot.fresh.column) else ""


def compare_rules(fresh: BookLooks, held: BookLooks, differences: Differences) -> None:
    """Enter conditional formats of declared cells that a fresh build has not, and those that are gone."""

    @cache  # tables beneath each other share columns
    def rules_in(looks: BookLooks, sheet: str, column: int) -> list[Overlay]:
        return [rule for rule in looks.rules[sheet] if rule.covers(column, LAST_ROW, 1)]

    what = "conditional format"
    for pairs in differences.match.columns:
        cell, first, last = pairs[0].cell, pairs[0].address, pairs[-1].address
        ours = rules_in(fresh, cell.block.sheet.title, cell.column)
        ours = [rule for rule in ours if rule.covers(cell.column, cell.row, cell.row)]
        declared = {rule.words: rule.rule for rule in ours}
        missing = set(declared)
        for rule in rules_in(held, first.sheet, first.column):
            if not rule.covers(first.column, last.row, first.row):  # any of the cells
                continue
            known = declared.get(rule.words)
            if known is None or not is_same_condition(differences.match, known, rule, cell.block):
                differences.add(first, subject_of(pairs[0]), what, "", rule.words)
            elif rule.covers(first.column, first.row, last.row):
                missing.discard(rule.words)
        for words in sorted(missing):
            differences.add(first, Subject(subject_of(pairs[0]).words), what, words, NO_RULE)


def rule_words(rule: Any) -> str:
    """Return the effect of a conditional format, but for the cells that the formula of its condition reads."""
    flat = Flat() if rule.type == "expression" else Flat(formula=", ".join(map(str, rule.formula)))
    for sign in (rule.colorScale, rule.dataBar, rule.iconSet):
        shown = flatten(sign.to_tree()) if sign is not None else {}
        flat |= {name: value for name, value in shown.items() if value != OF_BARS.get(name.strip())}
        flat |= {"showValue": "off"} if getattr(sign, "showValue", None) is False else {}
    if rule.dxf is not None:
        look = flatten(rule.dxf.to_tree("look")) | {"numFmt numFmtId": ""}
        own = (name for name, value in look.items() if value not in (LIKE_CELLS.get(name), "solid"))
        flat |= {name: look[name] for name in own}
        if code := flat.get("numFmt formatCode"):
            flat["numFmt formatCode"] = ";".join(format_sections(code)).replace("\0", "")
            flat["another number"] = "" if plain_number(code) == ("N",) else "yes"
    return ", ".join(filter(None, (in_words(flat), attribute_words(rule))))


def attribute_words(rule: Any) -> str:
    """Return the attributes of a conditional format or validation in words; a list has no operator."""
    shown = {name: value for name, value in rule if name not in UNSHOWN and value not in DEFAULTS}
    return in_words(shown | ({"operator": ""} if rule.type == "list" else {}))


def is_same_condition(match: Match, rule: Any, held: Overlay, block: Block) -> bool:
    """Whether a rule of a file holds for the same values as a rule of a fresh build."""
    if rule.type != "expression" or not held.rule.formula:
        return bool(rule.formula == held.rule.formula)
    place, declared = match.file.places[block.name], f"={rule.formula[0]}"
    # the cell for which its formulas are written
    first = f"A{min(cells.min_row for cells in held.ranges)}"
    text = str(held.rule.formula[0]).removeprefix("=")
    moved = Translator(f"={text}", first).translate_formula(f"A{place.row}")
    return match.same_formula(declared, block, moved, place.sheet)


def text_fonts(match: Match) -> dict[Address, str]:
    """Return the fonts of parts of texts in words, by the cells that show them (ISO/IEC 29500-1, 18.4.7)."""
    inspected = match.file.inspected
    texts = enumerate(inspected.strings.iterfind(f"{MAIN}si"))
    shared = {str(n): fonts for n, text in texts if (fonts := [*text.iter(f"{MAIN}rPr")])}
    held = dict[Address, list[Element]]()
    for title, rows in inspected.sheets.items():
        held |= {Address(title, *at): fonts for at, fonts in rows.fonts.items()}
        cells = (cell for cell in rows.written if cell.value in shared) if shared else ()
        of_texts = (cell for cell in cells if cell.kind == "s" and cell.how is None)
        held |= {Address(title, *cell[:2]): shared[str(cell.value)] for cell in of_texts}
    return {at: "; ".join(in_words(flatten(font)) for font in fonts) for at, fonts in held.items()}
