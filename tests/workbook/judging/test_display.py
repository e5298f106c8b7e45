"""What is displayed counts: a reader who is told another number, quantity, verdict or curve is warned; taste is not."""

import copy

import pytest
from openpyxl import Workbook
from openpyxl.chart import ScatterChart
from openpyxl.drawing.spreadsheet_drawing import AnchorMarker, TwoCellAnchor
from openpyxl.formatting.rule import CellIsRule, DataBarRule, FormulaRule, IconSetRule, Rule
from openpyxl.styles import Border, Font, GradientFill, PatternFill, Side
from openpyxl.styles.colors import Color
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.styles.numbers import NumberFormat
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.table import Table, TableStyleInfo

from tests.workbook.judging.hands import STYLES, WORKBOOK, sub
from tests.workbook.judging.synthetic import Small, spots
from workbook.errors import ReadError
from workbook.judging.display.flat import format_sections
from workbook.judging.display.sheets import SheetView

DRIVE, CHART, PICTURE = "xl/worksheets/sheet1.xml", "xl/charts/chart1.xml", "xl/drawings/drawing1.xml"
RELS = "xl/worksheets/_rels/sheet1.xml.rels"


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    """A book whose checks are OK."""
    return Small(tmp_path_factory.mktemp("book"))


@pytest.fixture(scope="module")
def failing(tmp_path_factory):
    """The same with a motor too weak."""
    return Small(tmp_path_factory.mktemp("failing"), limit=5.0)


def silent(report):
    assert (report.findings, report.notices) == ([], [])


def test_a_book_as_built_and_as_openpyxl_saves_it_is_silent(book, failing):
    for one in (book, failing):
        silent(one.seen(one.path))
        silent(one.edited(lambda workbook: None))


# number formats


def formatted(book, code, block="peak", row=0, column=0):
    def change(workbook):
        book.cell(workbook, block, row, column).number_format = code

    return book.edited(change)


@pytest.mark.parametrize(
    "code",
    [
        '0.00"0"', '"1"0.00', "0.0\\5", "0.0,", "0,,", '0.0,"k"', '"OK";"OK"', ";;;", ";;", '""', '0.0"k"', '0.0" m"',
        '0.0"%"', "0.0%%", "0.0%", '"-"0.0', '[>0]"12.5";0.0', "0\\.0", '0" 000"', "[White]0.0", "*90.0", "#,##0.0,",
        'General"0"', '0.0"E3"', "0.0\\k", "[Color2]0.0", "[h]", "d", "[mm]:ss", "s.00", "yyyy", "ge", "0*.0", "*-0.0",
        ';;;"kNm"', "hh:mm", "0.0;0.0", "0.0;;0.0", '0.0;"low"', '0.0;-0.0;"7"', '0.0"٣"', '0.0" million"', "[DBNum1]0",
        "[$€-407]0.0", "[$-F800]0", '"T_min = "0.0', "[<0]0.0;-0.0", "[$-2000401]0.00",
    ],
)  # fmt: skip
def test_a_format_that_tells_another_number_is_found(code, book):
    report = formatted(book, code)
    assert spots(report.findings) == {"Drive!D14"}, report


@pytest.mark.parametrize(
    "code",
    [
        "0.0000000", "0", "#,##0.00", "0.00E+00", "##0.0E+0", "General", "@", '0.0" Nm"', "[Red]0.0", "[$-407]0.0",
        "0.0_);(0.0)", "0.0;-0.0", "0.0;[Red]-0.0", "_-* #,##0.00_-", "0.0;-0.0;0.0;@", "[Blue]General", "+0.0;-0.0",
        '_(* #,##0.00_);_(* \\(#,##0.00\\);_(* "-"??_);_(@_)', "# ##0.0", "0.0000;\\-0.0000",
    ],
)  # fmt: skip
def test_other_decimals_separators_and_colours_of_a_number_are_a_notice(code, book):
    report = formatted(book, code)
    assert (report.findings, len(report.notices)) == ([], 1)


def test_a_format_in_other_escapes_is_the_same():
    """As LibreOffice writes what openpyxl had written."""
    assert format_sections('0;-0;"–"') == format_sections("0;\\-0;\\–")
    assert format_sections("0;;")[:3] == format_sections("0;;;")[:3]


