"""What is displayed counts: a reader who is told another number, quantity, verdict or curve is warned; taste is not."""

import copy
import re

import pytest
from openpyxl.formatting.rule import CellIsRule, FormulaRule, Rule
from openpyxl.styles import Alignment, Font, GradientFill, PatternFill
from openpyxl.styles.colors import Color
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.styles.numbers import NumberFormat

from tests import cutting
from tests.workbook.judging.hands import Known, repacked, spot, sub
from workbook.build import build
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.shown.book import displayed
from workbook.judging.verify import verify
from workbook.reading.files import BookFile, find_places


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    """A small book of the cutting machine, all checks OK."""
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(cutting.small(cycle=120, law=4, own_law=4), path)
    return Known(path)


@pytest.fixture(scope="module")
def failing(tmp_path_factory):
    """The same with a motor too weak: checks of the drive FAIL."""
    path = tmp_path_factory.mktemp("failing") / "book.xlsx"
    build(cutting.too_weak(), path)
    known = Known(path)
    assert any(q.value == "FAIL" for _, q in known.declared.checks)
    return known


@pytest.fixture
def edit(book, tmp_path):
    return Edit(book, tmp_path)


@pytest.fixture
def edit_failing(failing, tmp_path):
    return Edit(failing, tmp_path)


class Edit:
    """A book opened, to be changed and verified."""

    def __init__(self, known, folder):
        self.known, self.path, self.workbook = known, folder / "edited.xlsx", known.opened()

    def cell(self, address):
        return self.workbook[address.sheet][address.a1]

    def beside(self, block, columns):
        return self.cell(self.known.place(block, 0, columns))

    def seen(self):
        """What is said of how the book looks; the rest of verifying takes ten times as long."""
        file = BookFile(self.path, self.workbook, find_places(self.workbook))
        report = Report(self.path, self.known.template.name)
        displayed(Match(file, self.known.declared), {}, report)
        return report

    def verified(self):
        self.workbook.save(self.path)
        return verify(self.path)

    def found(self):
        return {(f.kind, f"{f.sheet}!{f.cell}") for f in self.seen().findings}

    def failing(self, n=0):
        """The address of a check that FAILs."""
        names = [q.name for _, q in self.known.declared.checks if q.value == "FAIL"]
        return self.known.place(names[n])

    def passing(self):
        return self.known.place(next(q.name for _, q in self.known.declared.checks if q.value == "OK"))


def name(address):
    return f"{address.sheet}!{address.a1}"


# number formats


@pytest.mark.parametrize(
    "code",
    [
        '0.00"0"', '"1"0.00', "0.0\\5", "0.0,", "0,,", '0.0,"k"', '"OK";"OK"', ";;;", ";;", '""', '0.0"k"',
        '0.0" m"', '0.0"%"', "0.0%%", "0.0%", '"-"0.0', '[>0]"12.5";0.0', "0\\.0", '0" 000"', "[White]0.0", "*90.0",
        "#,##0.0,", 'General"0"', '0.0"E3"', "0.0\\k", "[Color2]0.0",
    ],
)  # fmt: skip
@pytest.mark.sample(12)
def test_a_format_that_tells_another_number_is_found(code, edit):
    pair = next(p for p in edit.known.pairs(lambda p: p.declared_formula) if p.cell.quantity.unit == "rpm"
                and p.cell.expected > 1)  # fmt: skip
    edit.cell(pair.address).number_format = code
    assert edit.found() == {("shown", spot(pair.address))}


@pytest.mark.parametrize(
    "code",
    [
        "0.0000000", "0", "#,##0.00", "0.00E+00", "##0.0E+0", "General", "@", "yyyy-mm-dd", "hh:mm:ss", "[h]:mm",
        '0.0" rpm"', "[Red]0.0", "[$-407]0.0", "0.0_);(0.0)", "0.0;-0.0", "0.0;[Red]-0.0", "_-* #,##0.00_-", "# ?/?",
        '"ca. "0.0', "[>1000]0.0;0.000", "0.0;-0.0;0.0;@", "[Blue]General", "+0.0;-0.0", '"n = "0.0',
    ],
)  # fmt: skip
@pytest.mark.sample(10)
def test_a_format_of_taste_is_not(code, edit):
    pair = next(p for p in edit.known.pairs(lambda p: p.declared_formula) if p.cell.quantity.unit == "rpm"
                and p.cell.expected > 1)  # fmt: skip
    edit.cell(pair.address).number_format = code
    report = edit.seen()
    assert (report.findings, report.notices) == ([], [])


