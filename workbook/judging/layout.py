"""Rows put into tables: a finding each, and what follows from it."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby

from workbook.book.address import Address
from workbook.book.declare import Block
from workbook.judging.matching import Match
from workbook.judging.report import FOLLOWS, LAYOUT, Finding, Report

FOLLOWING = frozenset(("value", "error", "saved"))
SPARE = "no row between the table's own: delete it, and enter what it should hold in a spare row"


def layout_findings(match: Match) -> Iterator[Finding]:
    """Yield a finding for rows of a sheet that were put into tables."""
    inserted = defaultdict[tuple[str, int], list[Block]](list)
    for name, rows in match.file.inserted.items():
        for row in rows:
            inserted[match.file.places[name].sheet, row].append(match.declared.blocks[name])
    for _, run in groupby(enumerate(sorted(inserted)), key=lambda pair: (pair[1][0], pair[1][1] - pair[0])):
        places = [place for _, place in run]
        (sheet, first), (_, last) = places[0], places[-1]
        change = f"row {first} was inserted" if first == last else f"rows {first} to {last} were inserted"
        yield Finding(sheet, f"{first}:{last}", LAYOUT, change, SPARE, table_titles(inserted[places[0]]))


def table_titles(blocks: list[Block]) -> str:
    """Return which tables they are: the heading of the first, and the names of all."""
    block, names = blocks[0], [b.name for b in blocks]
    above = [text for text in block.sheet.texts if text.style == "heading" and text.row < block.row]
    heading = max(above, key=lambda text: text.row).text if above else block.title
    return f"{heading}: the table {names[0]}" if len(names) == 1 else f"{heading}: the tables {', '.join(names)}"


def mark_consequences(match: Match, report: Report, suspects: set[Address]) -> None:
    """Mark the wrong values that follow from rows put into tables: formulas count the rows of their ranges."""
    formulas = {(p.address.sheet, p.address.a1): p.address for p in match.pairs} if match.file.inserted else {}
    for n, finding in enumerate(report.findings):
        at = formulas.get((finding.sheet, finding.cell))
        if at is not None and finding.kind in FOLLOWING and at not in suspects:
            report.findings[n] = replace(finding, kind=FOLLOWS)