@pytest.mark.parametrize("number", [27, 36, 50, 58, 67, 71])
def test_a_format_that_each_language_reads_otherwise_is_found(number, book):
    """By number: openpyxl takes it for General."""
    changed = {STYLES: sub(rb'(<cellXfs.*?)numFmtId="16[4-9]"', rb'\1numFmtId="%d"' % number)}
    assert any(found.computed.startswith(f"format {number} ") for found in book.with_parts(changed).findings)


@pytest.mark.parametrize("code", ['"OK";"OK";"OK";"OK"', ";;;", ';;;"OK"', '@" OK"', '"not "@', '0;0;0;"FAIL"', "@@"])
@pytest.mark.parametrize("block", ["within", "which", "overall"])
def test_a_format_that_changes_a_text_is_found(code, block, book):
    assert formatted(book, code, block).findings


@pytest.mark.parametrize(("code", "bad"), [(";;;", True), ('0"0"', True), ("0.000", False)])
@pytest.mark.parametrize("condition", ["TRUE", "FALSE", "$D$14>1000"])
def test_a_conditional_number_format_counts_whether_it_applies_now_or_not(code, bad, condition, book):
    look = DifferentialStyle(numFmt=NumberFormat(numFmtId=200, formatCode=code))

    def change(workbook):
        rule = Rule(type="expression", formula=[condition], dxf=look)
        workbook["Drive"].conditional_formatting.add("D14", rule)

    assert spots(book.edited(change).findings) == ({"Drive!D14"} if bad else set())


# units, labels, symbols, headings


def beside(book, block, column, text):
    """The text beside a cell exchanged for another."""

    def change(workbook):
        book.cell(workbook, block, 0, column).value = text

    return book.edited(change)


@pytest.mark.parametrize(
    "unit", ["m/s", "rad/s", "1/s", "krpm", "Hz", "°/s", "h", "km", "10 rpm", "rpm/10", "x10 rpm", "rpm³", "100"]
)
def test_a_changed_unit_is_found(unit, book):
    assert spots(beside(book, "speed", 1, unit).findings) == {"Drive!E13"}


@pytest.mark.parametrize("unit", ["1/min", "min⁻¹", " rpm ", "giri/min", "U/min", "RPM", "r.p.m.", "cycles per minute"])
def test_the_same_unit_in_another_spelling_is_a_notice(unit, book):
    for block in ("speed", "rate"):
        report = beside(book, block, 1, unit)
        assert (report.findings, len(report.notices)) == ([], 1)


def test_a_unit_that_is_gone_is_a_notice_and_one_beside_a_pure_number_is_found(book):
    report = beside(book, "speed", 1, None)
    assert (report.findings, len(report.notices)) == ([], 1)
    assert spots(beside(book, "eta", 1, "kNm").findings) == {"Drive!E16"}
    silent(beside(book, "eta", 1, "ask Rossi"))


def test_the_unit_of_a_column_counts(book):
    def change(workbook):
        book.cell(workbook, "cycle", -1, 1).value = "y [m]"

    assert len(book.edited(change).findings) == 1


@pytest.mark.parametrize("column", [-2, -1])
def test_labels_and_symbols_that_changed_places_are_found(column, book):
    def change(workbook):
        one, other = (book.cell(workbook, block, 0, column) for block in ("peak", "least"))
        one.value, other.value = other.value, one.value

    assert len(book.edited(change).findings) == 2


@pytest.mark.parametrize("words", ["Largest torque x10", "Largest torque [%]", "Largest torque: OK"])
def test_a_label_with_other_figures_is_found_and_a_translated_one_is_a_notice(words, book):
    assert beside(book, "peak", -2, words).findings
    report = beside(book, "peak", -2, "Größtes Drehmoment")
    assert (report.findings, len(report.notices)) == ([], 1)


def test_headings_that_changed_places_are_found(book):
    def change(workbook):
        one, other = (workbook["Drive"].cell(row, 2) for row in (6, 11))
        assert {one.value, other.value} == {"Entries", "Results"}
        one.value, other.value = other.value, one.value

    assert book.edited(change).findings


def test_a_book_in_another_language_is_listed_and_agrees(book):
    def change(workbook):
        for sheet in book.book.sheets:
            for text in sheet.texts:
                cell = workbook[sheet.title].cell(text.row, text.column)
                if text.style in ("label", "header", "heading", "subheading") and cell.value:
                    cell.value = f"«{cell.value}»"

    report = book.edited(change)
    assert report.findings == []
    assert len(report.notices) > 20