@pytest.mark.parametrize("code", ["0.0;0.0", "0.0;[Red]0.0", "0.0;;0.0", '0.0;"low"'])
def test_a_negative_number_shown_as_another_is_found(code, edit):
    pair = next(p for p in edit.known.pairs(lambda p: p.declared_formula) if isinstance(p.cell.expected, float)
                and p.cell.expected < -1e-3)  # fmt: skip
    edit.cell(pair.address).number_format = code
    assert edit.found() == {("shown", spot(pair.address))}


@pytest.mark.parametrize("code", [";;;", '"OK"', '0"0"', "0,"])
def test_a_format_of_an_input_or_a_constant_counts_too(code, edit):
    for role in ("input", "constant"):
        pair = next(p for p in edit.known.pairs(lambda p, r=role: p.cell.quantity.role == r) if p.held == 1)
        edit.cell(pair.address).number_format = code
        assert ("shown", spot(pair.address)) in edit.found()


def test_a_column_may_be_blank_where_its_own_rule_says_so(edit):
    rule = '0;-0;"–"'
    pairs = [p for p in edit.known.pairs() if p.cell.quantity.format == rule]
    assert any(p.cell.expected == 0 for p in pairs)
    for pair in pairs:
        edit.cell(pair.address).number_format = "0;\\-0;\\–"
    assert edit.found() == set()
    zero = next(p for p in pairs if p.cell.expected == 0)
    edit.cell(zero.address).number_format = '0;-0;"7"'
    assert edit.found() == {("shown", spot(zero.address))}


def test_zeros_hidden_by_the_view_are_found(edit):
    edit.workbook["Timing"].sheet_view.showZeros = False
    found = edit.found()
    assert found
    assert all(kind == "shown" and where.startswith("Timing!") for kind, where in found)


@pytest.mark.parametrize("code", ['"OK";"OK";"OK";"OK"', ";;;", ';;;"OK"', '@" OK"', '"not "@', '0;0;0;"FAIL"'])
def test_a_format_that_changes_a_verdict_is_found(code, edit):
    at = edit.passing()
    edit.cell(at).number_format = code
    assert ("shown", name(at)) in edit.found()


@pytest.mark.parametrize(("code", "bad"), [(";;;", True), ('0"0"', True), ("0.000", False)])
def test_a_conditional_number_format_counts(code, bad, edit):
    pair = edit.known.a_number()
    look = DifferentialStyle(numFmt=NumberFormat(numFmtId=200, formatCode=code))
    cells = edit.workbook[pair.address.sheet].conditional_formatting
    cells.add(pair.address.a1, Rule(type="expression", formula=["TRUE"], dxf=look))
    cells.add(pair.address.a1, Rule(type="expression", formula=["FALSE"], dxf=look))
    assert edit.found() == ({("shown", spot(pair.address))} if bad else set())


# units


@pytest.mark.parametrize("unit", ["m/s", "rad/s", "1/s", "krpm", "Hz", "°/s", "h", "km"])
def test_a_changed_unit_is_found(unit, edit):
    block = next(p.cell.block.name for p in edit.known.pairs(lambda p: not p.cell.block.is_table)
                 if p.cell.quantity.unit == "rpm")  # fmt: skip
    cell = edit.beside(block, 1)
    assert cell.value == "rpm"
    cell.value = unit
    assert edit.found() == {("shown", f"{cell.parent.title}!{cell.coordinate}")}


