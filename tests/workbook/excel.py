"""What Excel does to a book in which rows or columns are inserted or deleted, or cells are cut and pasted.

openpyxl moves cells and leaves what refers to them as it is. Here formulas, names, charts, rules, validations follow,
as Excel documents it: a range grows and shrinks with what is put in or taken out within it; what refers to deleted
cells is #REF!; what refers to cut cells follows them, a range only where it lies wholly in what was cut.
"""

import re
from typing import NamedTuple

from openpyxl.formatting.formatting import ConditionalFormattingList
from openpyxl.utils import get_column_letter, quote_sheetname
from openpyxl.utils.cell import range_boundaries
from openpyxl.worksheet.cell_range import MultiCellRange

from workbook.book.formula import REFERENCE, TOKEN, unquoted

CORNER = re.compile(r"(\$?)([A-Za-z]{1,3})(\$?)([0-9]+)")


class Rect(NamedTuple):
    """Cells of a sheet."""

    sheet: str
    top: int
    left: int
    bottom: int
    right: int


class Lines:
    """Rows or columns inserted (``count`` above 0) or deleted, from ``at`` on."""

    def __init__(self, sheet, at, count, columns=False):
        self.sheet, self.at, self.count, self.columns = sheet, at, count, columns

    def span(self, low, high):
        """Where a span of rows or columns comes to lie; None where it is gone."""
        if self.count > 0:
            return tuple(n + self.count if n >= self.at else n for n in (low, high))
        end = self.at - self.count  # the first that stays behind what is deleted
        if low >= self.at and high < end:
            return None
        low = low + self.count if low >= end else min(low, self.at) if low < self.at else self.at
        high = high + self.count if high >= end else high if high < self.at else self.at - 1
        return low, high

    def __call__(self, rect):
        if rect.sheet != self.sheet:
            return rect
        if self.columns:
            found = self.span(rect.left, rect.right)
            return found and rect._replace(left=found[0], right=found[1])
        found = self.span(rect.top, rect.bottom)
        return found and rect._replace(top=found[0], bottom=found[1])


class Cut:
    """Cells cut, and pasted so many rows and columns away, or on another sheet."""

    def __init__(self, sheet, span, down=0, right=0, to=None):
        left, top, far, bottom = range_boundaries(span)
        self.rect, self.down, self.right, self.to = Rect(sheet, top, left, bottom, far), down, right, to or sheet

    def within(self, rect):
        own = self.rect
        return (
            rect.sheet == own.sheet and own.top <= rect.top and rect.bottom <= own.bottom
            and own.left <= rect.left and rect.right <= own.right
        )  # fmt: skip

    def __call__(self, rect):
        return self.moved(rect) if self.within(rect) else None if self.covers(rect) else rect

    def covers(self, rect):
        """Whether what is pasted lies over all of some cells."""
        target = self.moved(self.rect)
        return (
            rect.sheet == target.sheet and target.top <= rect.top and rect.bottom <= target.bottom
            and target.left <= rect.left and rect.right <= target.right
        )  # fmt: skip

    def moved(self, rect):
        _, top, left, bottom, right = rect
        return Rect(self.to, top + self.down, left + self.right, bottom + self.down, right + self.right)


def edited(workbook, edit):
    """Carry out an edit in a workbook, with all that refers to what it moves."""
    for page in workbook.worksheets:
        for name in page.defined_names.values():
            name.attr_text = followed(name.attr_text, page.title, edit)
        for cell in page._cells.values():
            if cell.data_type == "f" and isinstance(cell.value, str):
                home = (cell.parent.title, cell.row, cell.column)
                cell.value = "=" + followed(cell.value[1:], page.title, edit, home)
        charts(page, edit)
        if isinstance(edit, Lines) and page.title == edit.sheet:
            (columns if edit.columns else rows)(page, edit)
        if page.print_area:
            page.print_area = followed(page.print_area, page.title, edit).rpartition("!")[2]
        page.conditional_formatting = rules(page, edit)
        for rule in page.data_validations.dataValidation:
            rule.sqref = areas(rule.sqref, page.title, edit)
            for part in ("formula1", "formula2"):
                if getattr(rule, part):
                    setattr(rule, part, followed(getattr(rule, part), page.title, edit))
        page.data_validations.dataValidation = [r for r in page.data_validations.dataValidation if r.sqref.ranges]
    for name in workbook.defined_names.values():
        name.attr_text = followed(name.attr_text, "", edit)
    cells(workbook, edit)
    return workbook