# looks of cells


UNREADABLE = {
    "white": {"font": Font(color="FFFFFF"), "fill": PatternFill()},
    "white of the theme": {"font": Font(color=Color(theme=0)), "fill": PatternFill()},
    "in its ground's colour": {"font": Font(color="C00000"), "fill": PatternFill("solid", fgColor="C00000")},
    "in Greek": {"font": Font(name="Calibri", charset=2)},
    "struck": {"font": Font(name="Calibri", strike=True)},
    "crossed out": {"border": Border(diagonal=Side("thick"), diagonalUp=True, diagonalDown=True)},
}


def dress(cell, look):
    for name, value in look.items():
        setattr(cell, name, value)


@pytest.mark.parametrize("look", UNREADABLE.values(), ids=UNREADABLE)
@pytest.mark.parametrize(("block", "column"), [("peak", 0), ("peak", 1), ("peak", -1), ("peak", -2), ("within", 0),
                                               ("overall", 0), ("which", 0)])  # fmt: skip
def test_a_figure_a_verdict_or_what_it_is_called_that_cannot_be_read_is_found(look, block, column, book):
    def made(workbook):
        if column == 0:
            without_rules(workbook["Drive"], workbook["Checks"])
        dress(book.cell(workbook, block, 0, column), look)

    assert spots(book.edited(made).findings) == {spot(book, block, column)}


def spot(book, block, column=0):
    row, first = book.at(block)
    return f"{book.book.blocks[block].sheet.title}!{chr(64 + first + column)}{row}"


def without_rules(*sheets):
    for sheet in sheets:
        sheet.conditional_formatting = type(sheet.conditional_formatting)()


def test_a_look_of_many_cells_is_told_once(book):
    def made(workbook):
        for row in range(5):
            book.cell(workbook, "cycle", row, 1).font = Font(strike=True)

    (found,) = book.edited(made).findings
    assert found.what.endswith(", 5 cells")


def test_a_part_of_a_text_in_another_font_is_told(book):
    for font in (b'<color rgb="FFFFFFFF"/>', b"<strike/>", b'<rFont val="Symbol"/>'):
        rich = b"<si><r><t>Largest </t></r><r><rPr>%s</rPr><t>torque</t></r></si>" % font
        report = book.with_parts({"xl/sharedStrings.xml": sub(rb"<si><t>Largest torque</t></si>", rich)})
        assert (report.findings, spots(report.notices)) == ([], {"Drive!B14"})


@pytest.mark.parametrize("colour", [Color(indexed=17), Color(theme=1), Color(theme=4, tint=0.4)])
def test_a_colour_of_a_palette_or_theme_on_a_verdict_is_found(colour, failing):
    def made(workbook):
        without_rules(workbook["Drive"])
        failing.cell(workbook, "within").font = Font(color=colour)

    assert spots(failing.edited(made).findings) == {"Drive!D18"}


# what is out of sight


def dimensions(sheet, row, column):
    return sheet.row_dimensions[row], sheet.column_dimensions[get_column_letter(column)]


def frozen_out(sheet, row, column):
    sheet.freeze_panes = f"A{row + 5}"
    sheet.sheet_view.topLeftCell = f"A{row + 1}"


HIDING = {
    "row": lambda *at: setattr(dimensions(*at)[0], "hidden", True),
    "flat row": lambda *at: setattr(dimensions(*at)[0], "height", 0.5),
    "column": lambda *at: setattr(dimensions(*at)[1], "hidden", True),
    "narrow column": lambda *at: setattr(dimensions(*at)[1], "width", 0.1),
    "columns of a group": lambda sheet, row, column: sheet.column_dimensions.group("B", "Z", hidden=True),
    "frozen out": frozen_out,
}


@pytest.mark.parametrize("hide", HIDING.values(), ids=HIDING)
def test_a_failing_check_and_the_overall_verdict_out_of_sight_are_found(hide, book, failing):
    for one, block in ((failing, "within"), (book, "overall"), (book, "status1")):
        title, at = one.book.blocks[block].sheet.title, one.at(block)
        report = one.edited(lambda workbook, title=title, at=at: hide(workbook[title], *at))
        assert {found.sheet for found in report.findings} == {title}
        assert all(found.computed.startswith("hidden by") for found in report.findings)


