"""The file that goes with a report of a fault inside motionbook: where it failed, and the workbook without values."""

import platform
import tempfile
import traceback
import zipfile
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from openpyxl import Workbook, load_workbook
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula

from workbook import __version__
from workbook.book.formula import words


def failure_line(what: str, error: BaseException, arguments: Sequence[str]) -> str:
    """Return the line that asks for a report of an error, with the file to send, which is written."""
    text = "out of memory" if isinstance(error, MemoryError) else f"{type(error).__name__}: {error}"
    return f"{what} ({text[:200]}); please report this with {write_failure(error, arguments)}"


def write_failure(error: BaseException, arguments: Sequence[str]) -> Path:
    """Write what a report needs to a file in the system's folder for such, and return its path."""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [
        f"motionbook {__version__}, Python {platform.python_version()}, {platform.platform()}",
        f"motionbook {' '.join(word if word.startswith('-') or word.isalpha() else 'FILE' for word in arguments)}",
        *(f"{Path(x.filename).name}, line {x.lineno}, in {x.name}: {x.line}" for x in frames),
        type(error).__name__,
    ]
    with (
        tempfile.NamedTemporaryFile(prefix="motionbook-", suffix=".zip", delete=False) as file,
        zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as parts,
    ):
        parts.writestr("report.txt", "\n".join(lines) + "\n")
        for number, name in enumerate(arguments):
            with suppress(Exception):  # it is no workbook, or one that openpyxl cannot read either
                copy = book_without_values(Path(name))
                with parts.open(f"book{number}.xlsx", "w") as part:
                    copy.save(part)
    return Path(file.name)


def book_without_values(path: Path) -> Workbook:
    """Return a workbook of the same formulas, with 1 for every number and "x" for every text."""
    copy, book = Workbook(), load_workbook(path, keep_links=False)
    copy.remove(copy.worksheets[0])
    for sheet in book.worksheets:
        page = copy.create_sheet(sheet.title)
        for (row, column), cell in sheet._cells.items():
            page.cell(row, column).value = without_value(cell.value)
    for name, defined in book.defined_names.items():
        copy.defined_names[name] = DefinedName(name, attr_text=plain(f"={defined.attr_text}")[1:])
    return copy


def without_value(value: Any) -> Any:
    """Return what stands for a cell's content: its formula without numbers and texts, else a value of its kind."""
    if isinstance(value, ArrayFormula):
        return ArrayFormula(value.ref, plain(str(value.text)))
    if isinstance(value, str):
        return plain(value) if value.startswith("=") else "x"
    return None if value is None else isinstance(value, bool) or 1


def plain(formula: str) -> str:
    """Return a formula with 1 for every number and "" for every text."""
    plain_words = {"number": "1", "text": '""'}
    return "=" + "".join(plain_words.get(kind, word) for kind, word in words(formula.lstrip("=")))
