"""How cells look: number and conditional formats against a fresh build, fonts, fills and alignments."""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from openpyxl.cell.text import InlineFont
from openpyxl.formatting.rule import Rule
from openpyxl.formula.translate import Translator
from openpyxl.utils import get_column_letter
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.quantity import FAIL, sample
from workbook.judging.display import permitted
from workbook.judging.display.formats import USUAL, Look, Palette, Remark, contrast, format_remark, is_green, sections
from workbook.judging.display.labels import HEADINGS, LocatedLabel
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.writing.style import FormatRule, conditional_formats
from workbook.writing.write import format_of

INKS = UNKNOWN, HIDDEN, FADED = "in colours that cannot be known", "in the colour of its ground", "in a faint colour"
PASSED = SHOWN, "FAIL coloured as passed"


class CellGroup(NamedTuple):
    """Cells of one column, one below the other: the column of a block, or a text that says what a cell is."""

    at: Address
    last: int  # row
    pairs: list[Pair]
    what: str
    counts: bool  # verdicts, figures, units and labels do: what is read otherwise there is a finding
    folded: bool  # whether a fresh build has them in a hidden column
    verdict: bool = False  # whether they say OK or FAIL

    def format(self, code: str, values: Iterable[Any], declared: str = "General") -> Iterator[Remark]:
        """Yield what is to be told of a number format for values of the cells, in place of the declared one."""
        q, held = self.pairs[0].cell.quantity if self.pairs else None, [v for v in values if v not in (None, "")]
        zeros = any(type(v) in (int, float) and abs(v) < 0.5 for v in held)
        for text in {isinstance(v, str) for v in held} or {q is None}:
            yield format_remark(code, declared, q.unit if q else "", q.symbol if q else "", text, zeros)


def cell_groups(match: Match, found: list[LocatedLabel]) -> Iterator[CellGroup]:
    """Yield all cells of a file that are declared, with the texts that say what they are."""
    for pairs in match.columns:
        (block, q), at = (pairs[0].cell.block, pairs[0].cell.quantity), pairs[0].address
        verdict = q.role == "check" or (block.name, q.name) == ("checks", "verdict")
        what, folded = f"{q.label} ({block.name})" if block.is_table else q.label, block.sheet.folded
        yield CellGroup(at, pairs[-1].address.row, pairs, what, True, 0 < folded <= pairs[0].cell.column, verdict)
    for at, word in found:
        counts, folded = word.text.style not in (*permitted.QUIET, *HEADINGS), word.block.sheet.folded
        yield CellGroup(at, at.row, [], word.what, counts, 0 < folded <= word.text.column)


def shown_value(pair: Pair) -> Any:
    """Return what a cell should show."""
    return pair.cell.expected if pair.declared_formula else pair.held


class Remarks:
    """Remarks on the cells of a file; cells with the same remark are counted at the first of them."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, str, str, str, str], tuple[Address, str, int]] = {}

    def add(
        self, at: Address, all_said: Iterable[Remark], expected: str, what: str, counts: bool = True, cells: int = 1,
        group: str | None = None,
    ) -> None:  # fmt: skip
        """Enter what is told of some cells, the first of them ``at``; once for all of a ``group``, or of ``what``."""
        for kind, said in (one for one in all_said if one[0]):
            key = at.sheet, kind if counts else NOTICE, said, expected, what if group is None else group
            first, name, count = self._told.get(key, (at, what, 0))
            self._told[key] = first, name, count + cells

    def enter(self, report: Report) -> None:
        """Enter all into a report."""
        for (_, kind, said, expected, _), (at, what, count) in self._told.items():
            more = f", and {count - 1:,} more cells" if count > 1 else ""
            report.say(at, kind, said, expected, what + more)


class StyleJudge:
    """Judges the looks of the cells of a file; ``model`` is that of the machine's entries."""

    def __init__(self, match: Match, model: type[BaseModel], told: Remarks) -> None:
        self._match, self._model, self._told = match, model, told
        self.palette = Palette(match.file.workbook)
        self._known: dict[tuple[int, ...], list[Remark]] = {}
        self._fonts = text_fonts(match)

    def judge(self, one: CellGroup, coloured: bool) -> None:
        """Enter what is to be told of how cells look; ``coloured`` ones have their colours from a rule."""
        styles: dict[int, list[tuple[int, Address, Any]]] = defaultdict(list)
        base = self.base(one)
        for n, at in enumerate([pair.address for pair in one.pairs] or [one.at]):
            if (cell := self._match.file.cell(at)) is not None:
                styles[id(cell._style)].append((n, at, cell))  # type: ignore[union-attr]
            for font in self._fonts.get(at, ()):
                look = self.palette.colour(font.color, base[0]), base[1]
                self._told.add(at, style_remarks(self.palette, look, font=font), "as built", one.what, one.counts)
        for cells in styles.values():
            _, at, cell = cells[0]
            q = one.pairs[0].cell.quantity if one.pairs else None
            declared = format_of(q, sample(q), self._model) if q else "General"
            values = [shown_value(one.pairs[n]) for n, *_ in cells if one.pairs]
            if cell.number_format != declared and (not values or any(v not in (None, "") for v in values)):
                said = one.format(cell.number_format, values, declared)
                self._told.add(at, said, f"the number format {declared}", one.what, one.counts, len(cells))
            told = [(SHOWN if one.verdict and said == UNKNOWN else kind, said) for kind, said in self._of_style(cell)
                    if not (coloured and said in INKS)]  # fmt: skip
            self._told.add(at, told, "as built", one.what, one.counts, len(cells))
            if one.verdict and not coloured and is_green(base):
                self._told.add(at, [PASSED], "a colour of its own", one.what)

    def base(self, one: CellGroup) -> Look:
        """Return ink and ground of the first of some cells."""
        return self.palette.look(self._match.file.cell(one.at))

    def _of_style(self, cell: Any) -> list[Remark]:
        """Return what is to be told of a cell's font, border, fill and alignment."""
        key = cell._style.fontId, cell._style.fillId, cell._style.alignmentId, cell._style.borderId
        if key not in self._known:
            parts = {"font": cell.font, "border": cell.border, "alignment": cell.alignment}
            self._known[key] = list(style_remarks(self.palette, self.palette.look(cell), **parts))
        return self._known[key]


