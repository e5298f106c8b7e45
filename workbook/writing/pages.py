"""Where a printed sheet goes on to its next page: between its tables, charts and sections, not through them."""

from bisect import bisect_left
from collections.abc import Iterator, Mapping
from itertools import accumulate, pairwise

from workbook.book.declare import Sheet
from workbook.writing.widths import COLUMN_WIDTH

MARGINS = {"left": 0.4, "right": 0.4, "top": 0.45, "bottom": 0.6, "header": 0.25, "footer": 0.3}
"""inches; A4 in landscape less these is in points"""
WIDTH = 72 * (297 / 25.4 - MARGINS["left"] - MARGINS["right"])
HEIGHT = 72 * (210 / 25.4 - MARGINS["top"] - MARGINS["bottom"])
DIGIT, BESIDE = 5.25, 3.75  # of a column in points: each digit of its width, and what is beside them
ROW = 15.0  # points of a row, and of a row that a chart is high
TALL = {"title": 24.0, "heading": 18.0}
SPARE = 0.96  # share of a page that is filled at most: programs differ in how high rows are
PAGE, SECTION, RUN, TABLE, CHART = 20, 4, 3, 60, 200  # what a further page costs, and what it costs to cut one of these
CLOSE = 3  # rows of a section, and of a table, that its heading keeps to


def breaks(sheet: Sheet, last: int, columns: int, wide: Mapping[int, float], high: Mapping[int, float]) -> list[int]:
    """Return the rows after which a page ends, of a sheet that prints so many rows and columns at its width.

    ``wide`` and ``high`` are the widths of its columns (digits) and the heights of its rows (points), where they
    are not the usual ones. The fewest and least cuts, by what they cost; none where all is one page.
    """
    tall = {1: TALL["title"]} | {text.row: TALL[text.style] for text in sheet.texts if text.style in TALL}
    ends = list(accumulate((high.get(row) or tall.get(row, ROW) for row in range(1, last + 1)), initial=0.0))
    scale = min(1.0, WIDTH / sum(DIGIT * wide.get(c, COLUMN_WIDTH) + BESIDE for c in range(1, columns + 1)))
    room = SPARE * HEIGHT / scale - ends[sheet.head]
    costs = [0] * (last + 1)  # of a page that ends with a row
    for first, end, cost in wholes(sheet, last, ends):
        for row in range(first, min(end, last + 1)):
            costs[row] += cost
    best: dict[int, tuple[int, int]] = {sheet.head: (0, 0)}  # by the row that a page ends with: cost, page before
    for row in range(sheet.head + 1, last + 1):
        found = [
            (cost + PAGE + (costs[row] if row < last else 0), before)
            for before, (cost, _) in best.items()
            if ends[row] - ends[before] <= room
        ]
        if found:
            best[row] = min(found, key=lambda one: (one[0], -one[1]))
    made: list[int] = []
    row = best[last][1] if last in best else sheet.head
    while row > sheet.head:
        made.append(row)
        row = best[row][1]
    return made[::-1]


def wholes(sheet: Sheet, last: int, ends: list[float]) -> Iterator[tuple[int, int, int]]:
    """Yield rows of charts, tables with titles and checks, figures, sections, and what it costs to cut them."""
    rows = sorted({block.row for block in sheet.blocks if not block.is_table})
    begins, finishes = ([row for row in rows if row + step not in rows] for step in (-1, 1))
    yield from ((first, end, RUN) for first, end in zip(begins, finishes, strict=True))
    heads = sorted(text.row for text in sheet.texts if text.style == "heading" and text.row <= last)
    for _, row, _, _, height in sheet.charts:
        if row <= last:
            yield row, bisect_left(ends, ends[row - 1] + height * ROW), CHART
    judged = {block.row for block in sheet.blocks if block.quantities[0].role == "check"}
    for block in sheet.blocks:
        if block.is_table:
            titles = [text.row for text in sheet.texts if text.style == "subheading" and text.row < block.row]
            title, end = max(titles, default=block.row), block.row + block.size - 1
            yield title, end + 2 if end + 2 in judged else end, TABLE
            yield title, block.row + CLOSE - 1, TABLE
    for head, behind in pairwise([*heads, last + 1]):
        yield head, behind - 1, SECTION
        yield head, head + CLOSE, TABLE
