"""Forgeries of display by parts of the file format that no list of them had named: each is told of."""

import pytest
from openpyxl.formatting.rule import FormulaRule
from openpyxl.styles import Alignment, Border, Font, PatternFill, Side
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.worksheet.table import Table, TableStyleInfo

from tests.workbook.judging.hands import sub
from tests.workbook.judging.synthetic import Small, spots

SHEET, CHART, PICTURE = "xl/worksheets/sheet1.xml", "xl/charts/chart1.xml", "xl/drawings/drawing1.xml"


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    return Small(tmp_path_factory.mktemp("forged"))


@pytest.fixture(scope="module")
def failing(tmp_path_factory):
    return Small(tmp_path_factory.mktemp("failing"), limit=5.0)


def told(report):
    return report.findings + report.notices


def crossed(cell):
    cell.border = Border(diagonal=Side("thick"), diagonalUp=True, diagonalDown=True)


def huge(cell):
    cell.font = Font(name="Calibri", sz=400)


def foreign_digits(cell):
    cell.number_format = "[$-2000401]0.00"


def pushed_aside(cell):
    cell.alignment = Alignment(horizontal="right", relativeIndent=200)


@pytest.mark.parametrize("change", [crossed, huge, foreign_digits, pushed_aside])
@pytest.mark.parametrize("block", ["peak", "omega"])
def test_a_figure_crossed_out_too_large_in_other_digits_or_pushed_aside_is_told(change, block, book):
    assert told(book.edited(lambda workbook: change(book.cell(workbook, block))))


@pytest.mark.parametrize("text", ["Largest" + 30 * " " + "torque", 12 * "\n" + "Largest torque"])
def test_a_label_pushed_out_of_its_cell_by_blanks_is_told(text, book):
    def change(workbook):
        book.cell(workbook, "peak", 0, -2).value = text

    assert spots(told(book.edited(change))) == {"Drive!B14"}


def test_a_figure_merged_into_its_label_is_told(book):
    assert told(book.edited(lambda workbook: workbook["Drive"].merge_cells("B14:D14")))


def test_a_font_that_the_theme_may_exchange_is_told(book):
    def change(workbook):
        book.cell(workbook, "peak").font = Font(name="Calibri", scheme="minor")

    assert spots(told(book.edited(change))) == {"Drive!D14"}


@pytest.mark.parametrize("column", [1, -1, -2])
def test_a_shape_over_a_unit_a_symbol_or_a_label_is_told(column, book):
    row, first = book.at("peak")
    place = (
        b"<xdr:oneCellAnchor><xdr:from><xdr:col>%d</xdr:col><xdr:colOff>0</xdr:colOff>"
        b"<xdr:row>%d</xdr:row><xdr:rowOff>0</xdr:rowOff></xdr:from>"
        b'<xdr:ext cx="4000000" cy="300000"/><xdr:sp>'
        b"<xdr:txBody><xdr:t>kNm</xdr:t></xdr:txBody></xdr:sp></xdr:oneCellAnchor></xdr:wsDr>"
    ) % (first + column - 1, row - 1)
    report = book.with_parts({PICTURE: lambda data: data.replace(b"</xdr:wsDr>", place)})
    assert any("drawing" in str(one.computed) for one in told(report))


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


def test_a_rule_that_writes_in_signs_or_struck_out_is_told(book):
    for font in (Font(name="Wingdings"), Font(strike=True), Font(vertAlign="superscript")):
        look = DifferentialStyle(font=font)

        def change(workbook, look=look):
            workbook["Drive"].conditional_formatting.add("D14", first_of_all(look, stop=False))

        assert spots(told(book.edited(change))) == {"Drive!D14"}


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
        (CHART, rb"</plotArea>", b"</plotArea><legend>" + LARGE + b"</legend>"),
        (CHART, rb"</chartSpace>", b'<userShapes id="x"/></chartSpace>'),
        (SHEET, rb"<sheetView ", b'<sheetView view="pageLayout" zoomScalePageLayoutView="10" '),
        (SHEET, rb"<oddFooter>.*?</oddFooter>", b"<oddFooter>&amp;CAll checks: OK</oddFooter>"),
        (SHEET, rb"<drawing ", b'<legacyDrawingHF xmlns:r="r" r:id="rId9"/><drawing '),
        (SHEET, rb"</worksheet>", b"<extLst><ext uri='x'><slicerList/></ext></extLst></worksheet>"),
        ("xl/workbook.xml", rb'minimized="0"', b'minimized="1"'),
    ],
)  # fmt: skip
def test_parts_of_charts_and_sheets_that_are_read_otherwise_are_told(part, old, new, book):
    assert told(book.with_parts({part: sub(old, new)}))


@pytest.mark.parametrize("code", ["0.0", "General"])
def test_values_beside_the_points_of_a_chart_are_a_notice(code, book):
    report = book.with_parts({CHART: sub(rb"<xVal>", LABELS % code.encode())})
    assert (report.findings, spots(report.notices)) == ([], {"Drive!B38"})
