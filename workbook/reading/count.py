"""What all parts of a workbook hold together, within limits.

The limits bound what openpyxl and the witnesses build from a part. They lie well above the largest book that the
templates can make, and mostly at or below Excel's own.
"""

from __future__ import annotations

from workbook.reading.refusal import Refusal, shown

MOST_CELLS = 1_500_000  # of the rectangles around the cells of all sheets: openpyxl fills them
MOST_IN_ROWS = 7 * MOST_CELLS  # elements and attributes inside of rows
MOST_OUTSIDE = 1_000_000  # elements, attributes and ranges outside of rows
MOST_OF = {"definedName": 20_000, "si": 200_000, "sheet": 250}
MOST_LONG = {"f": 8_192, "definedName": 8_192, "v": 32_767, "t": 32_767}  # characters; Excel's limits
MOST_FORMULAS = 200_000_000  # characters of all formulas and names, the shared ones written out
MOST_IN_TAG = 100_000  # characters of all attributes of one element
MOST_DEPTH = 100


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
