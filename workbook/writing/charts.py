"""XY charts with straight lines, labelled axes and alternative text.

The numbers that a chart shows are stored in it: previews and Protected View draw these, and compute nothing.
"""

import re
from html import unescape
from itertools import chain
from typing import Literal, NamedTuple, Self

from openpyxl.chart import ScatterChart
from openpyxl.chart.axis import ChartLines, NumericAxis
from openpyxl.chart.data_source import AxDataSource, NumDataSource, NumRef, StrData, StrRef, StrVal
from openpyxl.chart.error_bar import ErrorBars
from openpyxl.chart.label import DataLabel, DataLabelList
from openpyxl.chart.layout import Layout, ManualLayout
from openpyxl.chart.marker import Marker
from openpyxl.chart.series import SeriesLabel, XYSeries
from openpyxl.chart.shapes import GraphicalProperties
from openpyxl.chart.text import RichText
from openpyxl.chart.text import Text as ChartText
from openpyxl.chart.title import Title
from openpyxl.drawing.line import LineProperties
from openpyxl.drawing.text import CharacterProperties, Paragraph, ParagraphProperties, RegularTextRun

from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Book
from workbook.book.rows import is_number
from workbook.writing.archive import value_xml
from workbook.writing.style import GRID

WIDTH = 19050  # of a line: 1.5 points
BAR = 88900  # of a thick one: 7 points
LOG_BASE = 10
SIGNS = {"circle": 7, "dash": 7, "diamond": 11}  # points high
BELOW = 1.5  # cm for the labels of the abscissa and its title
NAMES = 3.0  # cm left of the plot, where the lines have their names there
LANE = 3.4  # likewise of a lane, with its title
FIGURES = 1.7  # cm for the figures of the ordinate and its title
BESIDE = 12  # the share of a line at each of its ends that its name keeps off
NAME = 5, 10  # the shares of a chart's width and height that a name takes
Side = Literal["l", "r", "t", "b", "ctr"]
NO_LINE = GraphicalProperties(ln=LineProperties(noFill=True))
GRIDLINES = ChartLines(spPr=GraphicalProperties(ln=LineProperties(solidFill=GRID, w=6350)))
TITLE, AXIS_TITLE = (ParagraphProperties(defRPr=CharacterProperties(sz=size, b=True)) for size in (1300, 1000))
NUMBERS = re.compile(rb"<numRef><f>([^<]*)</f></numRef>")


def draw(chart: Chart, book: Book, width: float, height: float) -> ScatterChart:
    """Return the openpyxl chart for ``chart``, ``width`` by ``height`` cm large."""
    drawn = ScatterChart()
    if chart.title:
        drawn.title = heading(chart.title, TITLE if chart.legend else AXIS_TITLE, book, beside=chart.is_lane)
    drawn.style, drawn.scatterStyle = 2, "lineMarker"
    drawn.width, drawn.height = width, height  # type: ignore[assignment]  # the stubs say int, the library float
    has_names = chart.lanes or (chart.legend and len(chart.series) > 1)
    names = name_places(chart, book) if has_names else []
    for i, series in enumerate(chart.series):
        ink = series.color or COLOURS[i % len(COLOURS)]
        drawn.series.append(line(series, book, ink))
        if names:
            drawn.series[-1].dLbls = name_at(*names[i], ink)
    drawn.graphical_properties = NO_LINE  # no frame
    drawn.visible_cells_only = False  # folded workings are drawn too
    drawn.legend = None
    axes(drawn, chart, book)
    return drawn


class Point(NamedTuple):
    """A point of a line, in the units of the axes."""

    x: float
    y: float

    def meets(self, other: Self, width: float, height: float) -> bool:
        """Whether names of that size at both points would lie on each other."""
        return abs(self.x - other.x) <= width and abs(self.y - other.y) <= height


