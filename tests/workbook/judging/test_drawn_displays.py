"""Changes of display drawn from the file format's own vocabulary: what alters what is read never passes in silence.

300 changes, one at a time, each to a copy of a small book: 200 that alter what is read, 100 of taste; by day half.
"""

import random
from itertools import cycle, islice

import pytest
from openpyxl.comments import Comment
from openpyxl.formatting.rule import FormulaRule
from openpyxl.styles import Alignment, Border, Font, GradientFill, PatternFill, Side
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.styles.numbers import NumberFormat

from tests.workbook.judging.hands import sub
from tests.workbook.judging.synthetic import Small

SEED = 1904
CELLS = ("peak", "least", "speed", "omega", "limit", "rate")
DATES = ("d", "dd", "ddd", "dddd", "m", "mm", "mmm", "mmmm", "mmmmm", "yy", "yyyy", "h", "hh", "s", "ss", "s.00", "[h]",
         "[mm]", "[ss]", "AM/PM", "b", "bb", "g", "gg", "ge", "e", "A/P")  # fmt: skip
PATTERNS = ("darkDown", "darkGray", "darkGrid", "darkHorizontal", "darkTrellis", "darkUp", "darkVertical", "gray0625",
            "gray125", "lightDown", "lightGray", "lightGrid", "lightHorizontal", "lightTrellis", "lightUp",
            "lightVertical", "mediumGray")  # fmt: skip
SHEET, BOOK, CHART = "xl/worksheets/sheet1.xml", "xl/workbook.xml", "xl/charts/chart1.xml"
KINDS = ("areaChart", "area3DChart", "lineChart", "line3DChart", "stockChart", "radarChart", "pieChart", "pie3DChart",
         "doughnutChart", "barChart", "bar3DChart", "ofPieChart", "surfaceChart", "surface3DChart",
         "bubbleChart")  # fmt: skip
SCALES = ("hundreds", "thousands", "tenThousands", "hundredThousands", "millions", "tenMillions", "hundredMillions",
          "billions", "trillions")  # fmt: skip
TRENDS = ("exp", "linear", "log", "movingAvg", "poly", "power")


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    return Small(tmp_path_factory.mktemp("drawn"))


def digits(drawn):
    return drawn.choice(("0", "#,##0", "00")) + drawn.choice(("", ".0", ".00", ".0##", ".000000"))


def another_number(drawn):
    """A number format that shows another number, or none."""
    number = digits(drawn)
    return drawn.choice((
        lambda: drawn.choice(DATES), lambda: f"{drawn.choice(DATES)}:{drawn.choice(DATES)}",
        lambda: number + "," * drawn.randint(1, 3), lambda: number + "%" * drawn.randint(1, 2),
        lambda: number + f'"{drawn.choice("0123456789kMGmµ%‰٣९x×")}"',
        lambda: f'"{drawn.choice("123456789-−(xk")}"' + number,
        lambda: number + f"\\{drawn.choice('0123456789kM')}", lambda: f"*{drawn.choice('-123456789x')}{number}",
        lambda: number + f'" {drawn.choice(("kNm", "mNm", "million", "Tsd.", "dozen", "lbf", "OK", "FAIL"))}"',
        lambda: f"{number};{number}", lambda: f"{number};;{number}", lambda: ";" * drawn.randint(1, 3),
        lambda: f'"{drawn.choice(("OK", "7", "12.5", "–"))}"',
        lambda: f"[{drawn.choice(('White', 'Yellow', 'Cyan'))}]{number}",
        lambda: f"[>={drawn.randint(-9, 9)}]\"7\";{number}", lambda: f"[DBNum{drawn.randint(1, 3)}]{number}",
        lambda: f"[$€-407]{number}", lambda: f"0\\.{number}", lambda: f"-{number}",
    ))()  # fmt: skip


def formats(drawn):
    code, block = another_number(drawn), drawn.choice(CELLS)
    return f"{block} by {code}", lambda book, workbook: setattr(book.cell(workbook, block), "number_format", code)


