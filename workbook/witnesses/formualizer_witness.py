"""formualizer, a spreadsheet engine in Rust: the fast independent evaluator."""

from __future__ import annotations

import shutil
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import Any

import formualizer

from workbook.address import Address
from workbook.errors import WitnessError
from workbook.files import BookFile
from workbook.witnesses.witness import cached_values


class Formualizer:
    """Evaluates a copy of the file, and reads the results back."""

    name = "formualizer"

    def version(self) -> str | None:
        """Return the version of the package."""
        return version("formualizer")

    def values(self, file: BookFile) -> dict[Address, Any]:
        """Return the value of every formula cell."""
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / f"book{file.path.suffix}"
            shutil.copyfile(file.path, copy)
            try:
                formualizer.recalculate_file(str(copy))
            except Exception as error:
                raise WitnessError(f"formualizer cannot evaluate the file: {error}") from error
            return cached_values(copy, file)
