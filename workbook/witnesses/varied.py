"""What a witness computes at other values of some cells, one set after the other."""

from collections.abc import Iterable, Iterator
from typing import Protocol, runtime_checkable

from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.bare import without
from workbook.witnesses.witness import Witness


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