def style_remarks(palette: Palette, look: Look, **parts: Any) -> Iterator[Remark]:
    """Yield what is to be told of a font, a border, an alignment, by what they may be, and of an ink on its ground."""
    for part, attribute, usual, kind, said in permitted.LOOKS:
        if parts.get(part) is not None and getattr(parts[part], attribute) not in usual:
            yield kind, said
    if (font := parts.get("font")) is not None:  # one of the theme is called as the theme says
        name = palette.fonts.get(font.scheme) or getattr(font, "rFont", None) or getattr(font, "name", None)
        name, size = str(name or "calibri").casefold(), font.sz or permitted.SMALL
        if name.startswith(permitted.SIGNS):
            yield SHOWN, f"in the signs of {name}"
        elif name.split()[0] not in permitted.FONTS:
            yield NOTICE, f"in the font {name}"
        if not permitted.SMALL <= size <= permitted.LARGE:
            yield SHOWN if size < permitted.LEAST_SIZE else NOTICE, f"{size:g} points high"
    yield from colour_remarks(look)


def colour_remarks(look: Look) -> Iterator[Remark]:
    """Yield what is to be told of an ink on a ground; None is a colour that cannot be known, as of a gradient."""
    ink, ground = look
    if ink is None or ground is None:
        yield NOTICE, UNKNOWN
    elif contrast(ink, ground) < permitted.FAINT:
        yield (SHOWN, HIDDEN) if contrast(ink, ground) < permitted.UNSEEN else (NOTICE, FADED)


def text_fonts(match: Match) -> dict[Address, list[Any]]:
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


# Conditional formats, which are known wherever cells have moved


class PlacedRule(NamedTuple):
    """A rule with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: list[tuple[int, int, int, int]]

    def covers(self, one: CellGroup, whole: bool = False) -> bool:
        """Whether the rule covers some of a column's cells, or all of them."""
        first, last = (one.at.row, one.last) if whole else (one.last, one.at.row)
        return any(t <= first and last <= b and left <= one.at.column <= r for t, left, b, r in self.ranges)

    def meets_fail(self) -> bool:
        """Whether the condition of the rule may be met by a cell that says FAIL."""
        rule, first = self.rule, str(self.rule.formula[0]).replace(" ", "").upper() if self.rule.formula else ""
        if rule.type == "cellIs" and first.startswith('"') and rule.operator in ("equal", "notEqual"):
            return (first == f'"{FAIL}"') == (rule.operator == "equal")
        if rule.type in ("containsText", "beginsWith", "endsWith") and rule.text:
            return str(rule.text).upper() in FAIL
        row, column = min(top for top, *_ in self.ranges), min(left for _, left, *_ in self.ranges)
        says_ok = re.fullmatch(rf'\(?\$?{get_column_letter(column)}{row}="OK"\)?', first)
        return rule.type != "expression" or not says_ok


def code_of(rule: Rule) -> str:
    """Return the number format that a rule gives, if it gives any."""
    return str(rule.dxf.numFmt.formatCode or "") if rule.dxf is not None and rule.dxf.numFmt is not None else ""