@pytest.mark.parametrize("unit", ["1/min", "min⁻¹", " rpm ", "giri/min", "U/min"])
def test_the_same_unit_in_another_spelling_is_not(unit, edit):
    block = next(p.cell.block.name for p in edit.known.pairs(lambda p: not p.cell.block.is_table)
                 if p.cell.quantity.unit == "rpm")  # fmt: skip
    edit.beside(block, 1).value = unit
    report = edit.seen()
    assert (report.findings, report.notices) == ([], [])


def test_a_unit_that_is_gone_is_a_notice(edit):
    block = next(p.cell.block.name for p in edit.known.pairs(lambda p: not p.cell.block.is_table)
                 if p.cell.quantity.unit == "rpm")  # fmt: skip
    edit.beside(block, 1).value = None
    report = edit.seen()
    assert report.findings == []
    assert len(report.notices) == 1


def test_the_unit_of_a_column_counts(edit):
    head = edit.workbook["Drive MC01"]
    cell = next(c for row in head.iter_rows() for c in row if isinstance(c.value, str) and c.value.endswith("[rpm]"))
    cell.value = cell.value.replace("[rpm]", "[rad/s]")
    assert edit.found() == {("shown", f"Drive MC01!{cell.coordinate}")}


# labels, symbols, headings


def swapped(one, other):
    one.value, other.value = other.value, one.value


def scalars(edit, sheet, role=None):
    return [p.cell.block.name for p in edit.known.pairs(lambda p: not p.cell.block.is_table)
            if p.address.sheet == sheet and p.cell.quantity.symbol
            and (role is None or p.cell.quantity.role == role)]  # fmt: skip


@pytest.mark.parametrize("role", ["input", "calculation", "result"])
@pytest.mark.parametrize("column", [-2, -1])
def test_labels_and_symbols_that_changed_places_are_found(role, column, edit):
    one, other = (edit.beside(block, column) for block in scalars(edit, "Drive MC01", role)[:2])
    assert one.value != other.value
    swapped(one, other)
    assert {("shown", f"Drive MC01!{c.coordinate}") for c in (one, other)} <= edit.found()


def test_heads_of_columns_that_changed_places_are_found(edit):
    place = edit.known.place("cycle1")
    sheet = edit.workbook[place.sheet]
    row = next(r for r in range(place.row - 1, 0, -1) if sheet.cell(r, place.column + 1).value == "y" or
               str(sheet.cell(r, place.column + 1).value).startswith("y "))  # fmt: skip
    one, other = sheet.cell(row, place.column + 1), sheet.cell(row, place.column + 2)
    assert one.value != other.value
    swapped(one, other)
    assert {("shown", f"{place.sheet}!{c.coordinate}") for c in (one, other)} <= edit.found()


def test_headings_that_changed_places_are_found(edit):
    sheet = edit.known.declared.sheets[2]
    texts = [t for t in sheet.texts if t.style == "heading"][:2]
    one, other = (edit.workbook[sheet.title].cell(t.row, t.column) for t in texts)
    swapped(one, other)
    assert {kind for kind, _ in edit.found()} == {"shown"}


@pytest.mark.parametrize("column", [-2, -1])
def test_words_of_another_language_are_notices(column, edit):
    cell = edit.beside(scalars(edit, "Drive MC01")[3], column)
    cell.value = "Drehmoment des Motors"
    report = edit.seen()
    assert report.findings == []
    assert [f.cell for f in report.notices] == [cell.coordinate]


def test_a_book_in_another_language_is_listed_and_agrees(edit):
    for sheet in edit.known.declared.sheets:
        for text in sheet.texts:
            cell = edit.workbook[sheet.title].cell(text.row, text.column)
            if text.style in ("label", "header", "heading", "subheading") and cell.value:
                cell.value = f"«{cell.value}»"
    report = edit.seen()
    assert report.findings == []
    assert len(report.notices) > 100


# hidden and coloured verdicts


def hide_row(edit, at):
    edit.workbook[at.sheet].row_dimensions[at.row].hidden = True


def flat_row(edit, at):
    edit.workbook[at.sheet].row_dimensions[at.row].height = 0.5


def hide_column(edit, at):
    edit.workbook[at.sheet].column_dimensions[edit.cell(at).column_letter].hidden = True


def narrow_column(edit, at):
    edit.workbook[at.sheet].column_dimensions[edit.cell(at).column_letter].width = 0.1


