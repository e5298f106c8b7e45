"""XY charts with straight lines, labelled axes and alternative text."""

from __future__ import annotations

from openpyxl.chart import Reference, ScatterChart
from openpyxl.chart import Series as ChartSeries
from openpyxl.chart.layout import Layout, ManualLayout
from openpyxl.chart.shapes import GraphicalProperties
from openpyxl.drawing.line import LineProperties
from openpyxl.workbook import Workbook

from workbook.declare import Book, Chart, Series
from workbook.style import COLOURS, GRID

CM_PER_COLUMN = 2.15
CM_PER_ROW = 0.53


def draw(chart: Chart, book: Book, workbook: Workbook, width: int, height: int) -> ScatterChart:
    """Return the openpyxl chart for ``chart``, ``width`` columns by ``height`` rows large."""
    drawn = ScatterChart()
    drawn.title, drawn.style, drawn.scatterStyle = chart.title, 2, "lineMarker"
    drawn.width, drawn.height = width * CM_PER_COLUMN, height * CM_PER_ROW
    for i, series in enumerate(chart.series):
        drawn.series.append(line(series, book, COLOURS[i % len(COLOURS)]))
    drawn.legend.position = "b"
    if len(chart.series) == 1:
        drawn.legend = None
    drawn.title.overlay = False
    axes(drawn, chart)
    return drawn


def line(series: Series, book: Book, colour: str) -> ChartSeries:
    """Return one line between the points, never a spline, which would bend a step backwards."""
    x, y = (Reference(range_string=book.range(r)) for r in (series.x, series.y))
    drawn = ChartSeries(y, x, title=series.name)
    drawn.smooth = False
    drawn.marker.symbol = "none"
    drawn.graphicalProperties = GraphicalProperties(
        ln=LineProperties(
            solidFill=series.color or colour, w=19050, prstDash="dash" if series.dashed else None
        )
    )
    if series.points:
        drawn.graphicalProperties.line.noFill = True
    return drawn


def axes(drawn: ScatterChart, chart: Chart) -> None:
    """Title, scale and number format of both axes."""
    for axis, title, limits in (
        (drawn.x_axis, chart.x, chart.x_range),
        (drawn.y_axis, chart.y, chart.y_range),
    ):
        axis.title, axis.delete = title, False  # Excel hides an axis that does not say so
        axis.number_format, axis.majorTickMark = "General", "out"
        axis.title.overlay = False
        axis.majorGridlines.spPr = GraphicalProperties(ln=LineProperties(solidFill=GRID, w=6350))
        if limits:
            axis.scaling.min, axis.scaling.max, axis.majorUnit = limits
    drawn.x_axis.tickLblPos = drawn.y_axis.tickLblPos = "low"
    if chart.hide_y:
        drawn.y_axis.tickLblPos, drawn.y_axis.majorGridlines = "none", None
        drawn.y_axis.majorTickMark = "none"
    drawn.layout = Layout(ManualLayout(xMode="edge", yMode="edge", x=0.13, y=0.14, w=0.82, h=0.58))
