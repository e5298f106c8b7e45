"""One pass over the XML of a workbook's part with expat, which keeps nothing: counts, lengths, and no entities.

The limits bound what openpyxl and the witnesses build from a part. They lie well above the largest book that the
templates can make, and mostly at or below Excel's own.
"""

from __future__ import annotations

import re
from functools import lru_cache
from posixpath import dirname, join, normpath
from xml.parsers import expat

from openpyxl.utils import column_index_from_string

MOST_CELLS = 600_000  # of the rectangles around the cells of all sheets: openpyxl fills them
MOST_IN_ROWS = 7 * MOST_CELLS  # elements and attributes inside of rows
MOST_OUTSIDE = 1_000_000  # elements, attributes and ranges outside of rows
MOST_OF = {"definedName": 20_000, "si": 200_000, "sheet": 250}
MOST_LONG = {"f": 8_192, "definedName": 8_192, "v": 32_767, "t": 32_767}  # characters; Excel's limits
MOST_FORMULAS = 20_000_000  # characters of all formulas and names, the shared ones written out
MOST_IN_TAG = 100_000  # characters of all attributes of one element
MOST_DEPTH = 100
LAST_ROW, LAST_COLUMN = 1_048_576, 16_384

FILLED = frozenset({"mergeCell", "hyperlink", "comment"})  # openpyxl visits every cell of their ranges
# openpyxl parses a part anew for each reference to it, and pivot caches anew for each sheet
REFERRING = frozenset({"sheet", "chart", "tablePart"})
RELATIONS = re.compile(r".*/(?:worksheet|chartsheet|drawing|chart|comments|table|pivotTable|sharedStrings|styles)")
CORNER = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")
SAVE_AS = "open it in Excel or LibreOffice and save it as .xlsx"


class Refusal(Exception):  # noqa: N818 - it says what it is
    """Why a file is refused, in words that follow its path."""


def shown(text: str) -> str:
    """Return a name from a file, short and without control characters."""
    return repr(text if len(text) <= 80 else f"{text[:77]}...")


@lru_cache(maxsize=20_000)
def column_number(letters: str) -> int:
    """Return the number of a column."""
    return column_index_from_string(letters.upper())


def corner(text: str) -> tuple[int, int]:
    """Return row and column of a cell; raise Refusal where a sheet has no such cell."""
    found = CORNER.fullmatch(text)
    if found is None:
        raise Refusal(f"damaged: {shown(text)} stands where a cell is expected; {SAVE_AS}")
    letters, digits = found.groups()
    row, column = int(digits), column_number(letters)
    if not (1 <= row <= LAST_ROW and column <= LAST_COLUMN):
        raise Refusal(f"holds a cell {shown(text)}; the last cell of a sheet is XFD1048576")
    return row, column


def size_of(ref: str) -> int:
    """Return the number of cells of a range."""
    first, _, last = ref.partition(":")
    top, left = corner(first)
    bottom, right = corner(last or first)
    return (abs(bottom - top) + 1) * (abs(right - left) + 1)


class Count:
    """What all parts of a workbook hold together; raises Refusal beyond each limit."""

    def __init__(self) -> None:
        self.cells = self.formulas = self.outside = self.in_rows = self.in_pivots = 0
        self.of = dict.fromkeys(MOST_OF, 0)
        self.referred: set[tuple[str, ...]] = set()

    def element(self, name: str, weight: int, in_pivot: bool) -> None:
        """Count an element outside of rows."""
        self.outside += weight
        self.in_pivots += weight if in_pivot else 0
        if name in self.of:
            self.of[name] += 1
            if self.of[name] > MOST_OF[name]:
                raise Refusal(f"holds more than {MOST_OF[name]:,} elements <{name}>")
        if self.outside + self.in_pivots * self.of["sheet"] > MOST_OUTSIDE:
            raise Refusal(f"holds more than {MOST_OUTSIDE:,} XML elements and attributes besides its cells")

    def reference(self, *key: str) -> None:
        """Note a reference to a part; refuse a second one."""
        if key in self.referred:
            raise Refusal(f"refers twice to {shown(key[-1])} as a part of its own; once is expected")
        self.referred.add(key)

    def in_row(self, weight: int) -> None:
        """Count an element of a row, with its attributes."""
        self.in_rows += weight
        if self.in_rows > MOST_IN_ROWS:
            raise Refusal(f"holds more than {MOST_CELLS:,} cells")

    def area(self, cells: int) -> None:
        """Count a rectangle of cells."""
        self.cells += cells
        if self.cells > MOST_CELLS:
            raise Refusal(f"its cells reach over {self.cells:,} places; at most {MOST_CELLS:,} are expected: "
                          "delete what lies far from the others")  # fmt: skip

    def formula(self, length: int) -> None:
        """Count the characters of a formula."""
        self.formulas += length
        if self.formulas > MOST_FORMULAS:
            raise Refusal(f"its formulas have more than {MOST_FORMULAS:,} characters together")


