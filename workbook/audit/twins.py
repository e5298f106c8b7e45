"""Figures that stand twice: the same label with another value, tables that drifted, entries that nobody reads."""

from collections import defaultdict
from collections.abc import Iterator

from workbook.audit.finding import Finding, Sure
from workbook.audit.lines import Lines, cell_text
from workbook.audit.units import Units
from workbook.audit.view import View
from workbook.book.address import Address
from workbook.reading.contents import plain_label

ALIKE = 0.85  # of the labels of two sheets that make them twins
TYPICAL = frozenset("0 1 2 3 4 5 6 7 8 9 10 12 15 16 20 24 25 30 32 36 50 60 90 100 180 360 365 1000 3600".split())

Key = tuple[str, str]


def figures_by_label(view: View) -> dict[str, dict[Key, Address]]:
    """Return for each sheet its figures by label and heading, those left out that stand under the same twice."""
    sheets: dict[str, dict[Key, list[Address]]] = defaultdict(lambda: defaultdict(list))
    for cell in view.headings:
        left, above = view.labels(cell)
        if len(left) >= 3 and any(map(str.isalpha, left)):
            sheets[cell.sheet][plain_label(left), "" if view.beside(cell) == left else plain_label(above)].append(cell)
    return {s: {key: cells[0] for key, cells in keys.items() if len(cells) == 1} for s, keys in sheets.items()}


def twins(lines: Lines, units: Units) -> Iterator[Finding]:
    """Yield cells of two sheets that have the same label and another value or formula."""
    view, sheets = lines.view, figures_by_label(lines.view)
    titles, apart = sorted(sheets), defaultdict[str, list[tuple[Address, Address]]](list)
    for n, first in enumerate(titles[:40]):
        for second in titles[n + 1 : 40]:
            shared = sheets[first].keys() & sheets[second].keys()
            pairs = [(sheets[first][key], sheets[second][key], key[0]) for key in sorted(shared)]
            if len(shared) >= max(5, ALIKE * max(len(sheets[first]), len(sheets[second]))):
                for a, b, label in drifted_twins(view, pairs):
                    apart[label].append((a, b))
            elif len(shared) <= 3:
                yield from contradicting(view, units, pairs)
    for label, rows in apart.items():
        yield from odd(view, label, rows)


def odd(view: View, label: str, rows: list[tuple[Address, Address]]) -> Iterator[Finding]:
    """Yield where a sheet computes a figure otherwise than all its copies do; where several do, it is meant."""
    titles = set.intersection(*({a.sheet, b.sheet} for a, b in rows))
    for a, b in rows if len(titles) == 2 else rows[:1] if titles else ():
        if a.sheet not in titles:
            a, b = b, a
        why = f"{label!r} is computed otherwise than on {b.sheet}, and the others are computed alike"
        yield Finding(a, "drifted", why, "medium", f"{b.sheet}: {cell_text(view, b)}")


def drifted_twins(view: View, pairs: list[tuple[Address, Address, str]]) -> list[tuple[Address, Address, str]]:
    """Return where two sheets that are copies of each other differ, if they differ in little."""
    formulas = [(a, b, label) for a, b, label in pairs if a in view.forms or b in view.forms]
    apart = [row for row in formulas if outline(view, row[0]) != outline(view, row[1])]
    return apart if len(formulas) >= 4 and len(apart) <= max(1, len(formulas) // 20) else []


def outline(view: View, cell: Address) -> object:
    """Return a formula by its form, and by the labels of the cells it reads; of a number only that it is none."""
    form = view.forms.get(cell)
    if form is None:
        return None
    sides = tuple(view.labels(a.first)[0] for a in form.areas)
    return form.skeleton, form.numbers, sides


def contradicting(view: View, units: Units, pairs: list[tuple[Address, Address, str]]) -> Iterator[Finding]:
    """Yield two entered numbers of the same label and unit that differ; a label of a word may be another thing's."""
    for a, b, label in pairs:
        same_unit = units.of.get(a, "") == units.of.get(b, "")
        coded = any(map(str.isdigit, label))  # the name of an axis or a part
        differ = a in view.numbers and b in view.numbers and view.numbers[a] != view.numbers[b]
        used = a in view.read or b in view.read  # tables of data do not contradict
        if differ and used and same_unit and not coded:
            sure: Sure = "medium" if len(label.split()) > 1 or (units.of.get(a) and len(label) > 4) else "low"
            why = f"{label!r} is {view.text(b)} in {b.a1} on {b.sheet}"
            yield Finding(a, "other-value", why, sure, f"{b.sheet}: {cell_text(view, b)}")


def unread(lines: Lines, units: Units) -> Iterator[Finding]:
    """Yield entered numbers that no formula reads, where a formula has the number itself, or all others are read."""
    view = lines.view
    typed: dict[float, list[Address]] = defaultdict(list)
    for cell, form in view.forms.items():
        for number in set(form.numbers) - TYPICAL:
            typed[float(number)].append(cell)
    for cell, value in view.numbers.items():
        if cell in view.read:
            continue
        label, why = view.beside(cell), "no formula reads it; those above it are read"
        if label and not any(map(str.isdigit, label)):
            writers = [w for w in typed.get(float(value), ()) if w.sheet == cell.sheet or is_special(value)]
            for writer in writers[:1]:
                why = f"it has {value:g}, which {cell.a1} on {cell.sheet} is for, and no formula reads that"
                yield Finding(writer, "typed-in", why, "high", cell_text(view, cell))
        elif alone(view, cell):
            yield Finding(cell, "unread", why, "medium", cell_text(view, cell._replace(row=cell.row - 1)))


def is_special(value: float) -> bool:
    """Whether a number has so many digits that it hardly stands twice by chance."""
    return len(f"{value:g}".replace(".", "").strip("0-")) >= 3


def alone(view: View, cell: Address) -> bool:
    """Whether a number is the only unread among the numbers that stand one below the other."""
    top, bottom = view.blocks[cell]
    if bottom - top < 3 or bottom - top > 2_000:
        return False
    cells = [cell._replace(row=row) for row in range(top, bottom + 1)]
    only = sum(c not in view.read for c in cells) == 1 and cell.row > top  # with the first a series begins
    return only and all(c in view.numbers for c in cells)


RULES = (twins, unread)