def group_columns(edit, at):
    edit.workbook[at.sheet].column_dimensions.group("B", "Z", hidden=True)


def hide_sheet(edit, at):
    edit.workbook[at.sheet].sheet_state = "hidden"


def very_hide_sheet(edit, at):
    edit.workbook[at.sheet].sheet_state = "veryHidden"


def white(edit, at):
    without_rules(edit, at)
    edit.cell(at).font, edit.cell(at).fill = Font(color="FFFFFF"), PatternFill()


def themed_white(edit, at):
    without_rules(edit, at)
    edit.cell(at).font, edit.cell(at).fill = Font(color=Color(theme=0)), PatternFill()


def nearly_white(edit, at):
    without_rules(edit, at)
    edit.cell(at).font, edit.cell(at).fill = Font(color="FFFEFE"), PatternFill("solid", fgColor="FEFEFE")


def one_colour(edit, at):
    without_rules(edit, at)
    edit.cell(at).font, edit.cell(at).fill = Font(color="C00000"), PatternFill("solid", fgColor="C00000")


def white_by_rule(edit, at):
    without_rules(edit, at)
    look = {"font": Font(color="FFFFFF"), "fill": PatternFill(bgColor="FFFFFF", fill_type="solid")}
    edit.workbook[at.sheet].conditional_formatting.add(at.a1, FormulaRule(formula=["TRUE"], **look))


def tiny(edit, at):
    edit.cell(at).font = Font(sz=1)


def in_signs(edit, at):
    edit.cell(at).font = Font(name="Wingdings", sz=10)


def pushed_out(edit, at):
    edit.cell(at).alignment = Alignment(indent=200)


def frozen_out(edit, at):
    sheet = edit.workbook[at.sheet]
    sheet.freeze_panes = f"A{at.row + 5}"
    sheet.sheet_view.topLeftCell = f"A{at.row + 1}"


def without_rules(edit, at):
    """Take the sheet's rules away."""
    sheet = edit.workbook[at.sheet]
    sheet.conditional_formatting = type(sheet.conditional_formatting)()


HIDING = [hide_row, flat_row, hide_column, narrow_column, group_columns, white, themed_white, nearly_white, one_colour,
          white_by_rule, tiny, in_signs, pushed_out, frozen_out]  # fmt: skip


@pytest.mark.parametrize("hide", [*HIDING, hide_sheet, very_hide_sheet])
@pytest.mark.sample(8)
def test_a_failing_check_out_of_sight_is_found(hide, edit_failing):
    at = edit_failing.failing()
    hide(edit_failing, at)
    assert ("shown", name(at)) in edit_failing.found()


@pytest.mark.parametrize("hide", HIDING)
@pytest.mark.parametrize("verdict", ["overall", "status2"])
@pytest.mark.sample(14)
def test_the_overall_verdict_out_of_sight_is_found(hide, verdict, edit):
    at = edit.known.place(verdict)
    hide(edit, at)
    assert ("shown", name(at)) in edit.found()


@pytest.mark.parametrize("hide", [hide_row, white, tiny])
def test_a_passing_check_out_of_sight_is_a_notice(hide, edit):
    at = edit.passing()
    hide(edit, at)
    report = edit.seen()
    assert report.findings == []
    assert [name_of(f) for f in report.notices if f.cell == at.a1] == [name(at)]


def name_of(finding):
    return f"{finding.sheet}!{finding.cell}"


def test_a_hidden_sheet_is_a_notice_where_nothing_fails(edit):
    edit.workbook["Checks"].sheet_state = "hidden"
    report = edit.seen()
    assert report.findings == []
    assert [(f.sheet, f.kind) for f in report.notices] == [("Checks", "notice")]


def test_the_list_of_checks_counts_too(edit_failing):
    at = edit_failing.failing()
    names = [q.name for _, q in edit_failing.known.declared.checks]
    row = [q.value for _, q in edit_failing.known.declared.checks].index("FAIL")
    listed = edit_failing.known.place("checks", row, 2)
    assert names[row]
    hide_row(edit_failing, listed)
    assert edit_failing.found() == {("shown", name(listed))}
    assert at != listed


