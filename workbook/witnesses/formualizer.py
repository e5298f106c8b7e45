"""formualizer, a spreadsheet engine in Rust: the fast independent evaluator."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import formualizer

from workbook.book.address import Address
from workbook.errors import TooLargeError, WitnessError
from workbook.reading.files import BookFile
from workbook.witnesses.witness import cached_values

TOO_LARGE = "cell count limit"


class Formualizer:
    """Evaluates a copy of the file, and reads the results back."""

    name = "formualizer"
    kept = False

    def version(self) -> str | None:
        """Return the version of the package."""
        return version("formualizer")

    def values(self, file: BookFile) -> dict[Address, Any]:
        """Return the value of every formula cell."""
        try:
            filled = formualizer.recalculate_xlsx_bytes(file.path.read_bytes())["bytes"]
        except Exception as error:
            if TOO_LARGE in str(error):
                raise TooLargeError("formualizer takes no workbook of so many formula cells") from error
            raise WitnessError(f"formualizer cannot evaluate the file: {error}") from error
        return cached_values(filled, file)
