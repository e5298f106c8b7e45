"""What a witness is: something that takes a workbook file and says what each formula cell computes."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Protocol, runtime_checkable

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.reading.refusal import Refusal
from workbook.reading.saved import values_within

Found = Callable[[Address, Any], Any]  # what is found in a cell; else what a cell without a formula holds


class Witness(Protocol):
    """One way to evaluate a workbook, independent of the others; one that only kept values is always asked."""

    name: str
    kept: bool

    def version(self) -> str | None:
        """Return the version of the program that evaluates, or None where it is not on this machine."""

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell; raise WitnessError where that cannot be had."""


class Known(Protocol):
    """What stands in cells."""

    def get(self, address: Address, default: Any = None) -> Any:
        """Return what is found in a cell; ``default`` where that is not known."""

    def all(self, cells: Iterable[tuple[Address, Any]]) -> list[Any]:
        """Return what is found in each of ``cells``, which come with their defaults."""


class Model(Protocol):
    """A file's formulas as a witness holds them, to be evaluated again and again."""

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""

    def each(self, wanted: Iterable[Address], found: Found) -> Cells:
        """Return the value of each formula cell of ``wanted`` by itself, with ``found`` in the cells it refers to."""

    def later(self, wanted: Iterable[Address], known: Known) -> Callable[[], Cells]:
        """Ask for what :meth:`each` returns with what is ``known`` of cells, and return what waits for it."""


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
