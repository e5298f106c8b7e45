"""One pass over the XML of a workbook's part: counts, lengths, rows cell by cell, and no entities."""

import re
from collections.abc import Iterator
from contextlib import suppress
from posixpath import dirname, join, normpath
from typing import Any
from xml.etree.ElementTree import Element, ParseError, XMLPullParser
from xml.parsers import expat

from workbook.reading.rows import (
    FREE,
    MAIN,
    SAVE_AS,
    Mendable,
    Refusal,
    Rows,
    Totals,
    cell_position,
    refuse_two_texts,
    short,
    tag,
    text_of,
)

MOST_IN_TAG = 100_000  # characters of all attributes of an element
MOST_DEPTH = 100
CHUNK = 65_536  # bytes that are parsed before what they make is looked at
DATA, ROW, CELL = f"{MAIN}sheetData", f"{MAIN}row", f"{MAIN}c"
STRICT = "{http://purl.oclc.org/ooxml/spreadsheetml/main}"  # ISO/IEC 29500-1; Excel writes the other by default
AROUND_CELL = [f"{MAIN}worksheet", DATA, ROW]
# the elements of a worksheet that stand in a single place only, and what they stand in
PLACES = {DATA: AROUND_CELL[:1], ROW: AROUND_CELL[:2], CELL: AROUND_CELL}
# openpyxl visits every cell of their ranges
FILLED = frozenset({"mergeCell", "hyperlink", "comment"})
# openpyxl parses a part anew for each reference to it, and pivot caches anew for each sheet
REFERRING = frozenset({"sheet", "chart", "tablePart"})
RELATIONS = re.compile(r".*/(?:worksheet|chartsheet|drawing|chart|comments|table|pivotTable|sharedStrings|styles)")


def size_of(ref: str) -> int:
    """Return the number of cells of a range."""
    first, _, last = ref.partition(":")
    top, left = cell_position(first)
    bottom, right = cell_position(last or first)
    return (abs(bottom - top) + 1) * (abs(right - left) + 1)


def refuse_doctype(data: bytes, part: str) -> None:
    """Refuse a document type, which stands before the root of a part, and with it every entity."""

    def begun(*element: object) -> None:
        raise StopIteration

    def declared(*doctype: object) -> None:
        fault = "declares a document type or entities"
        raise Refusal(f"{part} {fault}, which no spreadsheet program writes")

    parser = expat.ParserCreate()
    parser.StartDoctypeDeclHandler, parser.StartElementHandler = declared, begun
    # what else is wrong, reading tells
    with suppress(StopIteration, expat.ExpatError, LookupError, ValueError):
        parser.Parse(data, True)


class Scan:
    """One pass over a part: its ``root``, and the ``rows`` of a worksheet, whose root is without them."""

    def __init__(self, name: str, count: Totals) -> None:
        self.part, self.name, self.count = name, short(name), count
        self.root = Element("nothing")
        self.rows: Rows | None = None
        self._pivot = self._in_row = self._met = False
        self._path: list[str] = []  # the elements that are open

    def read(self, data: bytes) -> None:
        """Read the part; raise Refusal where it is not well-formed, or not what a workbook may hold."""
        refuse_doctype(data, self.name)
        parser: XMLPullParser[Any] = XMLPullParser(("start", "end", "start-ns", "comment", "pi"))
        try:
            for begin in range(0, max(len(data), 1), CHUNK):
                parser.feed(data[begin : begin + CHUNK])
                events: Iterator[Any] = parser.read_events()
                for event, element in events:
                    if event == "end":
                        self.end(element)
                    elif event == "start":
                        self.start(element)
                    else:
                        self.aside(element)
            parser.close()
        except (ParseError, LookupError, ValueError) as error:  # the last two: an unknown encoding
            raise Mendable(f"damaged: {self.name} is not well-formed XML ({error})") from None
        if self.rows:
            self.count.range(len(self.rows.written), self.rows.size)

    def start(self, element: Element) -> None:
        """Begin an element: check and count it."""
        path, attributes = self._path, element.attrib
        if attributes and sum(map(len, attributes.values())) > MOST_IN_TAG:
            most = f"more than {MOST_IN_TAG:,} characters of attributes"
            raise Refusal(f"{self.name} holds an element with {most}")
        if not path and element.tag.startswith(STRICT):
            kind = "Strict Open XML"
            raise Refusal(f"a {kind} workbook; {SAVE_AS} (Excel Workbook, not {kind})")
        if not path:
            self.root, self._pivot = element, tag(element).startswith("pivotCache")
            self.rows = Rows(self.name, self.count) if element.tag == f"{MAIN}worksheet" else None
        elif element.tag in PLACES and self.rows is not None:
            self._place(self.rows, element)
        if self._in_row and 2 < len(path) < 5:
            self.count.in_row(1 + len(attributes))
        else:
            self._outside(tag(element), attributes)
        path.append(element.tag)
        if len(path) > MOST_DEPTH:
            raise Refusal(f"{self.name} is nested more than {MOST_DEPTH} deep")

    def _place(self, rows: Rows, element: Element) -> None:
        """Begin a worksheet's data, which it has once, or a row or a cell in it; refuse them anywhere else."""
        if self._path != PLACES[element.tag] or (element.tag == DATA and self._met):
            raise Mendable(f"damaged: {self.name} holds <{tag(element)}> twice or out of its place")
        self._met = True
        if element.tag == ROW:
            rows.begin(element.attrib)
            self._in_row = True

    def _outside(self, name: str, attributes: dict[str, str]) -> None:
        """Count an element outside of rows, and what it refers to."""
        ranges = len(attributes.get("sqref", "")) // 3
        self.count.element(name, 1 + len(attributes) + ranges, self._pivot)
        if name in FILLED and "ref" in attributes:
            self.count.range(size_of(attributes["ref"]))
        if name == "Relationship" and RELATIONS.fullmatch(attributes.get("Type", "")):
            folder = dirname(dirname(self.part))
            self.count.reference(normpath(join("/", folder, attributes.get("Target", ""))))
        elif name in REFERRING:
            for key, value in attributes.items():
                if key.rpartition("}")[2] == "id":
                    self.count.reference(self.part, name, value)

    def end(self, element: Element) -> None:
        """End an element: take a cell, measure a text."""
        self._path.pop()
        if self._in_row and self.rows is not None:
            if element.tag == CELL:
                self.rows.cell(element)
                element.clear()
            elif element.tag == ROW:
                self.rows.require_within(element)
                self._in_row = False
                element.clear()
            return
        name = tag(element)
        text = text_of(element, name, self.name)
        if name == "definedName":
            self.count.formula(len(text))
        elif name == "si":
            refuse_two_texts(element, self.name)
        elif element.tag == DATA:
            element.clear()

    def aside(self, event: object) -> None:
        """Refuse a comment, or a namespace, within a row: some readers take what stands before it only."""
        if self._in_row and FREE.isdisjoint(self._path):
            what = "a namespace of its own" if isinstance(event, tuple) else "a comment"
            raise Mendable(f"damaged: {self.name} holds {what} within a row")