def columns(page, edit):
    """Let widths and hidden columns move with what stands in them."""
    told = [(span, one) for one in page.column_dimensions.values() if (span := edit.span(one.min, one.max))]
    page.column_dimensions.clear()
    for (first, last), one in told:
        one.index, one.min, one.max = get_column_letter(first), first, last
        page.column_dimensions[one.index] = one


def rows(page, edit):
    """Let heights and hidden rows move with what stands in them."""
    moved = [(span[0], row) for row in page.row_dimensions.values() if (span := edit.span(row.index, row.index))]
    page.row_dimensions.clear()
    for number, row in moved:
        row.index = number
        page.row_dimensions[number] = row


def followed(text, sheet, edit, home=None):
    """The text of a formula after an edit."""

    def replaced(token):
        if token.lastgroup != "reference":
            return token[0]
        before, first, _, second = REFERENCE.fullmatch(token[0]).groups()
        title = unquoted(before[:-1]) if before else sheet
        corners = [CORNER.fullmatch(corner) for corner in (first, second or first)]
        rows, columns = [int(c[4]) for c in corners], [range_boundaries(c[2] + "1")[0] for c in corners]
        rect = Rect(title, min(rows), min(columns), max(rows), max(columns))
        found = edit(rect)
        if found == rect and not (isinstance(edit, Cut) and home and edit.within(Rect(*home, home[1], home[2]))):
            return token[0]
        if found is None:
            return f"{before or ''}#REF!"
        here = edit.to if isinstance(edit, Cut) and home and edit.within(Rect(*home, *home[1:])) else sheet
        prefix = (
            before
            if before and found.sheet == title
            else ""
            if found.sheet == here
            else f"{quote_sheetname(found.sheet)}!"
        )
        ends = [(found.top, found.left), (found.bottom, found.right)]
        words = [f"{c[1]}{get_column_letter(col)}{c[3]}{row}" for c, (row, col) in zip(corners, ends, strict=True)]
        return prefix + (":".join(words) if second else words[0])

    return TOKEN.sub(replaced, text)


def areas(ranges, sheet, edit):
    """The ranges of a rule after an edit."""
    found = [edit(Rect(sheet, r.min_row, r.min_col, r.max_row, r.max_col)) for r in ranges.ranges]
    kept = [
        f"{get_column_letter(r.left)}{r.top}:{get_column_letter(r.right)}{r.bottom}"
        for r in found
        if r is not None and r.sheet == sheet
    ]
    return MultiCellRange(" ".join(kept)) if kept else MultiCellRange()


def rules(page, edit):
    """The conditional formats of a sheet after an edit."""
    made = ConditionalFormattingList()
    for group in page.conditional_formatting:
        where = areas(group.sqref, page.title, edit)
        for rule in group.rules if where.ranges else ():
            rule.formula = [followed(str(text), page.title, edit) for text in rule.formula]
            made.add(str(where), rule)
    return made


def charts(page, edit):
    """Let the charts of a sheet follow."""
    for chart in page._charts:
        corner = chart.anchor._from
        now = edit(Rect(page.title, *[corner.row + 1, corner.col + 1] * 2)) if isinstance(edit, Lines) else None
        if now is not None:  # it lies beside the same cells
            corner.row, corner.col = now.top - 1, now.left - 1
        titles = [chart.title, *(getattr(getattr(chart, axis, None), "title", None) for axis in ("x_axis", "y_axis"))]
        found = [getattr(title, "tx", None) for title in titles]
        for series in chart.series:
            bars = series.errBars
            found += [series.tx, *(getattr(series, name, None) for name in ("xVal", "yVal", "cat", "val"))]
            found += [bars.plus, bars.minus] if bars is not None else []
        for data in found:
            for kind in ("numRef", "strRef"):
                source = getattr(data, kind, None)
                if source is not None:
                    source.f = followed(source.f, page.title, edit)
                    if hasattr(source, "numCache"):
                        source.numCache = None


def cells(workbook, edit):
    """Move the cells themselves."""
    pages = {page.title: page for page in workbook.worksheets}
    title = edit.sheet if isinstance(edit, Lines) else edit.rect.sheet
    page, moving = pages[title], {}
    for (row, column), cell in list(page._cells.items()):
        found = edit(Rect(title, row, column, row, column))
        if found == Rect(title, row, column, row, column):
            continue
        del page._cells[row, column]
        if found is not None:
            moving[found.sheet, found.top, found.left] = cell
    for (sheet, row, column), cell in moving.items():
        cell.parent, cell.row, cell.column = pages[sheet], row, column
        pages[sheet]._cells[row, column] = cell
        if cell.hyperlink:
            cell.hyperlink.ref = cell.coordinate


def save(workbook, path):
    """Save an edited workbook."""
    workbook.save(path)
    return path
