"""How much work a file's formulas are, told before any of them is evaluated."""

from collections.abc import Sequence
from pathlib import Path

from workbook.book.columns import Moving, Pattern
from workbook.book.formula import Area
from workbook.errors import ReadError
from workbook.reading.contents import Patterns
from workbook.reading.files import BookFile

MOST = 500_000_000
"""cells that all formulas that are evaluated read together: up to 3,000,000 in the committed books; 160,000,000 in a
book of 3,600 intervals with 60 rows in each table of entries"""
MOST_COLUMNS = 50_000_000
"""columns that all formulas of a file read together, an engineer's own among them"""


def require_narrow(file: BookFile) -> None:
    """Raise ReadError, in one line, where it would be much work to tell what the formulas of a file depend on."""
    patterns, others = file.contents.patterns
    read = sum(wide(formula.arguments) for formula in others)
    read += sum(wide(pattern.arguments) * len(rows) for pattern, rows in patterns)
    if read > MOST_COLUMNS:
        raise ReadError(f"{file.path}: its formulas read {read:,} columns together; at most {MOST_COLUMNS:,} are "
                        "expected: make their ranges narrower")  # fmt: skip


def wide(arguments: Sequence[Area | str | Moving]) -> int:
    """Return how many columns the references of a formula reach over."""
    areas = [a.area if isinstance(a, Moving) else a for a in arguments if not isinstance(a, str)]
    return sum(len(area.columns) for area in areas)


def require_little_work(file: BookFile, path: Path) -> None:
    """Raise ReadError, in one line, where formulas of ``file``, a copy of ``path``, read more cells than any book's.

    Only what is evaluated is asked for; of running sums each reads all rows before.
    """
    read = cells_read(file.contents.patterns)
    if read > MOST:
        raise ReadError(f"{path}: its formulas read {read:,} cells together; at most {MOST:,} are expected: "
                        "shorten their ranges")  # fmt: skip


def cells_read(formulas: Patterns) -> int:
    """Return how many cells formulas read together, a cell counted as often as it is read."""
    patterns, others = formulas
    read = sum(a.size for formula in others for a in formula.arguments if isinstance(a, Area))
    for pattern, rows in patterns:
        fixed, growing = parted(pattern)
        read += fixed * len(rows) + sum(a.at(row).size for a in growing for row in rows)
    return read


def parted(pattern: Pattern) -> tuple[int, list[Moving]]:
    """Return how many cells a pattern's formulas read in every row, and the references that grow from row to row."""
    areas = [a.area if isinstance(a, Moving) else a for a in pattern.arguments if not isinstance(a, str)]
    growing = [a for a in pattern.arguments if isinstance(a, Moving) and (a.top is None) != (a.bottom is None)]
    growing = [a for a in growing if not a.area.single]
    return sum(a.size for a in areas) - sum(a.area.size for a in growing), growing