GREEN = {"font": Font(color="006100"), "fill": PatternFill(bgColor="C6EFCE", fill_type="solid")}


@pytest.mark.parametrize(
    "rule",
    [
        CellIsRule(operator="equal", formula=['"FAIL"'], **GREEN),
        CellIsRule(operator="notEqual", formula=['"OK"'], **GREEN),
        FormulaRule(formula=["TRUE"], **GREEN),
        Rule(type="containsText", operator="containsText", text="fail", formula=['NOT(ISERROR(SEARCH("fail",A1)))'],
             dxf=DifferentialStyle(**GREEN)),
        Rule(type="notContainsBlanks", formula=["LEN(TRIM(A1))>0"], dxf=DifferentialStyle(**GREEN)),
        CellIsRule(operator="equal", formula=['"FAIL"'], font=Font(color="00B050")),
    ],
)  # fmt: skip
def test_a_rule_that_colours_a_fail_as_passed_is_found(rule, edit_failing):
    at = edit_failing.failing()
    without_rules(edit_failing, at)
    edit_failing.cell(at).fill = PatternFill()
    edit_failing.workbook[at.sheet].conditional_formatting.add(at.a1, copy.copy(rule))
    assert ("shown", name(at)) in edit_failing.found()


def test_a_rule_with_reference_that_colours_a_fail_as_passed_is_found(edit_failing):
    at = edit_failing.failing()
    without_rules(edit_failing, at)
    rule = FormulaRule(formula=[f'{at.a1}="FAIL"'], **GREEN)
    edit_failing.workbook[at.sheet].conditional_formatting.add(at.a1, rule)
    assert ("shown", name(at)) in edit_failing.found()


def test_our_own_rules_exchanged_are_found_though_nothing_fails_yet(edit):
    at = edit.passing()
    without_rules(edit, at)
    rule = CellIsRule(operator="equal", formula=['"FAIL"'], **GREEN)
    edit.workbook[at.sheet].conditional_formatting.add(at.a1, rule)
    assert edit.found() == {("shown", name(at))}


def test_a_fail_painted_green_is_found(edit_failing):
    at = edit_failing.failing()
    without_rules(edit_failing, at)
    edit_failing.cell(at).fill = PatternFill("solid", fgColor="92D050")
    assert edit_failing.found() == {("shown", name(at))}


# charts


def charted(edit, n=1):
    sheet = edit.workbook["Timing"]
    return sheet._charts[n]


def corner(chart):
    return ("shown", f"Timing!{'ABCDEFGHIJKLMNOPQRSTUVWXYZ'[chart.anchor._from.col]}{chart.anchor._from.row + 1}")


def other_y(chart):
    chart.series[0].yVal.numRef.f = chart.series[1].yVal.numRef.f.replace("$H", "$I")


def exchanged_y(chart):
    one, other = chart.series[0].yVal.numRef, chart.series[1].yVal.numRef
    one.f, other.f = other.f, one.f


def shorter(chart):
    chart.series[0].yVal.numRef.f = re.sub(r"\d+$", "120", chart.series[0].yVal.numRef.f)


def other_sheet(chart):
    chart.series[0].yVal.numRef.f = chart.series[0].yVal.numRef.f.replace("Cycle 1", "Drive MC01")


def other_x(chart):
    chart.series[0].xVal.numRef.f = chart.series[0].yVal.numRef.f


def cut(chart):
    chart.x_axis.scaling.max = 36


def moved(chart):
    chart.x_axis.scaling.min = 180


def cut_y(chart):
    chart.y_axis.scaling.max = 1


def backwards(chart):
    chart.x_axis.scaling.orientation = "maxMin"


def logarithmic(chart):
    chart.y_axis.scaling.logBase = 10


def scaled_labels(chart):
    chart.y_axis.number_format = '0"0"'


def other_unit(chart):
    run = chart.y_axis.title.tx.rich.p[0].r[0]
    run.t = run.t.replace("[mm]", "[m]")