def test_the_first_row_and_column_that_can_be_scrolled_to_are_in_sight():
    sheet = Workbook().active
    sheet.freeze_panes, sheet.sheet_view.topLeftCell = "B2", "D6"
    places = ((6, 4), (5, 4), (6, 3))
    assert [SheetView(sheet).hidden_by(*at)[:12] for at in places] == ["", "a hidden or ", "a hidden or "]


@pytest.mark.parametrize("state", ["hidden", "veryHidden"])
def test_a_hidden_sheet_is_a_notice_where_nothing_fails(state, book, failing):
    def change(workbook):
        workbook["Checks"].sheet_state = state

    report = book.edited(change)
    assert (report.findings, [one.sheet for one in report.notices]) == ([], ["Checks"])
    assert failing.edited(change).findings


@pytest.mark.parametrize(
    ("part", "old", "new", "kind"),
    [
        (DRIVE, rb"<sheetView ", rb'<sheetView showZeros="0" ', "shown"),
        (DRIVE, rb"<sheetView ", rb'<sheetView showFormulas="true" ', "shown"),
        (DRIVE, rb"</sheetView>", rb'</sheetView><sheetView workbookViewId="0" showZeros="0"/>', "shown"),
        (DRIVE, rb"</sheetView>", rb'</sheetView><sheetView workbookViewId="0"/>', "notice"),
        (WORKBOOK, rb"<workbookPr ?/>", rb'<workbookPr date1904="1"/>', "shown"),
        (WORKBOOK, rb"<workbookPr ?/>", rb'<workbookPr showObjects="none"/>', "shown"),
        (WORKBOOK, rb"<workbookPr ?/>", rb'<workbookPr showObjects="placeholders"/>', "shown"),
        (DRIVE, rb"<drawing ", rb'<picture xmlns:r="r" r:id="rId9"/><drawing ', "notice"),
        (DRIVE, rb"<sheetView ", rb'<sheetView showRuler="0" ', ""),
        (DRIVE, rb"<sheetView ", rb'<sheetView zoomScale="70" ', "notice"),
        (DRIVE, rb"<sheetView ", rb'<sheetView showZeros="1" showFormulas="0" ', ""),
        (DRIVE, rb"<sheetView ", rb'<sheetView view="pageBreakPreview" ', ""),
    ],
)  # fmt: skip
def test_settings_of_views_and_windows(part, old, new, kind, book):
    report = book.with_parts({part: sub(old, new)})
    assert {one.kind for one in report.findings} == ({"shown"} if kind == "shown" else set())
    assert bool(report.notices) == (kind == "notice" or b"/><sheetView" in new or b"><sheetView" in new)


def test_a_print_area_without_the_verdict_and_links_that_lead_elsewhere_are_notices(book):
    def printed(workbook):
        workbook["Drive"].print_area = "A20:F30"

    def linked(workbook):
        book.cell(workbook, "which").hyperlink = "https://example.org"

    def exchanged(workbook):
        first, second = (c for row in workbook["Drive"] for c in row if c.hyperlink and c.value == "to its sheet")
        first.hyperlink.location, second.hyperlink.location = second.hyperlink.location, first.hyperlink.location

    for change in (printed, linked, exchanged):
        report = book.edited(change)
        assert report.findings == []
        assert report.notices


# verdicts

GREEN = {"font": Font(color="006100"), "fill": PatternFill(bgColor="C6EFCE", fill_type="solid")}


