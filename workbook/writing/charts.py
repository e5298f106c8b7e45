"""XY charts with straight lines, labelled axes and alternative text.

The numbers that a chart shows are kept in it: previews and Protected View draw these, and compute nothing.
"""

import re
from html import unescape

from openpyxl.chart import Reference, ScatterChart
from openpyxl.chart.axis import ChartLines, NumericAxis
from openpyxl.chart.data_source import NumDataSource, NumRef, StrData, StrRef, StrVal
from openpyxl.chart.error_bar import ErrorBars
from openpyxl.chart.label import DataLabel, DataLabelList
from openpyxl.chart.layout import Layout, ManualLayout
from openpyxl.chart.legend import Legend
from openpyxl.chart.marker import Marker
from openpyxl.chart.series import SeriesLabel, XYSeries
from openpyxl.chart.series_factory import SeriesFactory
from openpyxl.chart.shapes import GraphicalProperties
from openpyxl.chart.text import RichText
from openpyxl.chart.text import Text as ChartText
from openpyxl.chart.title import Title
from openpyxl.drawing.line import LineProperties
from openpyxl.drawing.text import CharacterProperties, Paragraph, ParagraphProperties, RegularTextRun
from openpyxl.utils import quote_sheetname

from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Book
from workbook.writing.cells import result
from workbook.writing.style import GRID

WIDTH = 19050  # of a line: 1.5 points
LOG_BASE = 10
SIGNS = {"circle": 7, "dash": 7, "diamond": 11}  # points high
BELOW = 1.5  # cm for the labels of the abscissa and its title
NAMES = 3.0  # cm left of the plot, where the lines have their names there
LEGEND, LONG_LEGEND, LONG = 0.7, 1.6, 6  # cm for a legend, for one of more lines than so many
NUMBERS = re.compile(rb"<numRef><f>([^<]*)</f></numRef>")


def draw(chart: Chart, book: Book, width: float, height: float) -> ScatterChart:
    """Return the openpyxl chart for ``chart``, ``width`` by ``height`` cm large."""
    drawn = ScatterChart()
    drawn.title, drawn.style, drawn.scatterStyle = heading(chart.title, 1300), 2, "lineMarker"
    drawn.width, drawn.height = width, height  # type: ignore[assignment]  # the stubs say int, the library float
    for i, series in enumerate(chart.series):
        drawn.series.append(line(series, book, COLOURS[i % len(COLOURS)]))
        if chart.lanes:
            drawn.series[-1].dLbls = named(series, book, series.color or COLOURS[i % len(COLOURS)])
    drawn.graphical_properties = GraphicalProperties(ln=LineProperties(noFill=True))  # no frame
    drawn.legend = Legend(legendPos="b") if legend(chart) else None
    axes(drawn, chart, book)
    return drawn


def heading(text: str, size: int) -> Title:
    """Return a title of a chart or an axis, in bold of ``size`` hundredths of a point."""
    properties = CharacterProperties(sz=size, b=True)
    run = RegularTextRun(rPr=properties, t=text)
    paragraph = Paragraph(pPr=ParagraphProperties(defRPr=properties), r=[run])
    return Title(tx=ChartText(rich=RichText(p=[paragraph])), overlay=False)


def linked(name: str, book: Book, size: int) -> Title:
    """Return a title that shows the cell of this name: it follows the units that are entered."""
    paragraph = Paragraph(pPr=ParagraphProperties(defRPr=CharacterProperties(sz=size, b=True)))
    return Title(tx=ChartText(strRef=cell(name, book)), overlay=False, txPr=RichText(p=[paragraph]))


def cell(name: str, book: Book) -> StrRef:
    """Return a reference to the cell of this name, with the text that it shows."""
    block = book.blocks[name]
    shown = StrData(ptCount=1, pt=[StrVal(idx=0, v=str(block.quantities[0].value))])
    return StrRef(f=f"{quote_sheetname(block.sheet.title)}!{block.span}", strCache=shown)


def reference(text: str) -> Reference:
    """Return a range for a chart; openpyxl keeps the doubled apostrophes of a sheet's name, and doubles them again."""
    found = Reference(range_string=text)
    found.worksheet.title = found.worksheet.title.replace("''", "'")
    return found


def line(series: Series, book: Book, colour: str) -> XYSeries:
    """Return one line between the points, never a spline, which would bend a step backwards."""
    x, y = (reference(book.range(r)) for r in (series.x, series.y))
    drawn: XYSeries = SeriesFactory(y, x, title=series.name)
    if series.name.startswith("="):
        drawn.tx = SeriesLabel(strRef=cell(series.name[1:], book))
    ink = series.color or colour
    stroke = LineProperties(solidFill=ink, w=WIDTH, prstDash="dash" if series.dashed else None)
    drawn.smooth, drawn.marker = False, sign(series, ink)
    drawn.graphicalProperties = GraphicalProperties(ln=LineProperties(noFill=True) if series.points else stroke)
    drawn.errBars = strokes(series, book, stroke)
    return drawn


