"""What all parts of a workbook hold together, within limits.

They bound what openpyxl and the witnesses build: a machine of 24 axes with a drive each, at 720 samples, lies within
them, and what is larger is not built. Most are at or below Excel's own.
"""

SAVE_AS = "open it in Excel or LibreOffice and save it as .xlsx"


class Refusal(Exception):  # noqa: N818 - it says what it is
    """Why a file is refused, in words that follow its path."""


def shown(text: str) -> str:
    """Return a name from a file, short and without control characters."""
    return repr(text if len(text) <= 80 else f"{text[:77]}...")


MOST_PLACES = 5_000_000  # of the rectangles around the cells of all sheets
MOST_CELLS = 1_500_000  # that openpyxl makes
MOST_IN_ROWS = 7 * MOST_CELLS  # elements and attributes inside of rows
MOST_OUTSIDE = 1_000_000  # elements, attributes and ranges outside of rows
MOST_OF = {"definedName": 20_000, "si": 200_000, "sheet": 250}
MOST_LONG = {"f": 8_192, "definedName": 8_192, "v": 32_767, "t": 32_767}  # characters; Excel's limits
MOST_FORMULAS = 400_000_000  # characters of all formulas and names, the shared ones written out
MOST_IN_TAG = 100_000  # characters of all attributes of one element
MOST_DEPTH = 100


class Count:
    """What all parts of a workbook hold together; raises Refusal beyond each limit."""

    def __init__(self) -> None:
        self.places = self.filled = self.formulas = self.outside = self.in_rows = self.in_pivots = 0
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

    def area(self, places: int) -> None:
        """Count the rectangle around the cells of a sheet."""
        self.places = within(self.places + places, MOST_PLACES)

    def range(self, cells: int) -> None:
        """Count cells that openpyxl makes: of rows, and all in a range that is merged, linked or annotated."""
        self.filled = within(self.filled + cells, MOST_CELLS)

    def formula(self, length: int) -> None:
        """Count the characters of a formula."""
        self.formulas += length
        if self.formulas > MOST_FORMULAS:
            raise Refusal(f"its formulas have more than {MOST_FORMULAS:,} characters together")


def within(places: int, most: int) -> int:
    """Return the places that cells reach over, where they are not too many."""
    if places > most:
        raise Refusal(f"its cells reach over {places:,} places; at most {most:,} are expected, "
                      "and one that lies far from the others counts all between")  # fmt: skip
    return places
