"""What formulon computes of a workbook that is no file yet: a second opinion beside pycel's."""

import tempfile
from pathlib import Path

from workbook.witnesses.engine_process import Formulon


def by_formulon(written):
    """Return the values of all cells of an openpyxl workbook, by sheet, row and column."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "book.xlsx"
        written.save(path)
        engine = Formulon(str(path))
        engine.compute({}, [])
        return engine.all_values()