class Scan:
    """One pass over one part."""

    def __init__(self, name: str, count: Count) -> None:
        self.part, self.name, self.count = name, shown(name), count
        self.pivot = False
        self.depth = self.row_depth = 0  # the depth of the row that is open, or 0
        self.row = self.column = self.rows = self.columns = self.cells = 0
        self.inside = ""  # the element whose text is measured
        self.length = 0
        self.shared: dict[str, int] = {}  # characters of shared formulas, by their index
        self.master: str | None = None

    def read(self, data: bytes) -> None:
        """Read the part; raise Refusal where it is not well-formed, or not what a workbook may hold."""
        parser = expat.ParserCreate()
        parser.buffer_text = True
        parser.StartElementHandler = self.start
        parser.EndElementHandler = self.end
        parser.CharacterDataHandler = self.characters
        parser.StartDoctypeDeclHandler = self.doctype
        try:
            parser.Parse(data, True)
        except (expat.ExpatError, LookupError, UnicodeError) as error:  # the last two: an unknown encoding
            raise Refusal(f"damaged: {self.name} is not well-formed XML ({error}); {SAVE_AS}") from None
        self.count.area(max(self.rows * self.columns, self.cells))

    def doctype(self, *declared: object) -> None:
        """Refuse a document type, and with it every entity."""
        raise Refusal(f"{self.name} declares a document type or entities, which no spreadsheet program writes")

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Check an element by its name, whatever its prefix."""
        self.depth += 1
        if self.depth > MOST_DEPTH:
            raise Refusal(f"{self.name} is nested more than {MOST_DEPTH} deep")
        if attributes and sum(map(len, attributes.values())) > MOST_IN_TAG:
            raise Refusal(f"{self.name} holds an element with more than {MOST_IN_TAG:,} characters of attributes")
        name = tag.rpartition(":")[2] if ":" in tag else tag
        if self.row_depth:
            self.count.in_row(1 + len(attributes))
            if self.depth == self.row_depth + 1:
                self.cell(attributes.get("r"))
            elif name == "row":
                self.new_row(attributes.get("r"))
        elif name == "row":
            self.count.in_row(1 + len(attributes))
            self.new_row(attributes.get("r"))
        else:
            self.outside(name, attributes)
        if name in MOST_LONG:
            self.inside, self.length, self.master = name, 0, None
            if name == "f" and attributes:
                self.formula(attributes)
        elif name in FILLED and "ref" in attributes:
            self.count.area(size_of(attributes["ref"]))

    def outside(self, name: str, attributes: dict[str, str]) -> None:
        """Count an element outside of rows, and what it refers to."""
        if self.depth == 1:
            self.pivot = name.startswith("pivotCache")
        self.count.element(name, 1 + len(attributes) + len(attributes.get("sqref", "")) // 3, self.pivot)
        if name == "Relationship" and RELATIONS.fullmatch(attributes.get("Type", "")):
            folder = dirname(dirname(self.part))
            self.count.reference(normpath(join("/", folder, attributes.get("Target", ""))))
        elif name in REFERRING:
            for key, value in attributes.items():
                if key.rpartition(":")[2] == "id":
                    self.count.reference(self.part, name, value)

    def new_row(self, number: str | None) -> None:
        """Begin a row, numbered or next to the one before."""
        if not self.row_depth:
            self.row_depth = self.depth
        self.column = 0
        try:
            self.row = self.row + 1 if number is None else int(float(number))
        except (ValueError, OverflowError):
            raise Refusal(f"damaged: {self.name} has a row numbered {shown(number or '')}; {SAVE_AS}") from None

    def cell(self, at: str | None) -> None:
        """Place a cell, named or next to the one before."""
        if at:
            row, self.column = corner(at)
        else:
            row, self.column = self.row, self.column + 1
            if not (1 <= row <= LAST_ROW and self.column <= LAST_COLUMN):
                raise Refusal(f"{self.name} reaches beyond the last cell of a sheet, XFD1048576")
        if row > self.rows:
            self.rows = row
        if self.column > self.columns:
            self.columns = self.column
        self.cells += 1

    def formula(self, attributes: dict[str, str]) -> None:
        """Count a shared formula once more; one that has a text of its own may be shared from here."""
        if attributes.get("t") == "shared":
            self.master = attributes.get("si", "")
            self.count.formula(self.shared.get(self.master, 0))

    def end(self, tag: str) -> None:
        """Leave an element; count its formula."""
        if self.depth == self.row_depth:
            self.row_depth = 0
        self.depth -= 1
        if self.inside in ("f", "definedName"):
            self.count.formula(self.length)
            if self.master is not None and self.length:
                self.shared.setdefault(self.master, self.length)
        self.inside = ""

    def characters(self, text: str) -> None:
        """Measure a text."""
        if self.inside:
            self.length += len(text)
            if self.length > MOST_LONG[self.inside]:
                raise Refusal(f"{self.name} holds a text of more than {MOST_LONG[self.inside]:,} characters in one "
                              f"<{self.inside}>")  # fmt: skip
