"""The numbers that a chart shows, kept in the chart: previews and Protected View draw these, and compute nothing."""

from __future__ import annotations

import re
from html import unescape

from workbook.book.declare import Book
from workbook.writing.cells import result

NUMBERS = re.compile(rb"<numRef><f>([^<]*)</f></numRef>")


def filled(charts: dict[str, bytes], book: Book) -> dict[str, bytes]:
    """Return the parts of charts with the values of each range that a line, or its strokes, refer to."""
    ranges = {book.range(text): text for text in references(book)}
    known: dict[bytes, bytes] = {}

    def cached(found: re.Match[bytes]) -> bytes:
        range_ = found[1]
        if range_ not in known:
            cache = numbers(book, ranges[unescape(range_.decode())])
            known[range_] = b"<numRef><f>%s</f>%s</numRef>" % (range_, cache.encode())
        return known[range_]

    return {name: NUMBERS.sub(cached, part) for name, part in charts.items()}


def references(book: Book) -> set[str]:
    """Return the columns that the charts of a book refer to."""
    lines = [line for sheet in book.sheets for chart, *_ in sheet.charts for line in chart.series]
    return {text for line in lines for text in (line.x, line.y, line.up, line.right) if text}


def numbers(book: Book, reference: str) -> str:
    """Return the cache of one column (ISO/IEC 29500-1, 21.2.2.122); what is no number has no point."""
    values = book.values(reference)
    known = enumerate(result(value) for value in values)
    points = "".join(f'<pt idx="{i}">{value}</pt>' for i, (kind, value) in known if value and not kind)
    return f'<numCache><formatCode>General</formatCode><ptCount val="{len(values)}"/>{points}</numCache>'
