"""The saved values: what Excel, LibreOffice or motionbook computed when the file was last saved."""

from __future__ import annotations

from typing import Any

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.reading.files import BookFile
from workbook.witnesses.witness import cached_values


class Saved:
    """Reads the results that stand in the file."""

    name = "saved"

    def version(self) -> str | None:
        """Return what the witness reads; it has no program of its own."""
        return "values in the file"

    def values(self, file: BookFile) -> dict[Address, Any]:
        """Return the saved value of every formula cell; raise WitnessError where the file has none."""
        values = cached_values(file.path, file)
        if values and all(value is None for value in values.values()):
            raise WitnessError("the file holds no saved values; open it in Excel or LibreOffice and save it")
        return values
