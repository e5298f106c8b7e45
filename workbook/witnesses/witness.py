"""What a witness is: something that takes a workbook file and says what each formula cell computes."""

import io
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol, runtime_checkable

from workbook.book.address import Address, Strip
from workbook.errors import WitnessError
from workbook.reading.cells import values_within
from workbook.reading.contents import Cells
from workbook.reading.count import Refusal
from workbook.reading.files import BookFile

CYCLE = "#CYCLE!"
"""what a witness has for a cell that computes from itself, or from cells that do: no program shows it"""


class Witness(Protocol):
    """One way to evaluate a workbook, independent of the others; one that only kept values is always asked."""

    name: str
    kept: bool

    def version(self) -> str | None:
        """Return the version of the program that evaluates, or None where it is not on this machine."""

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell; raise WitnessError where that cannot be had."""


class Model(Protocol):
    """A file's formulas as a witness holds them, to be evaluated again and again."""

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""

    def each(
        self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]
    ) -> Callable[[], Sequence[Any]]:
        """Begin with the values of formula cells, each by itself, with ``values`` in the cells of ``strips``.

        Return what gives them. ``wanted`` are the numbers of the cells within ``strips``; a cell that is in none holds
        what it has without a formula.
        """


@runtime_checkable
class CellWitness(Witness, Protocol):
    """A witness that can also evaluate each cell by itself: so a fault shows in its own cell only."""

    def model(self, file: BookFile) -> Model:
        """Return the formulas of a file."""


def cached_values(data: bytes, file: BookFile) -> Cells:
    """Return what another copy of the file holds as results of the formula cells of ``file``."""
    try:
        held = values_within(io.BytesIO(data), len(data))
    except Refusal as refusal:
        raise WitnessError(f"what it wrote cannot be read: {refusal}") from None
    return {a: held.get(a) for a in file.contents.formula_cells}