@pytest.mark.parametrize(
    "change",
    [other_y, exchanged_y, shorter, other_sheet, other_x, cut, moved, cut_y, backwards, logarithmic, scaled_labels,
     other_unit],
)  # fmt: skip
def test_a_chart_that_shows_something_else_is_found(change, edit):
    chart = charted(edit)
    where = corner(chart)
    change(chart)
    assert edit.found() == {where}


def test_titles_of_two_charts_exchanged_are_found(edit):
    one, other = charted(edit, 1), charted(edit, 2)
    one.title, other.title = other.title, one.title
    assert {kind for kind, _ in edit.found()} == {"shown"}


def renamed(chart):
    chart.title = "Weg"


def wider(chart):
    chart.width, chart.height = 30, 20


def moved_away(chart):
    chart.anchor._from.row += 40
    chart.anchor._from.col += 3


def coloured(chart):
    chart.series[0].graphicalProperties.line.solidFill = "00FF00"
    chart.series[1].graphicalProperties.line.width = 50_000
    chart.series[2].smooth = True


def free_limits(chart):
    chart.x_axis.scaling.min = chart.x_axis.scaling.max = None


def roomy(chart):
    chart.y_axis.scaling.min, chart.y_axis.scaling.max = -1e4, 1e4


def no_grid(chart):
    chart.x_axis.majorGridlines = chart.y_axis.majorGridlines = chart.legend = None


@pytest.mark.parametrize(("change", "notices"), [(renamed, 1), (wider, 0), (moved_away, 0), (coloured, 0),
                                                 (free_limits, 0), (roomy, 0), (no_grid, 0)])  # fmt: skip
def test_a_chart_of_another_look_is_taste(change, notices, edit):
    change(charted(edit))
    report = edit.seen()
    assert report.findings == []
    assert len(report.notices) == notices


def test_charts_that_are_gone_and_charts_of_ones_own(edit):
    sheet = edit.workbook["Timing"]
    extra = copy.deepcopy(sheet._charts[1])
    extra.title = "mine"
    for series in extra.series:
        series.yVal.numRef.f = "'Timing'!$Q$116:$Q$120"
    del sheet._charts[2]
    sheet._charts.append(extra)
    report = edit.seen()
    assert report.findings == []
    assert [f.expected for f in report.notices] == ["Velocity"]


# taste, and what is gone


def test_what_is_taste_is_passed_over_in_silence(edit):
    for sheet in edit.workbook.worksheets:
        sheet.sheet_properties.tabColor = "FF0000"
        sheet.sheet_view.showGridLines = True
        sheet.freeze_panes = None
        for n, letter in enumerate("CDEFG"):
            sheet.column_dimensions[letter].width = 9 + 3 * n
        for row in range(4, 12):
            sheet.row_dimensions[row].height = 25
    for pair in edit.known.pairs()[::7]:
        cell = edit.cell(pair.address)
        cell.font = Font(name="Arial", sz=14, color="1F3864", italic=True)
        cell.fill = PatternFill("solid", fgColor="FFF2CC")
        cell.alignment = Alignment(horizontal="left")
    report = edit.seen()
    assert (report.findings, report.notices) == ([], [])


def test_a_gradient_behind_a_verdict_is_taste(edit_failing):
    edit_failing.cell(edit_failing.failing()).fill = GradientFill(stop=("FFFFFF", "FFC7CE"))
    assert edit_failing.found() == set()


def test_validations_removed_are_a_notice(edit):
    edit.workbook["Drive MC01"].data_validations.dataValidation = []
    report = edit.seen()
    assert report.findings == []
    assert [(f.sheet, f.kind) for f in report.notices] == [("Drive MC01", "notice")]


@pytest.mark.parametrize("attribute", [b'showZeros="1"', b'showFormulas="0"', b'zoomScale="70"'])
def test_other_settings_of_the_view_are_taste(attribute, book, tmp_path):
    change = {book.part("Timing"): sub(rb"<sheetView ", b"<sheetView " + attribute + b" ")}
    report = verify(repacked(book.path, tmp_path / "b.xlsx", change))
    assert (report.findings, report.notices) == ([], [])
