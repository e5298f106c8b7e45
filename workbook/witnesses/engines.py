"""Spreadsheet engines of others: optional packages of their names, LibreOffice run headless; and saved values."""

from __future__ import annotations

import os
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

from workbook.errors import TooLargeError, WitnessError
from workbook.reading.contents import Cells, plain_value
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness, cached_values, evaluation_copy

ERRORS = {"Div": "#DIV/0!", "Na": "#N/A", "Name": "#NAME?", "Null": "#NULL!", "Num": "#NUM!", "Ref": "#REF!"}
TIMEOUT = 300  # seconds
PLACES = (
    "/usr/bin/soffice",
    "/Applications/LibreOffice.app/Contents/MacOS/soffice",
    r"C:\Program Files\LibreOffice\program\soffice.com",
)
# LibreOffice keeps the values that it finds in a file unless it is asked to recalculate always, and follows links to
# other files and to the web unless it is asked never to; settings that a version does not know do no harm
SETTINGS = (
    ("Calc/Formula/Load", "OOXMLRecalcMode", "0"), ("Calc/Formula/Load", "ODFRecalcMode", "0"),
    ("Calc/Content/Update", "Link", "2"), ("Common/Security/Scripting", "BlockUntrustedRefererLinks", "true"),
    ("Common/Security/Scripting", "DisableActiveContent", "true"),
)  # fmt: skip
ITEM = '<item oor:path="/org.openoffice.Office.{}"><prop oor:name="{}" oor:op="fuse"><value>{}</value></prop></item>'
PROFILE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">{}</oor:items>
""".format("".join(ITEM.format(*setting) for setting in SETTINGS))


class Formualizer(Witness):
    """formualizer, in Rust, the fastest: evaluates a copy of the file, and reads the results back."""

    name = "formualizer"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        try:
            filled = ask_apart(self, file.path.read_bytes())
        except WitnessError as error:
            if "cell count limit" in str(error):
                raise TooLargeError("formualizer takes no workbook of so many formula cells") from error
            raise
        return cached_values(filled, file)

    def varied(self, file: BookFile, sets: Iterable[Cells]) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set of values with what the formula cells compute at it, in a book that stays open."""
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
            values = {cell: book.get_value(*cell) for cell in file.contents.formula_cells}
            yield (
                given,
                {
                    cell: ERRORS.get(value["kind"], "#VALUE!") if isinstance(value, dict) else plain_value(value)
                    for cell, value in values.items()
                },
            )


class Formulon(Witness):
    """formulon, in WebAssembly, tested against Excel's own results by its makers: recalculates every formula."""

    name = "formulon"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell, None where it is empty or no single value."""
        values = ask_apart(self, file.path.read_bytes())
        return {address: values.get(address) for address in file.contents.formula_cells}


class IronCalc(Witness):
    """IronCalc, in Rust: loads the file, evaluates every formula, and reads the results."""

    name = "ironcalc"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        cells = list(file.contents.formula_cells)
        with evaluation_copy(file, bare=True) as copy:  # an empty cell with a style, and t="n", would be 0
            values = ask_apart(self, str(copy.path), [tuple(cell) for cell in cells])
        return dict(zip(cells, values, strict=True))


def ask_apart(witness: Witness, *given: Any) -> Any:
    """Return the answer of an evaluator in a process of its own; raise WitnessError where it has none."""
    command = [sys.executable, "-P", str(Path(__file__).with_name("engine_process.py"))]
    try:
        request = pickle.dumps((witness.name, *given))
        run = subprocess.run(command, input=request, capture_output=True, timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        raise WitnessError(f"{witness.name} gave no answer within {TIMEOUT} s") from None
    if run.returncode:
        raise WitnessError(f"{witness.name} ended with exit code {run.returncode}")
    answered, answer = pickle.loads(run.stdout)
    if not answered:
        raise WitnessError(f"{witness.name} cannot evaluate the file: {answer}")
    return answer


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
        command = [
            soffice,
            "--headless",
            "--norestore",
            f"-env:UserInstallation={Path(profile).as_uri()}",
            "--convert-to",
            kind,
            "--outdir",
            str(folder),
            str(source),
        ]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise WitnessError(f"LibreOffice did not finish: {error}") from error
    path = folder / f"{source.stem}.{kind.split(':')[0]}"
    if not path.exists():
        raise WitnessError(f"LibreOffice could not open the file: {(run.stderr or run.stdout).strip()[:200]}")
    return path


@cache
def version_of(soffice: str) -> str:
    """Return the version of a LibreOffice."""
    environment = os.environ | {"HOME": tempfile.gettempdir()} if sys.platform != "win32" else None
    try:
        output = subprocess.run(
            [soffice, "--version"], capture_output=True, text=True, check=False, env=environment, timeout=TIMEOUT
        )
    except (OSError, subprocess.TimeoutExpired):  # converting says what is wrong
        return "unknown version"
    match = re.search(r"\d+(\.\d+)+", output.stdout)
    return match.group() if match else "unknown version"


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
        """Return words for the version; it has no program of its own."""
        return "values in the file"

    def values(self, file: BookFile) -> Cells:
        """Return the saved value of every formula cell; raise WitnessError where the file has none."""
        if all(value is None for value in file.saved.values()):
            raise WitnessError("the file holds no saved values; open it in Excel or LibreOffice and save it")
        return file.saved