class RuleJudge:
    """Judges the conditional formats of a file; in one that is ``torn``, rules went with the cells that were cut."""

    def __init__(self, match: Match, looks: StyleJudge, told: Remarks, torn: bool = False) -> None:
        self._match, self._looks, self._told, self._torn = match, looks, told, torn
        self._fresh = {name: list(conditional_formats(block)) for name, block in match.declared.blocks.items()}
        self._met: set[tuple[str, int]] = set()
        self._before_fail: set[str] = set()  # verdicts with rules of one's own, after which ours may not apply
        self.known: set[int] = set()  # the rules of the file that are those of a fresh build, by their identity

    def judge(self, cells: list[CellGroup]) -> None:
        """Enter what is to be told of rules that someone has made, and of those that are gone."""
        by_column: dict[str, dict[int, list[CellGroup]]] = defaultdict(lambda: defaultdict(list))
        for one in cells:
            by_column[one.at.sheet][one.at.column].append(one)
        for sheet in self._match.file.workbook.worksheets:
            for group in sheet.conditional_formatting:
                ranges = [(r.min_row, r.min_col, r.max_row, r.max_col) for r in group.sqref.ranges]
                wide = [held for column, held in by_column[sheet.title].items()
                        if any(left <= column <= right for _, left, _, right in ranges)]  # fmt: skip
                for placed in (PlacedRule(rule, ranges) for rule in group.rules):
                    for one in (one for held in wide for one in held if placed.covers(one)):
                        if not self._is_known(placed, one):
                            what = f"a conditional format, {one.what}"
                            self._told.add(one.at, self._of_rule(placed, one), "no such rule", what, one.counts)
        for name, fresh in self._fresh.items() if not self._torn else ():
            place = self._match.file.places.get(name)
            for mark in (one for n, one in enumerate(fresh) if place is not None and (name, n) not in self._met):
                does = "leaves unused rows blank" if mark.rule.type == "expression" else "colours them"
                at, what = place.cell(0, 0), f"the cells of {name}"  # type: ignore[union-attr]
                self._told.add(at, [(NOTICE, "no such rule")], f"a rule that {does}", what, group="")

    def has_verdicts(self, one: CellGroup) -> bool:
        """Whether OK and FAIL have their colours from the rules of a fresh build."""
        name = one.pairs[0].cell.block.name
        return name not in self._before_fail and all((name, n) in self._met for n in range(len(self._fresh[name])))

    def _is_known(self, placed: PlacedRule, one: CellGroup) -> bool:
        """Whether a fresh build has this rule for the cells."""
        if not one.pairs:
            return False
        block, name = one.pairs[0].cell.block, one.pairs[0].cell.quantity.name
        for n, mark in enumerate(self._fresh[block.name]):
            if name in {q.name for q in mark.quantities} and self._same(mark, placed, one):
                self._met |= {(block.name, n)} if placed.covers(one, whole=True) else set()
                self.known.add(id(placed.rule))
                return True
        parts = sections(code_of(placed.rule))
        hides = len(parts) == 4 and not any(part.form for part in parts)
        return self._torn and name in {q.name for q in block.blanked} and hides

    def _same(self, mark: FormatRule, placed: PlacedRule, one: CellGroup) -> bool:
        """Whether a rule of a file is one of a fresh build, in condition and look."""
        ours, held, block = mark.rule, placed.rule, one.pairs[0].cell.block
        does = [(rule.type, rule.operator, self._colours(rule.dxf, (None, None)), sections(code_of(rule)),
                 bool(rule.dxf and rule.dxf.font and rule.dxf.font.strike)) for rule in (ours, held)]  # fmt: skip
        if does[0] != does[1]:
            return False
        texts = [str(text).removeprefix("=") for text in held.formula]
        if ours.type != "expression":
            return bool(texts == ours.formula)
        place, declared = self._match.file.places[block.name], f"={ours.formula[0]}"
        first = f"A{min(top for top, *_ in placed.ranges)}"  # the cell for which its formulas are written
        moved = Translator(f"={texts[0]}", first).translate_formula(f"A{place.row}") if texts else ""
        return moved == declared or self._match.same_formula(declared, block, moved, place.sheet)

    def _colours(self, look: Any, base: Look) -> Look:
        """Return ink and ground of a cell to which a rule gives a look."""
        palette, font, fill = self._looks.palette, getattr(look, "font", None), getattr(look, "fill", None)
        return (palette.colour(font.color, base[0]) if font else base[0],
                palette.ground(fill, base[1], conditional=True) if fill else base[1])  # fmt: skip

    def _of_rule(self, placed: PlacedRule, one: CellGroup) -> Iterator[Remark]:
        """Yield what is to be told of a rule that no fresh build has."""
        rule, look, base = placed.rule, placed.rule.dxf, self._looks.base(one)
        verdict = one.verdict and placed.meets_fail()
        if verdict:
            self._before_fail.add(one.pairs[0].cell.block.name)
        if code := code_of(rule):
            yield from one.format(code, map(shown_value, one.pairs))
        if any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)):
            yield SHOWN, "bars or icons instead of what it has"
        scale = [*(rule.colorScale.color if rule.colorScale else ()), *([rule.dataBar.color] if rule.dataBar else ())]
        for colour in scale:
            yield from colour_remarks((base[0], self._looks.palette.colour(colour, None)))
        if look is not None and look.font:
            yield from style_remarks(self._looks.palette, USUAL, font=look.font)
        if look is not None and ((look.font and look.font.color) or look.fill):
            colours = self._colours(look, base)
            sure = verdict and (colours[0] != base[0] or colours[1] is None)
            yield from ((SHOWN if sure else kind, said) for kind, said in colour_remarks(colours))
            if verdict and is_green(colours):
                yield PASSED