def sign(series: Series, ink: str) -> Marker:
    """Return the sign at each point, in one colour; none by default."""
    if series.marker == "none":
        return Marker(symbol="none")
    look = GraphicalProperties(solidFill=ink, ln=LineProperties(solidFill=ink))
    return Marker(symbol=series.marker, size=SIGNS[series.marker], spPr=look)


def strokes(series: Series, book: Book, stroke: LineProperties) -> ErrorBars | None:
    """Return the strokes that leave each point of a series, drawn as its error bars."""
    lengths = series.up or series.right
    if not lengths:
        return None
    return ErrorBars(errDir="y" if series.up else "x", errBarType="plus", errValType="cust", noEndCap=True,
                     plus=NumDataSource(numRef=NumRef(f=book.range(lengths))),
                     spPr=GraphicalProperties(ln=stroke))  # fmt: skip


def axes(drawn: ScatterChart, chart: Chart, book: Book) -> None:
    """Title, scale and number format of both axes."""
    for axis, title, limits in ((drawn.x_axis, chart.x, chart.x_range), (drawn.y_axis, chart.y, chart.y_range)):
        if title:
            axis.title = linked(title[1:], book, 1000) if title.startswith("=") else heading(title, 1000)
        axis.delete = False  # Excel hides an axis that does not say so
        axis.number_format, axis.majorTickMark = "General", "out"
        axis.majorGridlines = ChartLines(spPr=GraphicalProperties(ln=LineProperties(solidFill=GRID, w=6350)))
        if limits and isinstance(axis, NumericAxis):
            axis.scaling.min, axis.scaling.max, axis.majorUnit = limits
    if chart.log_y:
        drawn.y_axis.scaling.logBase = LOG_BASE
    drawn.x_axis.tickLblPos = drawn.y_axis.tickLblPos = "low"
    if chart.lanes:
        drawn.y_axis.number_format, drawn.y_axis.majorTickMark = ";;;", "none"
    room, left = 0.88 - below(chart) / drawn.height, max(0.13, NAMES / drawn.width) if chart.lanes else 0.13
    drawn.layout = Layout(ManualLayout(xMode="edge", yMode="edge", x=left, y=0.12, w=0.95 - left, h=room))


def legend(chart: Chart) -> bool:
    """Whether a chart has a legend: of several lines that do not say their names themselves."""
    return len(chart.series) > 1 and not chart.lanes


def below(chart: Chart) -> float:
    """Return the room below the plot of a chart in cm: for labels and title, and for the legend."""
    if not legend(chart):
        return BELOW
    return BELOW + (LONG_LEGEND if len(chart.series) > LONG else LEGEND)


def named(series: Series, book: Book, ink: str) -> DataLabelList:
    """Return the labels of a line: its name, left of its first point; of one that crosses the lanes behind its last."""
    text = CharacterProperties(sz=1000, b=True, solidFill=ink)
    look = RichText(p=[Paragraph(pPr=ParagraphProperties(defRPr=text), endParaRPr=text)])
    shown = dict.fromkeys(("showLegendKey", "showVal", "showCatName", "showPercent", "showBubbleSize"), False)
    at, side = (len(book.values(series.x)) - 1, "r") if series.dashed else (0, "l")
    first = DataLabel(idx=at, dLblPos=side, txPr=look, showSerName=True, **shown)
    return DataLabelList(dLbl=[first], showSerName=False, **shown)


def filled(charts: dict[str, bytes], book: Book) -> dict[str, bytes]:
    """Return the parts of charts with the values of each range that a line, or its strokes, refer to."""
    ranges = {book.range(text): text for text in references(book)}
    known: dict[bytes, bytes] = {}

    def cached(found: re.Match[bytes]) -> bytes:
        range_ = found[1]
        if range_ not in known:
            cache = numbers(book, ranges[unescape(range_.decode())])
            known[range_] = b"<numRef><f>%s</f>%s</numRef>" % (range_, cache.encode())
        return known[range_]

    return {name: NUMBERS.sub(cached, part) for name, part in charts.items()}


def references(book: Book) -> set[str]:
    """Return the columns that the charts of a book refer to."""
    lines = [line for sheet in book.sheets for chart, *_ in sheet.charts for line in chart.series]
    return {text for line in lines for text in (line.x, line.y, line.up, line.right) if text}


def numbers(book: Book, reference: str) -> str:
    """Return the cache of one column (ISO/IEC 29500-1, 21.2.2.122); what is no number has no point."""
    values = book.values(reference)
    known = enumerate(result(value) for value in values)
    points = "".join(f'<pt idx="{i}">{value}</pt>' for i, (kind, value) in known if value and not kind)
    return f'<numCache><formatCode>General</formatCode><ptCount val="{len(values)}"/>{points}</numCache>'