def fonts(drawn):
    look = drawn.choice((
        {"strike": True}, {"outline": True}, {"shadow": True}, {"condense": True}, {"extend": True},
        {"vertAlign": drawn.choice(("superscript", "subscript"))}, {"sz": drawn.choice((1, 2, 3, 3.5, 5))},
        {"name": drawn.choice(("Wingdings", "Wingdings 2", "Webdings", "Symbol", "Marlett", "OpenSymbol"))},
        {"charset": 2}, {"name": drawn.choice(("Zapfino", "Bar-Code 39", "Blank"))},
        {"color": f"{drawn.randint(235, 255):02X}" * 3},
    ))  # fmt: skip
    block, column = drawn.choice((*CELLS, "eta", "which")), drawn.choice((0, 0, -1, -2))
    column = -2 if block == "which" else column
    return f"{block} {column} {look}", lambda book, workbook: dressed(book, workbook, block, column, font=Font(**look))


def dressed(book, workbook, block, column, **look):
    for name, value in look.items():
        setattr(book.cell(workbook, block, 0, column), name, value)


def fills(drawn):
    dark = f"{drawn.randint(28, 40):02X}" * 3
    fill = drawn.choice((
        PatternFill(drawn.choice(PATTERNS), fgColor="00B050"), PatternFill("solid", fgColor=dark),
        GradientFill(degree=drawn.randint(0, 90), stop=("00B050", "FFFFFF")),
        GradientFill(type="path", stop=("FFFFFF", "000000")),
    ))  # fmt: skip
    block = drawn.choice(CELLS[:4])
    return f"{block} on {type(fill).__name__}", lambda book, workbook: dressed(book, workbook, block, 0, fill=fill)


def alignments(drawn):
    look = drawn.choice((
        {"horizontal": drawn.choice(("fill", "distributed", "justify"))}, {"indent": drawn.randint(16, 250)},
        {"textRotation": drawn.choice((1, 45, 90, 91, 180, 255))}, {"readingOrder": 2}, {"shrink_to_fit": True},
    ))  # fmt: skip
    block = drawn.choice(CELLS)
    return f"{block} {look}", lambda book, workbook: dressed(book, workbook, block, 0, alignment=Alignment(**look))


def rules(drawn):
    look = drawn.choice((
        {"numFmt": NumberFormat(numFmtId=300, formatCode=another_number(drawn))}, {"font": Font(strike=True)},
        {"font": Font(color="FFFFFF")}, {"fill": PatternFill(bgColor="1F2937", fill_type="solid")},
        {"fill": PatternFill(drawn.choice(PATTERNS), bgColor="00B050")},
    ))  # fmt: skip
    block, condition = drawn.choice(CELLS[:4]), drawn.choice(("TRUE", "FALSE", "$A$1=7", "ROW()>3"))

    def change(book, workbook):
        rule = FormulaRule(formula=[condition])
        rule.dxf = DifferentialStyle(**look)
        workbook["Drive"].conditional_formatting.add(book.cell(workbook, block).coordinate, rule)

    return f"{block} if {condition}", change


def views(drawn):
    return drawn.choice((
        (SHEET, rb"<sheetView ", b'<sheetView showZeros="0" '),
        (SHEET, rb"<sheetView ", b'<sheetView showFormulas="1" '),
        (SHEET, rb"<sheetView ", b'<sheetView rightToLeft="true" '),
        (SHEET, rb"<sheetView ", b'<sheetView zoomScale="10" '),
        (SHEET, rb"</sheetView>", b'</sheetView><sheetView workbookViewId="0"/>'),
        (SHEET, rb'ySplit="3"', b'ySplit="99"'),
        (SHEET, rb"<sheetFormatPr ", b'<sheetFormatPr zeroHeight="1" '),
        (SHEET, rb'<row r="14"', b'<row r="14" hidden="1"'),
        (SHEET, rb'<row r="14"', b'<row r="14" ht="0.5" customHeight="1"'),
        (SHEET, rb'width="3[0-9.]+"', b'width="0.2"'),
        (BOOK, rb"<workbookPr", b'<workbookPr date1904="1"'),
        (BOOK, rb"<workbookPr", b'<workbookPr showObjects="none"'),
        (BOOK, rb'showSheetTabs="1"', b'showSheetTabs="0"'),
        (BOOK, rb'visibility="visible"', b'visibility="veryHidden"'),
        (BOOK, rb'state="visible"', b'state="hidden"'),
    ))  # fmt: skip