@pytest.mark.parametrize(
    ("rule", "bad"),
    [
        (CellIsRule(operator="equal", formula=['"FAIL"'], **GREEN), True),
        (CellIsRule(operator="notEqual", formula=['"OK"'], **GREEN), True),
        (FormulaRule(formula=["TRUE"], **GREEN), True),
        (FormulaRule(formula=['D18="FAIL"'], **GREEN), True),
        (FormulaRule(formula=['$B$90="OK"'], **GREEN), True),
        (Rule(type="containsText", operator="containsText", text="fail", formula=['NOT(ISERROR(SEARCH("fail",A1)))'],
              dxf=DifferentialStyle(**GREEN)), True),
        (Rule(type="notContainsBlanks", formula=["LEN(TRIM(A1))>0"], dxf=DifferentialStyle(**GREEN)), True),
        (CellIsRule(operator="equal", formula=['"FAIL"'], font=Font(color="00B050")), True),
        (FormulaRule(formula=["TRUE"], fill=PatternFill("lightGrid", bgColor="00B050")), True),
        (FormulaRule(formula=["TRUE"], fill=GradientFill(stop=("00B050", "00B050"))), True),
        (FormulaRule(formula=["TRUE"], font=Font(strike=True)), True),
        (FormulaRule(formula=["TRUE"], font=Font(color="FFFFFF"), fill=PatternFill(bgColor="FFFFFF",
                                                                                fill_type="solid")), True),
        (CellIsRule(operator="equal", formula=['"OK"'], **GREEN), True),
        (CellIsRule(operator="equal", formula=['"OK"']), True),
    ],
)  # fmt: skip
def test_a_rule_that_recolours_a_verdict_is_found_whether_it_fails_now_or_not(rule, bad, book, failing):
    for one in (book, failing):
        assert spot(one, "within") == "Drive!D18"

        def change(workbook, one=one):
            without_rules(workbook["Drive"])
            workbook["Drive"].conditional_formatting.add("D18", copy.copy(rule))

        assert spots(one.edited(change).findings) == ({"Drive!D18"} if bad else set())


@pytest.mark.parametrize("fill", [PatternFill("solid", fgColor="92D050"), PatternFill("lightGrid", fgColor="00B050"),
                                  GradientFill(stop=("00B050", "00B050"))])  # fmt: skip
def test_a_fail_painted_green_is_found(fill, failing):
    def painted(workbook):
        failing.cell(workbook, "within").fill = fill

    def bare(workbook):
        without_rules(workbook["Drive"])
        painted(workbook)

    assert spots(failing.edited(bare).findings) == {"Drive!D18"}
    assert spots(failing.edited(painted).findings) == {"Drive!D18"}


def test_bars_and_icons_instead_of_a_number_are_found_and_beside_it_are_not(book):
    def change(rule, shown):
        def made(workbook):
            sign = rule.dataBar or rule.iconSet
            sign.showValue = shown
            workbook["Drive"].conditional_formatting.add("D14", rule)

        return made

    icons = IconSetRule("3TrafficLights1", "percent", [0, 33, 67])
    bars = DataBarRule(start_type="min", end_type="max", color="638EC6")
    for rule in (icons, bars):
        assert spots(book.edited(change(rule, False)).findings) == {"Drive!D14"}
        assert book.edited(change(rule, True)).findings == []


def test_rules_of_the_book_that_are_gone_are_a_notice_and_a_rule_for_rows_spread_over_figures_is_found(book):
    report = book.edited(lambda workbook: without_rules(workbook["Drive"]))
    assert report.findings == []
    assert {one.what for one in report.notices if one.computed == "no such rule"}

    def spread(workbook):
        rules = workbook["Drive"].conditional_formatting
        blank = next(one for area in rules for one in area.rules if one.type == "expression")
        rules.add("D12:D14", blank)

    assert book.edited(spread).findings


@pytest.mark.parametrize("other", ["TRUE", "$B24<300", "$B25>300", "$K24>300"])
def test_another_condition_for_rows_that_show_nothing_is_found(other, book):
    def change(workbook):
        rules = (rule for area in workbook["Drive"].conditional_formatting for rule in area.rules)
        (blank,) = (rule for rule in rules if rule.type == "expression")
        assert blank.formula == ["$B24>300"]
        blank.formula = [other]

    assert spots(book.edited(change).findings) == {"Drive!B24"}  # and what is alike beside it


def test_validations_removed_or_changed_are_a_notice(book):
    def removed(workbook):
        workbook["Drive"].data_validations.dataValidation = []

    def changed(workbook):
        workbook["Drive"].data_validations.dataValidation[0].prompt = "Enter it in inches."

    for change in (removed, changed):
        report = book.edited(change)
        assert (report.findings, {one.sheet for one in report.notices}) == ([], {"Drive"})


# charts


def drawn(book, *changes):
    return book.with_parts({CHART: lambda data: one_after_the_other(data, changes)})


def one_after_the_other(data, changes):
    for change in changes:
        data = sub(*change)(data)
    return data


