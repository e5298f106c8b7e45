"""The base of witnesses, and the copies of books it may be given: without what keeps programs from opening a file."""

import io
import platform
import tempfile
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

from openpyxl import Workbook
from openpyxl.workbook.defined_name import DefinedName, DefinedNameDict

from workbook.book.address import Address
from workbook.errors import MotionbookError, WitnessError
from workbook.reading.cells import saved_values
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile, find_places
from workbook.reading.guard import inspect
from workbook.reading.rows import Refusal

CYCLE = "#CYCLE!"  # what a witness has for a cell that computes from itself, or from cells that do: no program shows it


class Witness:
    """An evaluator of workbooks, independent of the others; with ``kept`` it is always asked: it reads saved values."""

    name: str
    kept = False

    def version(self) -> str | None:
        """Return the version of what evaluates, here of the package of this name; None where it is not installed."""
        try:
            return version(self.name)
        except PackageNotFoundError:
            return None

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell; raise WitnessError where that cannot be had."""
        raise NotImplementedError

    def varied(
        self, file: BookFile, sets: Iterable[Cells], cells: Sequence[Address] | None = None
    ) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set of values with what the formula ``cells`` (all) compute at it, each in a copy of the file."""
        for given in sets:
            with evaluation_copy(file, given=given) as copy:
                values = self.values(copy)
                yield given, values if cells is None else {cell: values.get(cell) for cell in cells}


@contextmanager
def naming_failures(witness: Witness) -> Iterator[None]:
    """Raise whatever goes wrong inside an evaluator as a WitnessError that names it, its version and Python's."""
    try:
        yield
    except (MotionbookError, OSError, KeyboardInterrupt, SystemExit, GeneratorExit):
        raise
    except BaseException as error:  # panics of Rust are no Exceptions
        raise WitnessError(f"{in_full(witness.name, witness.version())}: {type(error).__name__}: {error}") from error


def in_full(name: str, version: str | None) -> str:
    """Return a witness' name with its version and Python's, on both of which its values rest."""
    python = f"Python {'.'.join(platform.python_version_tuple()[:2])}"
    words = f"{name} {version or 'of no known version'}"
    return words if python in words else f"{words} ({python})"


class Model(Protocol):
    """A file's formulas as a witness holds them, to be evaluated again and again."""

    @property
    def problems(self) -> Mapping[Address, str]:
        """The reasons why cells could not be evaluated, each in a line."""

    @property
    def raised(self) -> Collection[Address]:
        """The cells in which the witness itself failed."""

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""

    def enter(self, values: Cells) -> None:
        """Take other contents of cells without formulas, for all that is evaluated from now on."""

    def each(self, wanted: Sequence[int], values: Sequence[Any]) -> Sequence[Any]:
        """Return the value of each of the cells ``wanted``, computed by itself with ``values`` in those given."""


class CellWitness(Witness):
    """A witness that can also evaluate each cell by itself: so a fault shows in its own cell only."""

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        return self.model(file).evaluate()

    def model(self, file: BookFile, cells: Iterable[Address] = ()) -> Model:
        """Return the formulas of a file; ``cells`` are those that will be given other values."""
        raise NotImplementedError


def cached_values(data: bytes, file: BookFile) -> Cells:
    """Return the results in another copy of the file of the formula cells of ``file``."""
    try:
        held = saved_values(inspect(io.BytesIO(data), len(data)))
    except Refusal as refusal:
        raise WitnessError(f"what it wrote cannot be read: {refusal}") from None
    return {a: held.get(a) for a in file.contents.formula_cells}


@contextmanager
def evaluation_copy(
    file: BookFile,
    own: Collection[Address] = (),
    given: Mapping[Address, Any] = MappingProxyType({}),
    bare: bool = False,
) -> Iterator[BookFile]:
    """Give ``file``, or a copy without the cells ``own``, with ``given`` values, or ``bare``: contents and names."""
    if not (own or given or (bare and not file.bare)):
        yield file
        return
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "book.xlsx"
        workbook = copy_contents(file, own, given)
        workbook.save(path)
        yield BookFile(path, workbook, find_places(workbook), bare=True)


def copy_contents(file: BookFile, own: Collection[Address], given: Mapping[Address, Any]) -> Workbook:
    """Return a workbook of the same sheets, contents and names that lead to cells (see :func:`evaluation_copy`)."""
    values_book = Workbook()
    values_book.remove(values_book.worksheets[0])
    values_book.epoch = file.workbook.epoch
    for sheet in file.workbook.worksheets:
        page = values_book.create_sheet(sheet.title)
        for (row, column), cell in sheet._cells.items():
            address = Address(sheet.title, row, column)
            if cell.value is not None and address not in own:
                copy = page.cell(row, column)
                if address in given:
                    copy.value = given[address]
                else:  # as it is: a text that looks like a formula stays one, and a date is a number
                    copy.value = file.contents.constants.get(address, cell.value)
                    copy.data_type = cell.data_type.replace("d", "n")
        page.defined_names = names_of_cells(sheet.defined_names, file)
    values_book.defined_names = names_of_cells(file.workbook.defined_names, file)
    return values_book


def names_of_cells(names: Mapping[str, DefinedName], file: BookFile) -> DefinedNameDict:
    """Return those of the names that lead to cells in the book, or are called like a name that does."""
    usable = {
        name: DefinedName(name, attr_text=defined.attr_text) for name, defined in names.items() if name in file.places
    }
    return DefinedNameDict(usable)
