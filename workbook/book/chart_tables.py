"""Charts that are declared in Markdown beside the code, in a file ``charts.md``: a heading and a table each.

Below the heading, its title, stand the titles of its axes, each in backquotes, and behind a colon what is shown.
A row of the table is a line, with the fields of :class:`workbook.book.chart.Series`; ``yes`` for what is so.
"""

import re
from pathlib import Path

from workbook.book.cell_tables import markdown_rows, sections
from workbook.book.chart import Chart, Series

AXES = re.compile(r"^`(.+)`, `(.+)`: (.+)$", re.MULTILINE)


def charts_beside(module: str) -> dict[str, Chart]:
    """Return the charts of the file ``charts.md`` beside a module, whose ``__file__`` is given, by their titles."""
    charts = {}
    for title, text in sections(str(Path(module).with_name("charts.md"))):
        x, y, about = AXES.findall(text)[0]
        lines: list[Series] = []
        for row in markdown_rows(text):
            drawn = {field: value == "yes" for field, value in row.items() if field in ("dashed", "points")}
            lines.append(Series(**{**row, **drawn}))  # type: ignore[arg-type]
        charts[title] = Chart(title, x, y, tuple(lines), about)
    return charts
