"""Spreadsheet engines of others: optional packages of their names, LibreOffice run headless; and saved values."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbook.book.address import Address
from workbook.errors import TooLargeError, WitnessError
from workbook.reading.contents import Cells, plain_value
from workbook.reading.files import BookFile
from workbook.reading.rows import LAST_COLUMN, LAST_ROW
from workbook.witnesses.witness import Witness, cached_values, evaluation_copy

if TYPE_CHECKING:
    from formulon import Value, Workbook

ERRORS = {"Div": "#DIV/0!", "Na": "#N/A", "Name": "#NAME?", "Null": "#NULL!", "Num": "#NUM!", "Ref": "#REF!"}
TIMEOUT = 300  # seconds
PLACES = (
    "/usr/bin/soffice",
    "/Applications/LibreOffice.app/Contents/MacOS/soffice",
    r"C:\Program Files\LibreOffice\program\soffice.com",
)
# LibreOffice keeps the values that it finds in a file unless it is told to recalculate always, and follows links to
# other files and to the web unless it is told never to; settings that a version does not know do no harm
SETTINGS = (
    ("Calc/Formula/Load", "OOXMLRecalcMode", "0"), ("Calc/Formula/Load", "ODFRecalcMode", "0"),
    ("Calc/Content/Update", "Link", "2"), ("Common/Security/Scripting", "BlockUntrustedRefererLinks", "true"),
    ("Common/Security/Scripting", "DisableActiveContent", "true"),
)  # fmt: skip
ITEM = '<item oor:path="/org.openoffice.Office.{}"><prop oor:name="{}" oor:op="fuse"><value>{}</value></prop></item>'
PROFILE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">{}</oor:items>
""".format("".join(ITEM.format(*one) for one in SETTINGS))


class Formualizer(Witness):
    """formualizer, in Rust, the fast one: evaluates a copy of the file, and reads the results back."""

    name = "formualizer"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        import formualizer  # where it is asked: it takes long to load

        try:
            filled = formualizer.recalculate_xlsx_bytes(file.path.read_bytes())["bytes"]
        except Exception as error:
            if "cell count limit" in str(error):
                raise TooLargeError("formualizer takes no workbook of so many formula cells") from error
            raise WitnessError(f"formualizer cannot evaluate the file: {error}") from error
        return cached_values(filled, file)

    def varied(self, file: BookFile, sets: Iterable[Cells]) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set of values with what the formula cells compute at it, in one book that stays open."""
        import formualizer

        with evaluation_copy(file, bare=True) as copy:
            try:
                book = formualizer.Workbook.from_bytes(copy.path.read_bytes())
            except Exception as error:
                raise WitnessError(f"formualizer cannot read the file: {error}") from error
        for given in sets:
            for cell, value in given.items():
                book.set_value(*cell, value)
            book.evaluate_all()
            found = {cell: book.get_value(*cell) for cell in file.contents.formula_cells}
            yield given, {cell: ERRORS.get(value["kind"], "#VALUE!") if isinstance(value, dict) else plain_value(value)
                          for cell, value in found.items()}  # fmt: skip


class Formulon(Witness):
    """formulon, in WebAssembly, tested against Excel's own results by its makers: recalculates every formula."""

    name = "formulon"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell, None where it is empty or no single value."""
        import formulon  # optional

        try:
            with formulon.Workbook.load(file.path.read_bytes()) as book:
                book.recalc()
                found = formulon_values(book)
        except formulon.FormulonError as error:
            raise WitnessError(f"formulon cannot evaluate the file: {error}") from error
        return {address: found.get(address) for address in file.contents.formula_cells}


def formulon_values(book: Workbook) -> Cells:
    """Return what every cell of a book holds."""
    from formulon import MergeRange

    found = {}
    for number in range(book.sheet_count()):
        title, more = book.sheet_name(number), True
        cursor: int | None = None
        while more:
            some, cursor = book.get_cells_in_range(number, MergeRange(0, 0, LAST_ROW - 1, LAST_COLUMN - 1), cursor)
            more = cursor is not None
            found.update({Address(title, cell.row + 1, cell.col + 1): formulon_value(cell.value) for cell in some})
    return found


def formulon_value(value: Value) -> Any:
    """Return a number, a truth value, a text or an error's name; None for anything else."""
    from formulon import error_display_name

    if value.error_code is not None:
        return error_display_name(value.error_code)
    made = value.to_python()
    return made if isinstance(made, bool | float | str) else None


