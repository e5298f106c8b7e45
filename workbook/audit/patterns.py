"""Rules on patterns: formulas, numbers and gaps among copied formulas; references that move or stay and should not."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence

from workbook.audit.finding import Finding, Sure
from workbook.audit.lines import FEW, Lines, Stretch, at, beside, cell_text, nearest, place
from workbook.audit.view import Form, View
from workbook.book.address import Address

ADDED = re.compile(r"=\+?A\d+(\+A\d+)+")  # a sum without SUM
SEVERAL = 4  # exceptions in a stretch that make a structure
TABLES = frozenset("VLOOKUP HLOOKUP LOOKUP XLOOKUP MATCH XMATCH RANK PERCENTRANK FORECAST".split())
AGGREGATES = frozenset("SUM AVERAGE MAX MIN COUNT COUNTA PRODUCT MEDIAN STDEV SUBTOTAL SUMPRODUCT SUMSQ".split())


def different(lines: Lines) -> Iterator[Finding]:
    """Yield formulas that differ from the pattern of their line."""
    view = lines.view
    for stretch in lines.stretches:
        others = [c for c in stretch.between if c in view.forms]
        if repeats(view, others, stretch.down):
            continue
        count = len(stretch.cells) if len(stretch.between) < SEVERAL else 0
        for cell in others:
            if not is_meant(lines, cell, stretch.down) and not totals(view, cell, stretch.down):
                yield misfit(view, cell, nearest(stretch, cell), count, any(stretch.modes))
    for cell, down, neighbour, at_end in lines.shifted:
        if not is_meant(lines, cell, down):
            near = {at(cell, down, max(1, place(cell, down) + k)) for k in (-1, 1)}
            count = FEW + (not at_end) if near.isdisjoint(view.numbers) else 0
            yield misfit(view, cell, neighbour, count, True)


def is_meant(lines: Lines, cell: Address, down: bool) -> bool:
    """Whether a cell that stands out does so with its neighbour, or is one of a pattern in the other direction."""
    across = (cell, not down)
    return lines.is_structure(cell, down) or (across in lines.members and across not in lines.between)


def misfit(view: View, cell: Address, neighbour: Address, count: int, moves: bool) -> Finding:
    """Return the finding of a formula that differs from a pattern, with how many cells have the pattern."""
    sure: Sure = ("high" if moves else "medium") if count > FEW else ("medium" if moves and count else "low")
    why = f"{view.text(cell)} differs from the formulas around it"
    return Finding(cell, "pattern", why, sure, cell_text(view, neighbour))


def repeats(view: View, cells: Sequence[Address], down: bool) -> bool:
    """Whether several of the cells have formulas of a form of their own, as subtotals have."""
    apart = (c for c in cells if at(c, down, place(c, down) - 1) not in cells)
    return any(count > 1 for count in Counter(view.forms[c].skeleton for c in apart).values())


def totals(view: View, cell: Address, down: bool) -> bool:
    """Whether a cell sums up, or counts, cells of its own line, or of a table by name."""
    form = view.forms[cell]
    own = [(a.left <= cell.column <= a.right) if down else (a.top <= cell.row <= a.bottom) for a in form.areas]
    if ADDED.fullmatch(form.skeleton):
        return any(own)
    ranges = [not a.single and o for a, o in zip(form.areas, own, strict=True)]
    return bool(form.functions & AGGREGATES) and (any(ranges) or not form.areas)


def typed_over(lines: Lines) -> Iterator[Finding]:
    """Yield numbers where the cells around have formulas, and cells that were emptied."""
    view = lines.view
    for stretch in lines.stretches:
        for cell in stretch.between:
            kind = lines.kind(cell)
            if kind in ("=", "a") or lines.is_structure(cell, stretch.down) or in_row(lines, cell, stretch):
                continue
            neighbour = cell_text(view, nearest(stretch, cell))
            if kind:
                pair = [at(cell, stretch.down, place(cell, stretch.down) + step) in view.numbers for step in (-1, 1)]
                anew = any(pair) or len(stretch.between) >= SEVERAL  # a series begins anew
                sure: Sure = "low" if anew or is_inserted(view, cell, stretch) else "high"
                why = f"the number {view.text(cell)} among formulas"
                yield Finding(cell, "typed-over", why, sure, neighbour)
            elif any(view.figure(c) for c in beside(cell, stretch.down)):
                yield Finding(cell, "gap", "an empty cell among formulas", "medium", neighbour)
        yield from at_the_end(lines, stretch)


def is_inserted(view: View, cell: Address, stretch: Stretch) -> bool:
    """Whether the formula behind a number goes on from that before it: the row was put in between."""
    down = stretch.down
    before, behind = (at(cell, down, max(1, place(cell, down) + step)) for step in (-1, 1))
    read = [a.first for a in view.forms[behind].areas if a.single] if behind in stretch.cells else []
    return before in read and cell not in read


def in_row(lines: Lines, cell: Address, stretch: Stretch) -> bool:
    """Whether a number stands among numbers to both sides, where the formulas of the stretch do not."""
    numbers = lines.view.numbers
    here = [c in numbers for c in beside(cell, stretch.down)]
    there = [c in numbers for c in beside(nearest(stretch, cell), stretch.down)]
    return any(h and not t for h, t in zip(here, there, strict=True))


def at_the_end(lines: Lines, stretch: Stretch) -> Iterator[Finding]:
    """Yield the number behind a pattern, where the pattern's formula would go on; a series may begin with a number."""
    view, down, end = lines.view, stretch.down, stretch.cells[-1]
    cell, behind = (at(end, down, place(end, down) + k) for k in (1, 2))
    if cell not in view.numbers or view.figure(behind) or lines.is_structure(cell, down):
        return
    if not in_row(lines, cell, stretch) and goes_on(lines, stretch, end):
        why = f"the number {view.text(cell)} where the pattern of formulas would go on"
        yield Finding(cell, "typed-over", why, "medium", cell_text(view, end))


