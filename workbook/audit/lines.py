"""Lines of formulas that are copied down or to the right, and the cells among them that are something else."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from workbook.audit.view import Form, View, spans
from workbook.book.address import Address

GAP = 2  # cells side by side in a line that may be something else
FEW = 3  # formulas that make a pattern


@dataclass
class Stretch:
    """Cells in a line that have a formula of the same form, and the cells among them that have not."""

    down: bool
    cells: list[Address]
    between: list[Address]
    modes: list[bool] = field(default_factory=list)  # of each side of a reference: whether it moves with the cell


def place(cell: Address, down: bool) -> int:
    """Return the row of a cell in a column, or its column in a row."""
    return cell.row if down else cell.column


def at(cell: Address, down: bool, where: int) -> Address:
    """Return the cell of the same line at another place."""
    return cell._replace(row=where) if down else cell._replace(column=where)


def beside(cell: Address, down: bool) -> tuple[Address, Address]:
    """Return the cells to both sides of a line."""
    return at(cell, not down, place(cell, not down) - 1), at(cell, not down, place(cell, not down) + 1)


class Lines:
    """All stretches of a workbook, and what stands out in them."""

    def __init__(self, view: View) -> None:
        self.view = view

    @cached_property
    def stretches(self) -> list[Stretch]:
        """The stretches of all columns and rows that make a pattern."""
        view, every = self.view, list[Stretch]()
        for down, lines in ((True, view.columns), (False, view.rows)):
            for (sheet, line), places in lines.items():
                for first, last in spans(places, GAP):
                    cells = [
                        Address(sheet, k, line) if down else Address(sheet, line, k) for k in range(first, last + 1)
                    ]
                    every += (s for s in self.along(cells, down) if len(s.cells) >= FEW)
        return every

    def along(self, cells: Sequence[Address], down: bool) -> Iterator[Stretch]:
        """Yield the stretches of a line of cells."""
        keys = [self.view.forms[c].across(down) if c in self.view.forms else None for c in cells]
        k = 0
        while k < len(cells):
            if keys[k] is None:
                k += 1
                continue
            members, between, end = [k], list[int](), k
            while True:
                following = range(end + 1, min(end + 2 + GAP, len(cells)))
                after = next((n for n in following if keys[n] == keys[k]), None)
                if after is None:
                    break
                between += range(end + 1, after)
                members.append(after)
                end = after
            stretch = Stretch(down, [cells[n] for n in members], [cells[n] for n in between])
            form = self.view.forms[cells[k]]
            is_copied = len(members) > 1 and len(between) * 4 <= len(members) + 1
            if is_copied and form.areas and not self.picks(stretch):
                stretch.modes = modes(self.view, stretch)
                yield stretch
                k = end + 1
            else:
                k += 1

    def picks(self, stretch: Stretch) -> bool:
        """Whether $B$31 alone, or $B$31-$B$3 above $B$34-$B$3, picks figures, and is copied nowhere."""
        first, *others = (self.view.forms[cell] for cell in stretch.cells)
        apart = first.skeleton == "=A1" or any(form.areas != first.areas for form in others)
        return apart and all(map(all, first.fixed))

    @cached_property
    def members(self) -> dict[tuple[Address, bool], Stretch]:
        """The stretch of each cell, by the direction."""
        return {(c, s.down): s for s in self.stretches for c in s.cells}

    @cached_property
    def between(self) -> set[tuple[Address, bool]]:
        """The cells that are among a pattern's, with the direction, but are something else."""
        there = {(cell, s.down) for s in self.stretches for cell in s.between}
        return there | {(cell, down) for cell, down, _, _ in self.shifted}

    @cached_property
    def shifted(self) -> list[tuple[Address, bool, Address, bool]]:
        """Cells whose references lie elsewhere than the pattern's: cell, direction, a neighbour, whether at the end."""
        return [row for stretch in self.stretches for row in shifted(self.view, stretch)]

    def is_structure(self, cell: Address, down: bool) -> bool:
        """Whether a cell stands out together with its neighbour in the next line, or by the same formula in others."""
        kind = self.kind(cell)
        if kind == "=" and any(self.alike[key] > 1 for key in self.lines_of(cell, down)):
            return True
        return any((c, down) in self.between and self.kind(c) == kind for c in beside(cell, down))

    @cached_property
    def alike(self) -> Counter[object]:
        """The number of formulas of each form that stand out across the lines, and along each."""
        return Counter(k for c, down in self.between if c in self.view.forms for k in self.lines_of(c, down))

    def lines_of(self, cell: Address, down: bool) -> tuple[object, object]:
        """Return the lines across and along a formula, each with what stays the same of it there."""
        form = self.view.forms[cell]
        along = cell.column if down else cell.row
        return (down, cell.sheet, place(cell, down), form.skeleton), (down, cell.sheet, along, form.across(down))

    def kind(self, cell: Address) -> str:
        """Return whether a cell has a formula, a number, a text or nothing."""
        view = self.view
        return next((n for n, c in (("=", view.forms), ("1", view.numbers), ("a", view.texts)) if cell in c), "")


