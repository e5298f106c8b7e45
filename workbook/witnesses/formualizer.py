"""formualizer, a spreadsheet engine in Rust: the fast independent evaluator."""

from collections.abc import Iterable, Iterator
from typing import Any

import formualizer

from workbook.errors import TooLargeError, WitnessError
from workbook.reading.contents import Cells, entered
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness, bare, cached_values

TOO_LARGE = "cell count limit"
ERRORS = {"Div": "#DIV/0!", "Na": "#N/A", "Name": "#NAME?", "Null": "#NULL!", "Num": "#NUM!", "Ref": "#REF!"}


class Formualizer(Witness):
    """Evaluates a copy of the file, and reads the results back."""

    name = "formualizer"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        try:
            filled = formualizer.recalculate_xlsx_bytes(file.path.read_bytes())["bytes"]
        except Exception as error:
            if TOO_LARGE in str(error):
                raise TooLargeError("formualizer takes no workbook of so many formula cells") from error
            raise WitnessError(f"formualizer cannot evaluate the file: {error}") from error
        return cached_values(filled, file)

    def varied(self, file: BookFile, sets: Iterable[Cells]) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set of values with what the formula cells compute at it, in one book that stays open."""
        with bare(file) as copy:
            try:
                book = formualizer.Workbook.from_bytes(copy.path.read_bytes())
            except Exception as error:
                raise WitnessError(f"formualizer cannot read the file: {error}") from error
        for given in sets:
            for cell, value in given.items():
                book.set_value(*cell, value)
            book.evaluate_all()
            yield given, {cell: plain(book.get_value(*cell)) for cell in file.contents.formula_cells}


def plain(value: Any) -> Any:
    """Return a value as other witnesses have it: an error by its text, a date as a number."""
    return ERRORS.get(value["kind"], "#VALUE!") if isinstance(value, dict) else entered(value)
