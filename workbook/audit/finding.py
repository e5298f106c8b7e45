"""A finding of the audit, and how sure it is."""

from collections.abc import Sized
from dataclasses import dataclass
from typing import Literal

from workbook.book.address import Address

Sure = Literal["high", "medium", "low"]
SURE: tuple[Sure, ...] = ("high", "medium", "low")


@dataclass(frozen=True)
class Finding:
    """A cell that is probably not as meant: the rule, why in a sentence, how sure, and what the neighbours have."""

    cell: Address
    rule: str
    why: str
    sure: Sure = "medium"
    neighbours: str = ""

    @property
    def rank(self) -> tuple[int, Address]:
        """The place in a list: the surest first, then by cells."""
        return SURE.index(self.sure), self.cell


def many(cells: Sized) -> str:
    """Return how many cells have the same, in words behind a sentence; nothing for one cell."""
    return f" ({len(cells)} cells)" if len(cells) > 1 else ""