def modes(view: View, stretch: Stretch) -> list[bool]:
    """Return of each side of the references of a stretch whether it moves: what most neighbours say, or their ``$``."""
    forms = [view.forms[c] for c in stretch.cells]
    places = [place(c, stretch.down) for c in stretch.cells]
    sides = [f.along(stretch.down) for f in forms]
    result = []
    for n in range(len(sides[0])):
        moves = stays = 0
        for k in range(1, len(sides)):
            moves += sides[k][n] - sides[k - 1][n] == places[k] - places[k - 1]
            stays += sides[k][n] == sides[k - 1][n]
        result.append(moves > stays if moves != stays else not has_dollar(forms[0], n, stretch.down))
    return result


def has_dollar(form: Form, side: int, down: bool) -> bool:
    """Whether a side of a form's references, by its number, is fixed."""
    return form.fixed[side // 2][(0, 2)[side % 2] if down else (1, 3)[side % 2]]


def shifted(view: View, stretch: Stretch) -> Iterator[tuple[Address, bool, Address, bool]]:
    """Yield the cells of a stretch whose references are not where those of the cells around have them."""
    cells, down = stretch.cells, stretch.down
    if len(cells) < FEW + 1:
        return
    offsets = [offset(view, cell, stretch) for cell in cells]
    runs = [k for k in range(len(cells)) if k == 0 or offsets[k] != offsets[k - 1]] + [len(cells)]
    for n, (first, last) in enumerate(pairwise(runs)):
        others = runs[min(n + 2, len(runs) - 1)] - runs[max(n - 1, 0)] - (last - first)
        if n == 0 or last - first > GAP or others < max(FEW, 3 * (last - first)):
            continue
        if last < len(cells) and offsets[first - 1] == offsets[last]:
            yield from ((cells[k], down, cells[first - 1], False) for k in range(first, last))
        elif last == len(cells) and last - first == 1 and len(runs) == 3:
            yield cells[first], down, cells[first - 1], True


def offset(view: View, cell: Address, stretch: Stretch) -> tuple[int, ...]:
    """Return where the references of a cell lie, from the cell where they move with it."""
    sides = zip(view.forms[cell].along(stretch.down), stretch.modes, strict=True)
    return tuple(side - place(cell, stretch.down) * moves for side, moves in sides)


def cell_text(view: View, cell: Address) -> str:
    """Return a cell with its content, in words."""
    return f"{cell.a1} has {view.text(cell) or 'nothing'}"


def nearest(stretch: Stretch, cell: Address) -> Address:
    """Return the cell of a stretch that is nearest to a cell."""
    down = stretch.down
    return min(stretch.cells, key=lambda c: abs(place(c, down) - place(cell, down)))