Y = rb"'Drive'!\$C\$24:\$C\$36"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (Y, b"'Drive'!$D$24:$D$36"), (Y, b"'Drive'!$C$24:$C$35"), (Y, b"'Checks'!$C$24:$C$36"),
        (rb'<max val="360"', b'<max val="36"'), (rb'<min val="0"', b'<min val="180"'),
        (rb'val="minMax"', b'val="maxMin"'), (rb"<scaling>", b'<scaling><logBase val="10"/>'),
        (rb'formatCode="General" sourceLinked', b'formatCode="0&quot;0&quot;" sourceLinked'),
        (rb"<crossAx ", b'<dispUnits><builtInUnit val="thousands"/></dispUnits><crossAx '), (rb"y \[mm\]", b"y [m]"),
        (rb">Both<", b">Velocity alone<"), (rb">Both<", b">Both, 10 times<"),
    ],
)  # fmt: skip
def test_a_chart_that_shows_something_else_is_found(old, new, book):
    assert spots(drawn(book, (old, new)).findings) == {"Drive!B38"}


def in_ink(colour):
    return b"<txPr><p><pPr><defRPr><solidFill>%s</solidFill></defRPr></pPr></p></txPr>" % colour


def test_hidden_rows_that_a_chart_leaves_out_are_found(book):
    rows = {DRIVE: sub(rb'<row r="30"', b'<row r="30" hidden="1"')}
    assert book.with_parts(rows).findings == []
    found = book.with_parts(rows | {CHART: sub(rb'plotVisOnly val="0"', b'plotVisOnly val="1"')}).findings
    assert any("hidden rows" in str(one.computed) for one in found)


def test_another_line_under_a_declared_name_is_found_and_one_of_its_own_is_taste(book):
    def change(workbook, name=""):
        chart = workbook["Drive"]._charts[1]
        line = copy.deepcopy(chart.series[0])
        line.yVal.numRef.f = "Drive!$A$1:$A$3"
        if name:
            line.tx.strRef, line.tx.v = None, name
        chart.series.append(line)

    assert {one.kind for one in book.edited(change).findings} == {"shown"}
    assert book.edited(lambda workbook: change(workbook, "measured")).findings == []


# what lies over a verdict


@pytest.mark.parametrize("block", ["within", "overall"])
def test_a_chart_over_a_verdict_is_found_and_beside_it_is_taste(block, failing):
    row, column = failing.at(block)

    def over(workbook, right=0):
        chart = ScatterChart()
        ends = [AnchorMarker(col=column + right + n, row=row + n) for n in (-1, 0)]
        chart.anchor = TwoCellAnchor(_from=ends[0], to=ends[1])
        workbook[failing.book.blocks[block].sheet.title].add_chart(chart, chart.anchor)

    assert spots(failing.edited(over).findings) == {spot(failing, block)}
    silent(failing.edited(lambda workbook: over(workbook, right=1)))


ALTERNATIVE = (
    b'<mc:AlternateContent xmlns:mc="http://schemas.openxmlformats.org/markup-compatibility/2006">'
    b'<mc:Choice Requires="x">%s</mc:Choice></mc:AlternateContent>'
)


def shape_over(book, size, fill=b"<noFill/>", text=b"", within=b"%s", block="within", beside=0):
    """A shape on the cell of a block, or beside it, by its size in EMU."""
    row, column = book.at(block, 0, beside)
    shape = (
        b"<xdr:oneCellAnchor><xdr:from><xdr:col>%d</xdr:col><xdr:colOff>0</xdr:colOff><xdr:row>%d</xdr:row>"
        b"<xdr:rowOff>0</xdr:rowOff></xdr:from><xdr:ext %s/><xdr:sp><xdr:spPr>%s</xdr:spPr>"
        b"<xdr:txBody><xdr:t>%s</xdr:t></xdr:txBody></xdr:sp></xdr:oneCellAnchor>"
    ) % (column - 1, row - 1, size, fill, text)
    return {PICTURE: sub(rb"(?=</xdr:wsDr>)", within % shape)}


@pytest.mark.parametrize(
    ("size", "look", "hides"),
    [
        (900_000, {"fill": b"<solidFill/>"}, True), (900_000, {"fill": b""}, True), (900_000, {}, False),
        (9_000, {"fill": b""}, False), (900_000, {"text": b"OK"}, True),
        (900_000, {"fill": b"<solidFill/>", "within": ALTERNATIVE}, True),
    ],
)  # fmt: skip
def test_a_shape_over_a_verdict_is_found_if_it_hides_it(size, look, hides, failing):
    report = failing.with_parts(shape_over(failing, b'cx="%d" cy="%d"' % (size, size), **look))
    assert ("Drive!D18" in spots(report.findings)) is hides


