"""A copy of a book without some of its cells: what witnesses are asked of where an engineer has cells of his own in it.

A table, a newer function, a name that leads nowhere keep some programs from opening a file, or from ending in time;
what a book's declared formulas compute does not depend on them.
"""

import tempfile
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

from openpyxl import Workbook
from openpyxl.workbook.defined_name import DefinedName, DefinedNameDict

from workbook.book.address import Address
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile, find_places
from workbook.witnesses.witness import Witness


@contextmanager
def without(file: BookFile, own: Collection[Address], given: Mapping[Address, Any]) -> Iterator[BookFile]:
    """Give ``file`` itself, or a copy of one that was mended, without the cells ``own`` or with the values ``given``.

    The copy holds contents of cells and the names that lead to cells, and lies in a folder that goes away.
    """
    if not own and not given and not file.mended:
        yield file
    else:
        with written(file, own, given) as copy:
            yield copy


@contextmanager
def bare(file: BookFile) -> Iterator[BookFile]:
    """Give a copy of ``file`` for a program that would follow what else a workbook holds, such as a linked picture.

    It holds what :func:`without` copies, and no styled empty cells; a file that is such a copy is given itself.
    """
    if file.bare:
        yield file
    else:
        with written(file, (), {}) as copy:
            yield copy


@contextmanager
def written(file: BookFile, own: Collection[Address], given: Mapping[Address, Any]) -> Iterator[BookFile]:
    """Give a copy, as :func:`copied` says, in a folder that goes away."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "book.xlsx"
        workbook = copied(file, own, given)
        workbook.save(path)
        yield BookFile(path, workbook, find_places(workbook), bare=True)


def copied(file: BookFile, own: Collection[Address], given: Mapping[Address, Any]) -> Workbook:
    """Return a workbook with the same sheets, names that lead to cells, and contents, as :func:`without` says."""
    made = Workbook()
    made.remove(made.worksheets[0])
    made.epoch = file.workbook.epoch
    for sheet in file.workbook.worksheets:
        page = made.create_sheet(sheet.title)
        for (row, column), cell in sheet._cells.items():
            address = Address(sheet.title, row, column)
            if cell.value is not None and address not in own:
                copy = page.cell(row, column)
                if address in given:
                    copy.value = given[address]
                else:  # as it is: a text that looks like a formula stays one, and a date is a number
                    copy.value = file.contents.constants.get(address, cell.value)
                    copy.data_type = cell.data_type.replace("d", "n")
        page.defined_names = led(sheet.defined_names, file)
    made.defined_names = led(file.workbook.defined_names, file)
    return made


def led(names: Mapping[str, DefinedName], file: BookFile) -> DefinedNameDict:
    """Return those of the names that lead to cells in the book, or are called like one that does."""
    kept = DefinedNameDict()
    for name, defined in names.items():
        if name in file.places:
            kept[name] = DefinedName(name, attr_text=defined.attr_text)
    return kept


@runtime_checkable
class Varying(Protocol):
    """A witness that opens a file once for many sets of values."""

    def varied(self, file: BookFile, sets: Iterable[Cells]) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set with what the formula cells compute at it."""


def varied(witness: Witness, file: BookFile, sets: Iterable[Cells]) -> Iterator[tuple[Cells, Cells]]:
    """Yield each set of values with what the formula cells compute at it: of most witnesses, in a copy of the file."""
    if isinstance(witness, Varying):
        yield from witness.varied(file, sets)
        return
    for given in sets:
        with without(file, (), given) as copy:
            yield given, witness.values(copy)
