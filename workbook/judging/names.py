"""Whether the defined names of a file still lead where they should: names are how cells are told apart."""

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from workbook.book.address import Place
from workbook.book.declare import FIRST, Block
from workbook.judging.matching import Match
from workbook.judging.report import Finding
from workbook.reading.files import is_formula


def finding(place: Place, name: str, found: str, expected: str) -> Finding:
    """Return what is told of a name that leads elsewhere: where it leads, what is found there, what was expected."""
    return Finding(place.sheet, place.cell(0, 0).a1, "name", f"{name}: {found}", expected)


def misled(match: Match) -> Iterator[Finding]:
    """Yield names that lead elsewhere than when the book was generated, rows and columns inserted or not."""
    for name, fit in match.file.fits.items():
        if fit.named is not None:  # of a single cell, that leads to more than one
            yield finding(fit.place, name, said(fit.named), said(fit.place))
    for found in (columns, strays, mislabelled, wordy, disordered):
        yield from found(match)


def columns(match: Match) -> Iterator[Finding]:
    """Yield names of a table's column, or of several side by side, that are not those."""
    places = match.file.places
    for name, (table, column) in match.declared.column_names.items():
        block, place = match.declared.blocks[table], places.get(table)
        if place is None:
            continue
        first, last = (place.part(one - block.column) for one in block.ends(column))
        right, found = (first.corners[0], last.corners[1]), places.get(name)
        if first.column and last.column and (found is None or found.corners != right):
            yield finding(
                found or first, name, said(found), said(first._replace(columns=last.column - first.column + 1))
            )


def strays(match: Match) -> Iterator[Finding]:
    """Yield the first of the blocks that lie on another sheet than the rest of theirs, and how many there are."""
    for sheet in match.declared.sheets:
        placed = [(b, match.file.places[b.name]) for b in sheet.blocks if b.name in match.file.places]
        counted = Counter(place.sheet for _, place in placed).most_common(1)
        away: dict[str, list[tuple[Block, Place]]] = {}
        for block, place in placed:
            if place.sheet != counted[0][0]:
                away.setdefault(place.sheet, []).append((block, place))
        for title, ((first, place), *more) in away.items():
            found = f"the sheet {title}" + (f", and so do {len(more)} more" if more else "")
            yield finding(place, first.name, found, f"the sheet {counted[0][0]}, with the others: move it back")


def mislabelled(match: Match) -> Iterator[Finding]:
    """Yield single cells that stand beside another label or heading; words of the engineer's own are none of these."""
    for sheet in match.declared.sheets:
        single = [b for b in sheet.blocks if not b.is_table]
        labels = {text.text for text in sheet.texts if text.column == FIRST}
        for block in single:
            place = match.file.places.get(block.name)
            beside = texts_beside(match, place) & labels if place else set()
            label = block.quantities[0].beside
            if place and beside and label not in beside and not itself(match, block, place):
                yield finding(place, block.name, f"the row {sorted(beside)[0]!r}", f"the row {label!r}")


def itself(match: Match, block: Block, place: Place) -> bool:
    """Whether a cell is the declared one for all that its label says otherwise: by its formula, its symbol and unit."""
    pair = next((p for p in match.pairs if p.cell.block is block), None)
    if pair is not None and pair.declared_formula:
        return is_formula(pair.held) and match.same_shape(pair)
    q = block.quantities[0]
    around = texts_beside(match, place) | {str(match.file.value(place.cell(0, 1)))}
    return bool(q.symbol) and {text for text in (q.symbol, q.unit) if text} <= around


def wordy(match: Match) -> Iterator[Finding]:
    """Yield inputs that hold a text or nothing, as any cell may, in another column than the others or by no label."""
    for sheet in match.declared.sheets:
        single = [b for b in sheet.blocks if not b.is_table and b.name in match.file.places]
        places = {b.name: match.file.places[b.name] for b in single}
        usual = {c: Counter(places[b.name].column for b in single if b.column == c) for c in {b.column for b in single}}
        for block in single:
            quantity, place = block.quantities[0], places[block.name]
            held = match.file.value(place.cell(0, 0))
            if quantity.role != "input" or not (held is None or isinstance(held, str)):
                continue
            column = usual[block.column].most_common(1)[0][0]
            if place.column != column or not texts_beside(match, place):
                yield finding(
                    place, block.name, said(place), f"the cell of {quantity.label!r}, below or above the others"
                )


def texts_beside(match: Match, place: Place) -> set[str]:
    """Return the texts to the left of a place, in its row."""
    cells = (match.file.value(place.cell(0, -j)) for j in range(1, place.column))
    return {text for text in cells if isinstance(text, str)}


def disordered(match: Match) -> Iterator[Finding]:
    """Yield tables of the same columns, and cells of the same label, that have changed places with one another."""
    alike: dict[tuple[str, ...], list[tuple[Block, Place]]] = {}
    for sheet in match.declared.sheets:
        for block in sheet.blocks:
            if block.name in match.file.places and block.name not in match.headless:
                what = [q.name for q in block.quantities] if block.is_table else [block.quantities[0].label]
                alike.setdefault((sheet.title, *what), []).append((block, match.file.places[block.name]))
    for blocks in alike.values():
        for (before, first), (after, second) in pairwise(blocks):
            in_order = first.sheet != second.sheet or first[:3] < second[:3]  # another sheet is what strays() tells
            if not in_order and not (headed(match, before, first) and headed(match, after, second)):
                yield finding(second, after.name, f"above or left of {before.name}", f"below {before.name}")


def headed(match: Match, block: Block, place: Place) -> bool:
    """Whether the heading that is declared for a block is the one that is nearest above it in the file."""
    headings = {text.text: text.row for text in block.sheet.texts if text.style == "heading"}
    above = [text for text, row in headings.items() if row < block.row]
    if not above:
        return False
    found = ((r, cell.value) for (r, _), cell in match.file.workbook[place.sheet]._cells.items()
             if r < place.row and isinstance(cell.value, str) and cell.value in headings)  # fmt: skip
    return max(found, default=(0, ""))[1] == max(above, key=lambda text: headings[text])


def said(place: Place | None) -> str:
    """Return a place in words."""
    if place is None:
        return "no cells"
    first, last = place.corners
    return f"{first}:{last.a1}"
