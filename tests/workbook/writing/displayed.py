"""What a user reads of a workbook, as formulon shows it: the oracle of texts, rules, colours and charts."""

from typing import NamedTuple

from formulon import ChartData, DisplayStatus, DrawingObjectKind, MergeRange, Workbook


class Seen(NamedTuple):
    """A chart as drawn: its data, and least and greatest value of its axes where they are fixed."""

    data: ChartData
    limits: tuple[tuple[float | None, float | None], ...]


class Displayed:
    """An opened and recalculated workbook; rows and columns count from 1."""

    def __init__(self, content):
        self.book = Workbook.load(content)
        self.book.recalc()
        self.sheets = {self.book.sheet_name(number): number for number in range(self.book.sheet_count())}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.book.close()

    def text(self, sheet, row, column):
        """What a cell shows, whatever its column's width."""
        text, status = self.book.get_display_text(self.sheets[sheet], row - 1, column - 1)
        assert status == DisplayStatus.OK, (sheet, row, column, status)
        return text

    def validations(self, sheet):
        return self.book.get_validations(self.sheets[sheet])

    def coloured(self, sheet, row, column):
        """The conditional formats that hold for a cell, by their numbers in the file."""
        here = (self.sheets[sheet], row - 1, column - 1, row - 1, column - 1)
        return [match.dxf_id for cell in self.book.evaluate_cf_range(*here) for match in cell.matches]

    def charts(self, sheet):
        """The charts of a sheet in their order."""
        number = self.sheets[sheet]
        drawn = [o for o in self.book.list_drawing_objects(number) if o.kind == DrawingObjectKind.CHART]
        return [Seen(self.book.get_chart_data(number, o.object_id), self._limits(number, o)) for o in drawn]

    def _limits(self, number, drawing):
        return tuple((axis.min, axis.max) for axis in self.book.get_chart(number, drawing.object_id).axes)

    def values(self, sheet, area):
        """The numbers in a range of a chart's data."""
        cells, _ = self.book.get_cells_in_range(self.sheets[sheet], MergeRange(*area))
        return [cell.value.number for cell in cells]
