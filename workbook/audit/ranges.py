"""Ranges that end early or late, and look-ups in what is not sorted."""

from collections.abc import Iterator
from itertools import pairwise

from workbook.audit.finding import Finding
from workbook.audit.lines import Lines, cell_text
from workbook.audit.patterns import AGGREGATES
from workbook.audit.view import Form, View
from workbook.book.address import Address
from workbook.book.columns import Node
from workbook.book.formula import Area

SHORT = 3  # rows by which a range misses the end of what it is meant to have
LEAST = 3  # rows of a range that is judged
WITHOUT = frozenset(["SUBTOTAL", "OFFSET", "INDIRECT"])


def short(lines: Lines) -> Iterator[Finding]:
    """Yield ranges that end some rows before, or behind, the figures in their column."""
    view = lines.view
    for cell, form in view.forms.items():
        if not form.functions or form.functions & WITHOUT or moves(lines, cell, form):
            continue
        for area in form.areas:
            if not area.single and area.bottom - area.top + 1 >= LEAST and area.left == area.right:
                yield from ends(view, cell, form, area)


def moves(lines: Lines, cell: Address, form: Form) -> bool:
    """Whether a formula is one of a column in which its ranges move or grow, as running sums do."""
    stretch = lines.members.get((cell, True))
    if stretch is None or (cell, True) in lines.between:
        return False
    ranges = [n for n, area in enumerate(form.areas) if not area.single]
    return any(stretch.modes[side] for n in ranges for side in (2 * n, 2 * n + 1))


def ends(view: View, cell: Address, form: Form, area: Area) -> Iterator[Finding]:
    """Yield what a range of a column leaves out at its ends, or has too much."""
    if not all(view.figure(Address(area.sheet, row, area.left)) for row in (area.top, area.bottom)):
        return
    more = next_rows(view, cell, area, area.bottom, 1)
    if 0 < len(more) <= SHORT:
        why = f"the range {area.a1} ends before {more[-1].a1}"
        yield Finding(cell, "range", why, "high", cell_text(view, more[0]))
    before = next_rows(view, cell, area, area.top, -1)
    if 0 < len(before) < SHORT:
        why = f"the range {area.a1} begins behind {before[-1].a1}"
        yield Finding(cell, "range", why, "high", cell_text(view, before[0]))
    if form.functions & AGGREGATES and (total := total_in(view, area)):
        why = f"the range {area.a1} has the total in {total.a1}, and what that sums up"
        yield Finding(cell, "range", why, "high", cell_text(view, total))


def total_in(view: View, area: Area) -> Address | None:
    """Return the last cell of a range if it sums up others of it; None if it does not."""
    last = Address(area.sheet, area.bottom, area.left)
    form = view.forms.get(last)
    over = form.areas if form is not None and form.functions & AGGREGATES else ()
    within = any(a.left == a.right == area.left and area.top <= a.top < a.bottom < area.bottom for a in over)
    return last if within else None


def next_rows(view: View, cell: Address, area: Area, row: int, step: int) -> list[Address]:
    """Return the figures that go on behind the end of a range and are alike: until a total, a gap, or the formula."""
    end = Address(area.sheet, row, area.left)
    result: list[Address] = []
    form = view.forms.get(end)
    while len(result) <= SHORT:
        row += step
        other = Address(area.sheet, row, area.left) if row > 0 else end
        if not view.figure(other) or other == cell or (other.row == cell.row and other.sheet == cell.sheet):
            return result
        mine = view.forms.get(other)
        if (mine is None) != (form is None) or (mine and form and mine.skeleton != form.skeleton):
            return result
        if labelled_apart(view, end, other):
            return result
        result.append(other)
    return result


def labelled_apart(view: View, cell: Address, other: Address) -> bool:
    """Whether the row of a figure has texts or figures beside it where that of the other has none."""
    sides = [(c._replace(column=c.column + k) for k in (-1, 1) if c.column + k) for c in (cell, other)]
    here, there = ([not view.empty(c) for c in side] for side in sides)
    return here != there


def unsorted_lookups(lines: Lines) -> Iterator[Finding]:
    """Yield look-ups of the nearest value in a column that does not rise."""
    view, known = lines.view, dict[Area, str]()
    for cell, form in view.forms.items():
        if not form.functions & {"VLOOKUP", "HLOOKUP", "MATCH", "LOOKUP"}:
            continue
        for node in view.calls(cell):
            area, falls = searched_line(node, view.contents.formulas[cell].arguments)
            if area is None:
                continue
            if area not in known:
                known[area] = disorder(view, area, falls)
            if known[area]:
                why = f"{node.value} looks up the nearest value in {area.a1}, which is not sorted"
                yield Finding(cell, "unsorted", why, "high", known[area])


def searched_line(node: Node, arguments: tuple[Area | str, ...]) -> tuple[Area | None, bool]:
    """Return the column, or row, in which a call looks up the nearest value, and whether it must fall."""
    parts, name = node.parts, node.value
    place, least = {"VLOOKUP": (3, 3), "HLOOKUP": (3, 3), "MATCH": (2, 2), "LOOKUP": (9, 2)}.get(name, (0, 99))
    if len(parts) < least or parts[1].kind != "argument":
        return None, False
    way = parts[place] if len(parts) > place else None
    exact = way is not None and (way.value in (0.0, "FALSE") or (way.kind == "other" and way.value is None))
    area = arguments[int(parts[1].value)]
    if exact or not isinstance(area, Area) or area.single:
        return None, False
    if name == "VLOOKUP":
        area = area._replace(right=area.left)
    elif name == "HLOOKUP":
        area = area._replace(bottom=area.top)
    return area, way is not None and way.kind == "operation"


def disorder(view: View, area: Area, falls: bool) -> str:
    """Return the first two numbers of a range that are not in order; nothing where all are, or some are computed."""
    if min(area.bottom - area.top, area.right - area.left) > 0:
        return ""
    cells = list(view.within(area))
    values = [view.numbers.get(cell) for cell in cells]
    for k in range(1, len(cells)):
        a, b = values[k - 1], values[k]
        if a is not None and b is not None and ((b > a) if falls else (b < a)):
            return f"{cells[k - 1].a1} has {a:g}, {cells[k].a1} has {b:g}"
    return ""


def unequal(lines: Lines) -> Iterator[Finding]:
    """Yield products and conditional sums of ranges that are not of the same rows."""
    view = lines.view
    for cell, form in view.forms.items():
        if not form.functions & {"SUMPRODUCT", "SUMIF", "AVERAGEIF", "SUMIFS", "CORREL", "SLOPE", "INTERCEPT"}:
            continue
        areas = [a for a in form.areas if not a.single and a.left == a.right]
        for first, second in pairwise(areas):
            apart = abs(first.top - second.top) + abs(first.bottom - second.bottom)
            if first.sheet == second.sheet and 0 < apart <= SHORT:
                why = f"its ranges {first.a1} and {second.a1} are not of the same rows"
                yield Finding(cell, "range", why, "high")
                break


RULES = (short, unsorted_lookups, unequal)
