"""pycel as a witness: its parser, compiler and functions, each formula shape compiled once.

pycel itself parses, compiles and loads every formula anew and walks its graph at every call; here its compiler is
called once for each shape (:mod:`workbook.witnesses.pycel.compiled`), and cells are evaluated in an order found without
recursion (:mod:`workbook.witnesses.pycel.calculation`). Every value is computed by pycel's functions and operators.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

from openpyxl import Workbook

from workbook.book.address import Address, Strip
from workbook.reading.contents import Cells, Contents
from workbook.witnesses.pycel.calculation import Calculation
from workbook.witnesses.witness import Answers, Turn


class PycelModel:
    """A workbook's formulas, joined once, to be evaluated again and again with other inputs.

    ``problems`` says in a line why a cell could not be evaluated; its value is an Excel error, or ``#CYCLE!``. The
    formulas of ``cells`` are evaluated, all by default.
    """

    def __init__(self, held: Workbook | Contents, cells: Collection[Address] | None = None) -> None:
        contents = held if isinstance(held, Contents) else Contents(held)
        self.problems: dict[Address, str] = dict(contents.problems)
        self.constants, self.formulas = contents.constants, contents.formulas
        if cells is not None:
            self.formulas = {cell: self.formulas[cell] for cell in cells if cell in self.formulas}
        self._failed = contents.failed
        self._calculation = Calculation(self.constants | self._failed, self.formulas, self.problems)

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after those that it needs."""
        return self._calculation.order

    def evaluate(self, inputs: Mapping[Address, Any] | None = None) -> Cells:
        """Return the value of every formula cell; ``inputs`` stand in for what cells hold."""
        return self._failed | self._calculation.evaluate(inputs)

    def each(self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> list[Any]:
        """Return the values of formula cells, each by itself, with ``values`` in the cells of ``strips``.

        ``wanted`` are the numbers of the cells within ``strips``. With the right values around it, a fault shows in its
        own cell only.
        """
        return self._calculation.each(wanted, strips, values)

    def elsewhere(self, strips: Sequence[Strip], turns: Sequence[Turn]) -> Callable[[], Answers]:
        """Return what yields, of each of ``turns``, the result of :meth:`each` and the values at which that is."""

        def answers() -> Answers:
            for turn in turns:
                stated = turn.stated()
                yield self.each(turn.wanted, strips, stated.values), stated

        return answers


def evaluate(workbook: Workbook, inputs: Mapping[Address, Any] | None = None) -> Cells:
    """Return the value of every formula cell of ``workbook``."""
    return PycelModel(workbook).evaluate(inputs)