def test_a_drawing_that_is_none_is_refused(book):
    link = {RELS: sub(rb"drawings/\w+\.xml", b"drawings/a.bin")}
    with pytest.raises(ReadError, match="damaged"):
        book.with_parts(link, [("xl/drawings/a.bin", b"no drawing")])


@pytest.mark.parametrize(("state", "found"), [(b"visible", {"Drive!D18"}), (b"hidden", set())])
def test_a_note_always_shown_over_a_verdict_is_found(state, found, failing):
    row, column = failing.at("within")
    vml = (
        b'<xml xmlns:v="v" xmlns:x="x"><v:shape style="visibility:%s"><x:ClientData><x:Anchor>'
        b"%d, 0, %d, 0, %d, 0, %d, 0</x:Anchor></x:ClientData></v:shape></xml>"
    ) % (state, column - 1, row - 1, column + 2, row + 2)
    link = b'<Relationship Id="n" Type="http://x/vmlDrawing" Target="/xl/drawings/v.vml"/></Relationships>'
    report = failing.with_parts({RELS: sub(rb"</Relationships>", link)}, [("xl/drawings/v.vml", vml)])
    assert spots(report.findings) == found


def test_charts_that_are_gone_hidden_or_moved(book):
    gone = {PICTURE: sub(rb"<xdr:oneCellAnchor>.*?</xdr:oneCellAnchor>", b"")}
    hidden = {PICTURE: sub(rb'<xdr:cNvPr id="1"', b'<xdr:cNvPr hidden="1" id="1"')}
    for change in (gone, hidden):
        report = book.with_parts(change)
        assert (report.findings, [one.expected for one in report.notices]) == ([], ["Both"])
    moved = {PICTURE: sub(rb"<xdr:row>\d+</xdr:row>", b"<xdr:row>90</xdr:row>", count=2)}
    silent(book.with_parts(moved))


# parts of the file format that no list had named


def told(report):
    return report.findings + report.notices


@pytest.mark.parametrize("text", ["Largest" + 30 * " " + "torque", 12 * "\n" + "Largest torque"])
def test_a_label_pushed_out_of_its_cell_by_blanks_is_told(text, book):
    def change(workbook):
        book.cell(workbook, "peak", 0, -2).value = text

    assert spots(told(book.edited(change))) == {"Drive!B14"}


def test_a_figure_merged_into_its_label_is_told(book):
    assert told(book.edited(lambda workbook: workbook["Drive"].merge_cells("B14:D14")))


@pytest.mark.parametrize("column", [1, -1, -2])
def test_a_shape_over_a_unit_a_symbol_or_a_label_is_told(column, book):
    shape = shape_over(book, b'cx="4000000" cy="300000"', text=b"kNm", block="peak", beside=column)
    assert any("drawing" in str(one.computed) for one in told(book.with_parts(shape)))


def test_a_table_over_figures_whose_style_may_colour_them_is_told(book):
    def change(workbook):
        table = Table(displayName="T", ref="B23:D36")
        table.tableStyleInfo = TableStyleInfo(name="Own")
        workbook["Drive"].add_table(table)

    assert told(book.edited(change))


def first_of_all(look, stop):
    rule = FormulaRule(formula=["TRUE"], stopIfTrue=stop)
    rule.dxf, rule.priority = look, 1
    return rule


def test_a_rule_that_stops_the_red_of_a_fail_on_green_is_found(failing):
    def change(workbook):
        cell = failing.cell(workbook, "within")
        cell.fill = PatternFill("solid", fgColor="92D050")
        workbook["Drive"].conditional_formatting.add(cell.coordinate, first_of_all(DifferentialStyle(), stop=True))

    assert spots(failing.edited(change).findings) == {"Drive!D18"}


LABELS = b"<dLbls><numFmt formatCode='%s' sourceLinked='0'/><showVal val='1'/></dLbls><xVal>"
POINT = b"<dPt><idx val='3'/><spPr><a:ln><a:noFill/></a:ln></spPr></dPt><xVal>"
GROUND = b'<spPr><solidFill><srgbClr val="0072B2"/></solidFill></spPr></plotArea>'
LARGE = b'<legendPos val="b"/><layout><manualLayout><w val="0.9"/><h val="0.9"/></manualLayout></layout>'
STROKES = b"<errBars><errDir val='y'/><errBarType val='both'/><errValType val='stdErr'/></errBars><xVal>"