def name_places(chart: Chart, book: Book) -> list[tuple[int, Side]]:
    """Return for each line the point that its name stands at, and on which side: where it is large, off other names."""
    lines = [points_of(series, book) for series in chart.series]
    if chart.lanes:  # a dashed line crosses them
        return [
            (0, "ctr") if series.is_note else (len(points) - 1, "r") if series.dashed else (0, "l")
            for series, points in zip(chart.series, lines, strict=True)
        ]
    columns = zip(*chain.from_iterable(lines), strict=True)
    width, height = ((max(column) - min(column)) / share for column, share in zip(columns, NAME, strict=True))
    places: list[tuple[int, Side]] = []
    named: list[Point] = []
    for series, points in zip(chart.series, lines, strict=True):
        inner = range(edge := len(points) // BESIDE, len(points) - edge)  # off the figures of the axis
        by_size = sorted(inner, key=lambda k: -abs(points[k].y))
        free = (k for k in by_size if not any(points[k].meets(other, width, height) for other in named))
        place = next(free, by_size[0])
        named.append(points[place])
        places.append((place, "r" if series.points else "b" if points[place].y < 0.0 else "t"))
    return places


def points_of(series: Series, book: Book) -> list[Point]:
    """Return the points of a line; a text counts as 0, as it is drawn."""
    columns = ([value if is_number(value) else 0.0 for value in book.values(c)] for c in (series.x, series.y))
    return [Point(x, y) for x, y in zip(*columns, strict=True)]


def heading(text: str, look: ParagraphProperties, book: Book, beside: bool = False) -> Title:
    """Return a title, over or ``beside`` the chart; ``=name`` or ``[table.column.3]`` shows a cell."""
    if text.startswith(("=", "[")):
        plain = RichText(p=[Paragraph(pPr=look)])
        return Title(tx=ChartText(strRef=str_ref(text, book)), overlay=False, txPr=plain)
    paragraph = Paragraph(pPr=look, r=[RegularTextRun(rPr=look.defRPr, t=text)])
    place = Layout(ManualLayout(xMode="edge", yMode="edge", x=0.04, y=0.25)) if beside else None
    return Title(tx=ChartText(rich=RichText(p=[paragraph])), overlay=beside, layout=place)


def str_ref(name: str, book: Book) -> StrRef:
    """Return a reference to the cells of a name, with what they show."""
    values = [value for value in book.values(name) if value is not None]
    texts = [f"{value:.15g}" if is_number(value) else str(value) for value in values]
    shown = StrData(ptCount=len(texts), pt=[StrVal(idx=i, v=text) for i, text in enumerate(texts)])
    return StrRef(f=book.range(name), strCache=shown)


def line(series: Series, book: Book, ink: str) -> XYSeries:
    """Return a line between the points, never a spline, which would bend a step backwards."""
    x, y = (NumRef(f=book.range(column)) for column in (series.x, series.y))
    width = BAR if series.thick else WIDTH
    stroke = LineProperties(solidFill=ink, w=width, prstDash="dash" if series.dashed else None)
    marker = Marker("none")
    if series.marker != "none":
        look = GraphicalProperties(solidFill=ink, ln=LineProperties(solidFill=ink))
        marker = Marker(series.marker, SIGNS[series.marker], look)
    bars = None
    if lengths := series.up or series.right:  # strokes that leave each point
        bars = ErrorBars(
            errDir="y" if series.up else "x",
            errBarType="plus",
            errValType="cust",
            noEndCap=True,
            plus=NumDataSource(numRef=NumRef(f=book.range(lengths))),
            spPr=GraphicalProperties(ln=stroke),
        )
    name = SeriesLabel(v=series.name)
    if series.name.startswith(("=", "[")):
        name = SeriesLabel(strRef=str_ref(series.name, book))
    return XYSeries(
        tx=name,
        xVal=AxDataSource(numRef=x),
        yVal=NumDataSource(numRef=y),
        smooth=False,
        errBars=bars,
        marker=marker,
        spPr=NO_LINE if series.points else GraphicalProperties(ln=stroke),
    )


def axes(drawn: ScatterChart, chart: Chart, book: Book) -> None:
    """Title, scale and number format of both axes."""
    for axis, title, limits in ((drawn.x_axis, chart.x, chart.x_range), (drawn.y_axis, chart.y, chart.y_range)):
        if title:
            axis.title = heading(title, AXIS_TITLE, book)
        axis.delete = False  # Excel hides an axis that does not say so
        axis.number_format, axis.majorTickMark = "General", "out"
        axis.majorGridlines = GRIDLINES
        if limits and isinstance(axis, NumericAxis):
            axis.scaling.min, axis.scaling.max, axis.majorUnit = limits
    if chart.log_y:
        drawn.y_axis.scaling.logBase = LOG_BASE
    drawn.x_axis.tickLblPos = drawn.y_axis.tickLblPos = "low"
    if chart.is_lane:
        drawn.x_axis.number_format, drawn.x_axis.majorTickMark = ";;;", "none"
        place = ManualLayout("inner", "edge", "edge", x=LANE / drawn.width, y=0.12, w=0.97 - LANE / drawn.width, h=0.76)
        drawn.layout = Layout(place)
        return
    if chart.lanes:
        drawn.y_axis.number_format, drawn.y_axis.majorTickMark = ";;;", "none"
    top = 0.12 if chart.title else 0.03
    room = 1.0 - top - BELOW / drawn.height
    left = max(0.13, (NAMES if chart.lanes else FIGURES) / drawn.width)
    drawn.layout = Layout(ManualLayout(xMode="edge", yMode="edge", x=left, y=top, w=0.95 - left, h=room))


def name_at(point: int, side: Side, ink: str) -> DataLabelList:
    """Return the labels of a line: its name, on a side of one of its points, in its colour."""
    text = CharacterProperties(sz=1000, b=side != "ctr", solidFill=ink)
    look = RichText(p=[Paragraph(pPr=ParagraphProperties(defRPr=text), endParaRPr=text)])
    shown = dict.fromkeys(("showLegendKey", "showVal", "showCatName", "showPercent", "showBubbleSize"), False)
    label = DataLabel(idx=point, dLblPos=side, txPr=look, showSerName=True, **shown)
    return DataLabelList(dLbl=[label], showSerName=False, **shown)


def fill_caches(charts: dict[str, bytes], book: Book) -> dict[str, bytes]:
    """Return the parts of charts with the values of ranges that they refer to (ISO/IEC 29500-1, 21.2.2.122)."""
    lines = [line for sheet in book.sheets for chart, *_ in sheet.charts for line in chart.series]
    columns = {text for line in lines for text in (line.x, line.y, line.up, line.right) if text}
    ranges = {book.range(text): text for text in columns}
    known: dict[bytes, bytes] = {}

    def cached(match: re.Match[bytes]) -> bytes:
        range_ = match[1]
        if range_ not in known:
            values = book.values(ranges[unescape(range_.decode())])
            points = enumerate(value_xml(value) for value in values)  # what is no number has none
            cache = "".join(f'<pt idx="{i}">{value}</pt>' for i, (kind, value) in points if value and not kind)
            cache = f'<numCache><formatCode>General</formatCode><ptCount val="{len(values)}"/>{cache}</numCache>'
            known[range_] = b"<numRef><f>%s</f>%s</numRef>" % (range_, cache.encode())
        return known[range_]

    return {name: NUMBERS.sub(cached, part) for name, part in charts.items()}