def goes_on(lines: Lines, stretch: Stretch, end: Address) -> bool:
    """Whether the formula of the end of a pattern, copied on, reads figures, of its own line none."""
    view, down, form = lines.view, stretch.down, lines.view.forms[end]
    moved = False
    for n, area in enumerate(form.areas):
        first, last = area.first, Address(area.sheet, area.bottom, area.right)
        own = (area.left <= end.column <= area.right) if down else (area.top <= end.row <= area.bottom)
        if own and area.sheet == end.sheet and any(stretch.modes[2 * n : 2 * n + 2]):
            return False
        for cell, moves in ((first, stretch.modes[2 * n]), (last, stretch.modes[2 * n + 1])):
            if not view.figure(at(cell, down, place(cell, down) + moves)):
                return False
            moved |= moves
    return moved


def typed_totals(lines: Lines) -> Iterator[Finding]:
    """Yield numbers under, or over, a column of figures, beside formulas that sum up such columns."""
    view = lines.view
    for cell, form in view.forms.items():
        area = form.areas[0] if len(form.areas) == 1 and form.functions & AGGREGATES else None
        if area is None or area.single or not area.left == area.right == cell.column or area.sheet != cell.sheet:
            continue
        if area.top <= cell.row <= area.bottom or area.bottom - area.top < 2:
            continue
        for other in beside(cell, True):
            ends = (other._replace(row=row) for row in (area.top, area.top + 1, area.bottom))
            if other in view.numbers and all(end in view.forms for end in ends):
                why = f"the number {view.text(other)} beside a formula that sums up such a column"
                yield Finding(other, "typed-over", why, "medium", cell_text(view, cell))


