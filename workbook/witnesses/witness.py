"""What a witness is: something that takes a workbook file and says what each formula cell computes."""

import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, Protocol, runtime_checkable

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


class Stated(Protocol):
    """What stands in strips of cells, one after the other."""

    @property
    def values(self) -> Sequence[Any]:
        """The values, as many as the strips have cells."""


class Turn(NamedTuple):
    """Cells to be computed at other inputs, by their numbers within strips, and what gives the values in these."""

    wanted: Sequence[int]
    stated: Callable[[], Any]  # a Stated: it may be called in another process


Answers = Iterator[tuple[Sequence[Any], Any]]  # of each turn: what its cells compute, and the Stated


class Model(Protocol):
    """A file's formulas as a witness holds them, to be evaluated again and again."""

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""

    def each(self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> Sequence[Any]:
        """Return the values of formula cells, each by itself, with ``values`` in the cells of ``strips``.

        ``wanted`` are the numbers of the cells within ``strips``; a cell that is in none holds what it has without a
        formula.
        """

    def elsewhere(self, strips: Sequence[Strip], turns: Sequence[Turn]) -> Callable[[], Answers]:
        """Begin with what :meth:`each` gives at each of ``turns``; return what yields it."""


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
