"""The first page of a drive: entries on the left, results at fixed places on the right.

What stands where is said by the tables of ``front_page.md``, and nowhere else. On the left a row is what is entered,
what the catalogue has and what is in use, in the same unit. On the right a row keeps its place, whatever the mechanism:
a result has the same address on the sheets of all drives.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from workbook.book import limits
from workbook.book.cell_tables import markdown_rows, sections
from workbook.book.chart import Chart, in_scope
from workbook.book.declare import Quantity, Sheet, Text
from workbook.book.limits import Limit

# the first row of the page; heights of rows, and of the heads of groups, in points
TOP, ROW, HEAD = 4, 13.5, 18.0
LEFT, RIGHT = 2, 8  # the columns of labels; symbols stand beside them
HEADS = {
    4: ("entered", "stage 1"),
    5: ("catalogue", "stage 2"),
    6: ("in use",),
    10: ("is", "highest", "its own"),
    11: ("may be", "lowest", "counts"),
    13: ("use", "note"),
    14: ("judged",),
    15: ("bound by",),
}
COLUMNS = {head: column for column, heads in HEADS.items() for head in heads}
"""by head, the columns of quantities"""
# the columns of units, of notes, of what checks say
UNITS, NOTES, SAYS = {LEFT: 7, RIGHT: 12}, 13, 15
QUIET = ("note", "judged")  # heads that are not shown
MESSAGES = {
    4: (17, "@entries", "entries"),
    10: (18, "@reserve_entries", "reserves"),
    5: (19, "@stage2_entries", "stage 2"),
}
"""by the column of entries, that of what is expected of them, the name of the check of these, and its words"""
WIDTHS = dict(enumerate((28, 8.5, 10.5, 10, 11.2, 11, 28.5, 9, 10, 10, 10, 9, 9, 28, 9.5, 50, 50, 50), LEFT))
CHARTS, CHART_ROWS = {8: 4, 12: 4}, 17  # the columns that they begin at, and how many they cover
FIXED = "Limits"  # the group above the charts
REST = "*"

Watched = tuple[Quantity, Limit]
Row = tuple[str, dict[int, Quantity]]
"""the label of a row, and its cells by their columns"""


class Group(NamedTuple):
    """A group of rows: its title, and of each row the names of cells by the heads of their columns, and its label."""

    title: str
    rows: tuple[dict[str, str], ...]

    @property
    def heads(self) -> list[str]:
        """The heads of its columns, from left to right."""
        heads = {head for row in self.rows for head in row if head in COLUMNS}
        return sorted(heads, key=COLUMNS.__getitem__)

    @property
    def side(self) -> int:
        """The column of its labels."""
        return LEFT if COLUMNS[self.heads[0]] < RIGHT else RIGHT


GROUPS = [Group(title, tuple(markdown_rows(text))) for title, text in sections(__file__)]
NAMED = {name for group in GROUPS for row in group.rows for head, name in row.items() if head in COLUMNS}


class FrontPage:
    """The page while it is placed on a sheet, with all that it can show by the names of the cells."""

    def __init__(self, sheet: Sheet, quantities: Sequence[Quantity]) -> None:
        self.sheet, self.known = sheet, {q.name: q for q in quantities}
        self.rest = [q for q in quantities if q.name not in NAMED and q.role in ("input", "constant")]
        self.watched: dict[int, list[Watched]] = {column: [] for column in MESSAGES}

    def place(self, charts: Sequence[Chart]) -> None:
        """Place all groups and the charts; a group of the left for which there is no room, on the next page."""
        sheet, bottom, left = self.sheet, TOP, TOP
        for group in (group for group in GROUPS if group.side == RIGHT):
            bottom = self.place_group(group, list(self.rows_of(group)), bottom)
            if group.title == FIXED:
                for (column, width), chart in zip(CHARTS.items(), charts, strict=True):
                    sheet.chart(chart, column, bottom, width, CHART_ROWS)
                bottom += CHART_ROWS
        sheet.row, sheet.page_end = bottom + 1, bottom - 1
        sheet.widths, sheet.print_columns = WIDTHS, SAYS
        for group in (group for group in GROUPS if group.side == LEFT):
            rows = [(label, cells) for label, cells in self.rows_of(group) if cells]
            if left + len(rows) < bottom:
                left = self.place_group(group, rows, left) if rows else left
            else:
                sheet.row = self.place_group(group, rows, sheet.row)
        sheet.heights |= {row: ROW for row in range(TOP, bottom) if row not in sheet.heights}

    def place_group(self, group: Group, rows: Sequence[Row], top: int) -> int:
        """Place a group at a row; return the row behind it."""
        ruled = range(group.side + 1, UNITS[LEFT] if group.side == LEFT else SAYS + 1)
        heads = dict.fromkeys(ruled, "") | {COLUMNS[head]: head for head in group.heads if head not in QUIET}
        words = {column: "group word" if column == SAYS else "group head" for column in heads}
        self.sheet.texts.append(Text(top, group.side, group.title, "group"))
        self.sheet.texts += [Text(top, column, head, words[column]) for column, head in heads.items()]
        self.sheet.heights[top] = HEAD
        for row, (label, cells) in enumerate(rows, top + 1):
            if cells:
                self.place_row(row, label, cells, group.side)
        return top + len(rows) + 1

    def rows_of(self, group: Group) -> Iterator[Row]:
        """Yield the labels of a group's rows, with what the drive has of each by its column."""
        for row in group.rows:
            if REST in row.values():
                yield from ((q.label, {COLUMNS[group.heads[0]]: q}) for q in self.rest)
                continue
            yield row["row"], {COLUMNS[h]: self.known[name] for h, name in row.items() if name in self.known}

    def place_row(self, row: int, label: str, cells: Mapping[int, Quantity], side: int) -> None:
        """Place a row: its label, symbol and unit, the cells, and what is noted of them."""
        sheet = self.sheet
        symbol, unit, note = (next(filter(None, (q[k] for q in cells.values())), "") for k in (2, 3, 7))
        beside = {side: (label, "label"), side + 1: (symbol, "symbol"), UNITS[side]: (unit, "unit")}
        if side == RIGHT and max(cells) < NOTES and not any(q.role == "input" for q in cells.values()):
            beside[NOTES] = (note, "note")
        sheet.texts += [Text(row, column, text, style) for column, (text, style) in beside.items() if text]
        for column, q in cells.items():
            if q.role == "check":
                sheet.check(q._replace(source=note, row_label=label), row, column, SAYS)
            else:
                sheet.put(q._replace(row_label=label), row, column)
            if q.role == "input":
                self.place_message(row, column, q)

    def place_message(self, row: int, column: int, q: Quantity) -> None:
        """Place what is expected of an entry, or its note, behind the page."""
        at, watched = MESSAGES[column][0], self.sheet.limited([q])
        for limited in watched:
            self.sheet.put(limits.message_beside(*limited), row, at)
        self.watched[column] += watched
        if q.source and not watched:
            self.sheet.texts.append(Text(row, at, q.source, "note"))

    def verdicts(self) -> list[Quantity]:
        """Return the checks that entries are within their limits."""
        verdicts = []
        for column, watched in self.watched.items():
            _, name, words = MESSAGES[column]
            if watched:
                label = f"{self.sheet.called}: {words} within limits"
                verdicts.append(limits.cells_check(in_scope(name, self.sheet.scope), label, watched))
        return verdicts