class IronCalc(Witness):
    """IronCalc, in Rust: loads the file, evaluates every formula, and reads the results."""

    name = "ironcalc"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        import ironcalc  # optional

        try:
            with evaluation_copy(file, bare=True) as copy:  # an empty cell with a style, and t="n", would be 0
                model = ironcalc.load_from_xlsx(str(copy.path), "en", "UTC", "en")
            model.evaluate()
        except Exception as error:  # what it cannot read comes up as any exception
            raise WitnessError(f"IronCalc cannot evaluate the file: {error}") from error
        numbers = {sheet["name"]: i for i, sheet in enumerate(model.get_worksheets_properties())}
        return {cell: model.get_cell_value(numbers[cell.sheet], cell.row, cell.column)
                for cell in file.contents.formula_cells}  # fmt: skip


def libreoffice_path() -> str | None:
    """Return the path of LibreOffice, or None where it is not on this machine."""
    return shutil.which("soffice") or next((place for place in PLACES if Path(place).exists()), None)


def convert(source: Path, kind: str, folder: Path) -> Path:
    """Convert a file with a private profile that recalculates everything; return the new file in ``folder``."""
    soffice = libreoffice_path()
    if soffice is None:
        raise WitnessError("LibreOffice is not on this machine")
    with tempfile.TemporaryDirectory() as profile:
        user = Path(profile) / "user"
        user.mkdir()
        (user / "registrymodifications.xcu").write_text(PROFILE, encoding="utf-8")
        command = [soffice, "--headless", "--norestore", f"-env:UserInstallation={Path(profile).as_uri()}",
                   "--convert-to", kind, "--outdir", str(folder), str(source)]  # fmt: skip
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise WitnessError(f"LibreOffice did not finish: {error}") from error
    made = folder / f"{source.stem}.{kind.split(':')[0]}"
    if not made.exists():
        raise WitnessError(f"LibreOffice could not open the file: {(run.stderr or run.stdout).strip()[:200]}")
    return made


@cache
def version_of(soffice: str) -> str:
    """Return the version of a LibreOffice."""
    environment = os.environ | {"HOME": tempfile.gettempdir()} if sys.platform != "win32" else None
    try:
        said = subprocess.run(
            [soffice, "--version"], capture_output=True, text=True, check=False, env=environment, timeout=TIMEOUT
        )
    except (OSError, subprocess.TimeoutExpired):  # converting says what is wrong
        return "unknown version"
    found = re.search(r"\d+(\.\d+)+", said.stdout)
    return found.group() if found else "unknown version"


class LibreOffice(Witness):
    """Recalculates a bare copy of the file, which has nothing to fetch, and reads the results back."""

    name = "libreoffice"

    def version(self) -> str | None:
        """Return LibreOffice's own version, or None where it is absent."""
        soffice = libreoffice_path()
        return None if soffice is None else version_of(soffice)

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        with evaluation_copy(file, bare=True) as copy, tempfile.TemporaryDirectory() as folder:
            return cached_values(convert(copy.path, "xlsx", Path(folder)).read_bytes(), file)


class Saved(Witness):
    """Reads the results that stand in the file."""

    name = "saved"
    kept = True

    def version(self) -> str | None:
        """Return what the witness reads; it has no program of its own."""
        return "values in the file"

    def values(self, file: BookFile) -> Cells:
        """Return the saved value of every formula cell; raise WitnessError where the file has none."""
        if all(value is None for value in file.saved.values()):
            raise WitnessError("the file holds no saved values; open it in Excel or LibreOffice and save it")
        return file.saved