def dollars(lines: Lines) -> Iterator[Finding]:
    """Yield references that lack a ``$`` their neighbours have, or have one they lack: wrong at the next copying."""
    view = lines.view
    for stretch in lines.stretches:
        if len(stretch.cells) < FEW + 1:
            continue
        kinds = defaultdict(list)
        for cell in stretch.cells:
            kinds[view.forms[cell].fixed].append(cell)
        most = max(kinds.values(), key=len)
        for cells in kinds.values():
            if len(cells) == 1 and len(most) >= FEW and len(kinds) == 2 and cells[0] not in (stretch.cells[0],):
                why = f"{view.text(cells[0])} has its $ elsewhere than the formulas around it"
                yield Finding(cells[0], "dollar", why, "medium", cell_text(view, most[-1]))


def wandering(lines: Lines) -> Iterator[Finding]:
    """Yield patterns whose reference moves from a figure to empty cells, texts or other figures."""
    view = lines.view
    for stretch in lines.stretches:
        forms = [view.forms[c] for c in stretch.cells]
        for n in range(0, len(stretch.modes), 2):
            area = forms[0].areas[n // 2]
            if not area.single or not stretch.modes[n] or not view.figure(area.first):
                continue
            met = [form.areas[n // 2].first for form in forms]
            off = next((k for k, c in enumerate(met) if not view.figure(c)), None)
            entry = place(met[0], stretch.down) == place(
                stretch.cells[0], stretch.down
            )  # of the row itself, and left empty
            if off is None or entry or off > min(2, len(met) // 2):
                continue
            if meets_figures(view, forms[off], stretch.modes, n):
                why = f"its reference to {met[0].a1} moves along with the cells, to {met[off].a1}"
                holds = "nothing" if view.empty(met[off]) else f"the text {view.text(met[off])!r}"
                yield Finding(stretch.cells[off], "moved-off", why, "high", f"{met[off].a1} has {holds}")


def meets_figures(view: View, form: Form, moves: Sequence[bool], but: int) -> bool:
    """Whether another moving reference of a formula still meets a figure: the row is not an empty one."""
    others = [area for n, area in enumerate(form.areas) if moves[2 * n] and 2 * n != but and area.single]
    return bool(others) and all(view.figure(area.first) for area in others) and "" not in form.texts


def stuck(lines: Lines) -> Iterator[Finding]:
    """Yield patterns that all read the figure in their first row, of a column that goes on beside them."""
    view = lines.view
    for stretch in lines.stretches:
        cells, down, model = stretch.cells, stretch.down, view.forms[stretch.cells[0]]
        for n, area in enumerate(model.areas):
            first = area.first
            if not area.single or stretch.modes[2 * n] or first.sheet != cells[0].sheet:
                continue
            others = [at(first, down, place(c, down)) for c in cells[1:]]
            if place(first, down) != place(cells[0], down) or not all(view.figure(c) for c in others):
                continue
            unread = view.read.isdisjoint(others)
            if unread or not any(stretch.modes):
                more = "none reads the figures behind it" if unread else "so all are the same"
                why = f"all {len(cells)} formulas read {first.a1}, and {more}"
                yield Finding(cells[1], "stuck", why, "high", cell_text(view, others[0]))


def moving_tables(lines: Lines) -> Iterator[Finding]:
    """Yield patterns of look-ups whose table moves along."""
    view = lines.view
    for stretch in lines.stretches:
        form = view.forms[stretch.cells[0]]
        for n, area in enumerate(form.areas if form.functions & TABLES else ()):
            size = area.bottom - area.top if stretch.down else area.right - area.left
            if size >= 2 and any(stretch.modes[2 * n : 2 * n + 2]):
                why = f"its table {area.a1} moves along with the cells"
                yield Finding(stretch.cells[1], "moved-off", why, "high", cell_text(view, stretch.cells[0]))
                break


RULES = (different, typed_over, typed_totals, dollars, wandering, stuck, moving_tables)