def charts(drawn):
    kind, scale, trend = drawn.choice(KINDS), drawn.choice(SCALES), drawn.choice(TRENDS)
    code = drawn.choice((b"0,", b"yyyy", b";;;"))
    return drawn.choice((
        (CHART, rb"(<|</)scatterChart>", rb"\1" + kind.encode() + b">"), (CHART, rb'val="minMax"', b'val="maxMin"'),
        (CHART, rb"<scaling>", b'<scaling><logBase val="%d"/>' % drawn.randint(2, 20)),
        (CHART, rb'<max val="360"', b'<max val="%d"' % drawn.randint(10, 300)),
        (CHART, rb'<delete val="0"', b'<delete val="1"'),
        (CHART, rb'<smooth val="0"', b'<smooth val="1"'), (CHART, rb"<crossAx ", in_units(scale) + b"<crossAx "),
        (CHART, rb"<xVal>", b'<trendline><trendlineType val="%s"/></trendline><xVal>' % trend.encode()),
        (CHART, rb'tickLblPos val="low"', b'tickLblPos val="none"'), (CHART, rb">y \[mm\]<", b">y [inch]<"),
        (CHART, rb"\$C\$24:\$C\$36", b"$C$24:$C$%d" % drawn.randint(25, 35)), (CHART, rb"<ser>.*?</ser>", b""),
        (CHART, rb'formatCode="General" sourceLinked', b'formatCode="%s" sourceLinked' % code),
        (CHART, rb">Both<", b">Velocity alone<"), (CHART, rb"<plotVisOnly", b"<upDownBars/><plotVisOnly"),
    ))  # fmt: skip


def in_units(scale):
    return b'<dispUnits><builtInUnit val="%s"/></dispUnits>' % scale.encode()


def told(book, drawn, kind):
    """Make one change of a kind; return it in words, and what is told of it."""
    if kind in (views, charts, fine_charts):
        part, old, new = kind(drawn)
        count = 0 if b"scatterChart" in old else 1
        return f"{old} -> {new}", book.with_parts({part: sub(old, new, count)})
    words, change = kind(drawn)
    return words, book.edited(lambda workbook: change(book, workbook))


ALTERING = (formats, fonts, fills, alignments, rules, views, charts, formats)


@pytest.mark.sample(4)
@pytest.mark.parametrize("turn", range(8))
def test_none_of_200_changes_that_alter_what_is_read_passes_in_silence(turn, book):
    drawn = random.Random(f"{SEED} {turn}")
    silent = []
    for kind in islice(cycle(ALTERING), 25):
        words, report = told(book, drawn, kind)
        if not report.findings and not report.notices:
            silent.append(words)
    assert silent == []


# taste


def decimals(drawn):
    number = digits(drawn).replace("00.", "0.")
    code = drawn.choice((
        number, f"{number};-{number}", f"{number}_);({number})", f"{number};[Red]-{number}", f"+{number};-{number}",
        f"[{drawn.choice(('Blue', 'Red', 'Black', 'Magenta'))}]{number}", "General", "0.00E+00", "##0.0E+0", "@",
        f"[$-{drawn.choice(('407', '410', '409'))}]{number}", f"_-* {number}_-",
    ))  # fmt: skip
    return code, lambda book, workbook: setattr(book.cell(workbook, drawn.choice(CELLS)), "number_format", code)


def fine_fonts(drawn):
    look = {
        "name": drawn.choice(("Arial", "Calibri", "Times New Roman", "Verdana", "Liberation Sans", "Segoe UI",
        "Cambria")),
        "sz": drawn.choice((7, 8, 9, 10, 12, 16, 24)), "b": drawn.random() < 0.5, "i": drawn.random() < 0.5,
        "u": drawn.choice((None, "single", "double")),
        "color": "".join(f"{drawn.randint(0, 110):02X}" for _ in range(3)),
    }  # fmt: skip
    fill = PatternFill("solid", fgColor="".join(f"{drawn.randint(225, 255):02X}" for _ in range(3)))
    return f"{look}", lambda book, workbook: dressed(
        book, workbook, drawn.choice(CELLS), 0, font=Font(**look), fill=fill
    )


