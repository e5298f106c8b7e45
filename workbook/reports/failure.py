"""The file that goes with a report of a fault inside motionbook: where it failed, and the formulas, without values."""

import platform
import re
import tempfile
import traceback
import zipfile
from collections.abc import Iterator, Sequence
from contextlib import suppress
from html import unescape
from pathlib import Path

from workbook import __version__
from workbook.book.formula import words

FORMULA = re.compile(r"<f[^>]*>([^<]+)</f>")
SHEET = re.compile(r"xl/worksheets/[^/]+\.xml")
MOST = 2_000  # formulas of a workbook, each once


def write_failure(error: BaseException, arguments: Sequence[str]) -> Path:
    """Write what a report needs to a file in the system's folder for such, and return its path."""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [
        f"motionbook {__version__}, Python {platform.python_version()}, {platform.platform()}",
        f"motionbook {' '.join(word if word.startswith('-') or word.isalpha() else 'FILE' for word in arguments)}",
        *(f"{Path(frame.filename).name}, line {frame.lineno}, in {frame.name}: {frame.line}" for frame in frames),
        type(error).__name__,
    ]
    for name in arguments:
        with suppress(OSError, ValueError, zipfile.BadZipFile):
            lines += ["", "Formulas, without numbers and texts:", *formulas_without_values(Path(name))]
    with tempfile.NamedTemporaryFile("w", prefix="motionbook-", suffix=".txt", delete=False, encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return Path(file.name)


def formulas_without_values(path: Path) -> Iterator[str]:
    """Yield the formulas of a workbook, each once, with 1 for every number and "" for every text."""
    formulas: dict[str, None] = {}
    with zipfile.ZipFile(path) as parts:
        for part in filter(SHEET.fullmatch, parts.namelist()):
            for match in FORMULA.finditer(parts.read(part).decode("utf-8", "replace")):
                formulas[plain(unescape(match[1]))] = None
    yield from list(formulas)[:MOST]


def plain(formula: str) -> str:
    """Return a formula with 1 for every number and "" for every text."""
    return "=" + "".join({"number": "1", "text": '""'}.get(kind, word) for kind, word in words(formula))