@pytest.mark.parametrize(
    ("part", "old", "new"),
    [
        (CHART, rb"<xVal>", LABELS % b'0.0"0"'), (CHART, rb"<xVal>", POINT), (CHART, rb"<xVal>", STROKES),
        (CHART, rb"<w val=\"[0-9.]*\"", b'<w val="0.01"'),
        (CHART, rb'<dispBlanksAs val="gap"', b'<dispBlanksAs val="zero"'),
        (CHART, rb'sz="1000"', b'sz="100"'), (CHART, rb'sz="1000"', b'sz="1000" strike="sngStrike"'),
        (CHART, rb"<a:defRPr ([^>]*)/>", rb'<a:defRPr \1><a:latin typeface="Wingdings"/></a:defRPr>'),
        (CHART, rb"</plotArea>", GROUND),
        (CHART, rb'<srgbClr val="0072B2"|<a:srgbClr val="0072B2"', b'<a:srgbClr val="FFFFFF"'),
        (CHART, rb"<plotVisOnly", b"<view3D/><plotVisOnly"),
        (CHART, rb"<crossAx ", in_ink(b'<srgbClr val="FFFFFF"/>') + b"<crossAx "),
        (CHART, rb"<crossAx ", in_ink(b'<schemeClr val="bg1"/>') + b"<crossAx "),
        (CHART, rb"</plotArea>", b"</plotArea><legend>" + LARGE + b"</legend>"),
        (CHART, rb"</chartSpace>", b'<userShapes id="x"/></chartSpace>'),
        (DRIVE, rb"<sheetView ", b'<sheetView view="pageLayout" zoomScalePageLayoutView="10" '),
        (DRIVE, rb"<oddFooter>.*?</oddFooter>", b"<oddFooter>&amp;CAll checks: OK</oddFooter>"),
        (DRIVE, rb"<drawing ", b'<legacyDrawingHF xmlns:r="r" r:id="rId9"/><drawing '),
        (DRIVE, rb"</worksheet>", b"<extLst><ext uri='x'><slicerList/></ext></extLst></worksheet>"),
        ("xl/workbook.xml", rb'minimized="0"', b'minimized="1"'),
    ],
)  # fmt: skip
def test_parts_of_charts_and_sheets_that_are_read_otherwise_are_told(part, old, new, book):
    assert told(book.with_parts({part: sub(old, new)}))


@pytest.mark.parametrize("code", ["0.0", "General"])
def test_values_beside_the_points_of_a_chart_are_a_notice(code, book):
    report = book.with_parts({CHART: sub(rb"<xVal>", LABELS % code.encode())})
    assert (report.findings, spots(report.notices)) == ([], {"Drive!B38"})


# names of sheets


def renamed(book, names):
    """What is told where sheets have other names, which formulas and charts follow, as where a program renames them."""

    def change(data):
        for old in names:
            data = data.replace(f"'{old}'!".encode(), f"'@{old}'!".encode())
            data = data.replace(f'name="{old}" sheetId'.encode(), f'name="@{old}" sheetId'.encode())
        for old, new in names.items():
            data = data.replace(f"@{old}".encode(), new.encode())
        return data

    return book.with_parts({name: change for name, data in book.parts.items() if change(data) != data})


def test_names_of_two_sheets_exchanged_are_found_and_another_name_is_a_notice(failing):
    findings = renamed(failing, {"Drive": "Checks", "Checks": "Drive"}).findings
    assert {(one.kind, f"{one.sheet}!{one.cell}") for one in findings} == {
        ("shown", "Drive!A1"),
        ("shown", "Checks!A1"),
    }
    report = renamed(failing, {"Drive": "Other"})
    assert (report.findings, [(one.sheet, one.computed) for one in report.notices]) == ([], [("Other", "Other")])


# taste


def test_a_thousand_rules_of_ones_own_are_told_in_few_lines(book):
    def change(workbook):
        for n in range(1000):
            look = {"font": Font(color="1F3864"), "fill": PatternFill(bgColor="FFF2CC", fill_type="solid")}
            workbook["Drive"].conditional_formatting.add(
                f"A{n % 9 + 20}:Z{n + 100}", FormulaRule(formula=["A1>1"], **look)
            )

    report = book.edited(change)
    assert [one.what for one in report.findings + report.notices if "conditional" not in one.what] == []
    assert len(report.findings + report.notices) < 10