def fine_places(drawn):
    look = Alignment(horizontal=drawn.choice(("left", "right", "center", "general")), indent=drawn.randint(0, 5),
                     vertical=drawn.choice(("top", "center", "bottom")), wrap_text=drawn.random() < 0.5)  # fmt: skip
    line = Side(style=drawn.choice(("thin", "thick", "double", "dotted")), color="FF0000")
    return "places", lambda book, workbook: dressed(
        book, workbook, drawn.choice(CELLS), drawn.choice((-2, -1, 0, 1)), alignment=look,
        border=Border(left=line, right=Side(style="medium")),
    )  # fmt: skip


def fine_sheets(drawn):
    def change(book, workbook):
        for sheet in workbook.worksheets:
            sheet.sheet_view.zoomScale, sheet.sheet_view.showGridLines = drawn.randint(50, 200), drawn.random() < 0.5
            sheet.column_dimensions[drawn.choice("BCDEFG")].width = drawn.randint(6, 60)
            sheet.row_dimensions[drawn.randint(4, 40)].height = drawn.randint(10, 60)
            sheet.freeze_panes = drawn.choice((None, "A5", "C4"))
            sheet.sheet_properties.tabColor = "FF0000"
        workbook["Drive"]["J30"] = "my note"
        workbook["Drive"]["J31"] = 12.5
        workbook["Drive"]["B14"].comment = Comment("seen by the author", "me")
        workbook.create_sheet("My own")["A1"] = "=1+1"

    return "sheets", change


def fine_words(drawn):
    texts = {"speed": ("1/min", "min⁻¹", "U/min", "Upm", "RPM", "r.p.m."), "rate": ("cpm", "1/min",
    "cycles per minute"),
             "peak": ("N m", "N·m", "Nm "), "omega": ("rad·s⁻¹", "rad s⁻¹", "rad s-1")}  # fmt: skip
    block = drawn.choice(tuple(texts))
    unit = drawn.choice(texts[block])

    def change(book, workbook):
        book.cell(workbook, block, 0, 1).value = unit
        book.cell(workbook, block, 0, -2).value = "In einer anderen Sprache"

    return f"{block} {unit}", change


def fine_charts(drawn):
    return drawn.choice((
        (CHART, rb'w="19050"', b'w="%d"' % drawn.randint(9000, 60000)), (CHART, rb'val="0072B2"', b'val="004400"'),
        (CHART, rb">Both<", b">Beide<"), (CHART, rb'dLblPos val="t"', b'dLblPos val="b"'),
        (CHART, rb"</plotArea>", b'</plotArea><legend><legendPos val="r"/></legend>'),
        (CHART, rb'sz="1300"', b'sz="%d"' % drawn.randint(800, 2000)),
        (CHART, rb'majorUnit val="60"', b'majorUnit val="90"'),
        ("xl/drawings/drawing1.xml", rb"<xdr:row>\d+</xdr:row>", b"<xdr:row>%d</xdr:row>" % drawn.randint(60, 90)),
        ("xl/drawings/drawing1.xml", rb'cy="\d+"', b'cy="%d"' % drawn.randint(2_000_000, 9_000_000)),
        (SHEET, rb"<sheetView ", b'<sheetView view="pageLayout" showRuler="0" '),
    ))  # fmt: skip


TASTE = (decimals, fine_fonts, fine_places, fine_sheets, fine_words, fine_charts)


@pytest.mark.sample(2)
@pytest.mark.parametrize("turn", range(4))
def test_none_of_100_changes_of_taste_is_told_as_a_finding(turn, book):
    drawn = random.Random(f"{SEED} taste {turn}")
    found = []
    for kind in islice(cycle(TASTE), 25):
        words, report = told(book, drawn, kind)
        found += [(words, one) for one in report.findings]
    assert found == []
