"""Text files of users, read under limits: only regular files are opened, and none is read beyond a size."""

import codecs
import re
import stat
from contextlib import suppress
from pathlib import Path

from workbook.errors import ReadError

PACKAGE = Path(__file__).parent
FOLDER = PACKAGE / "shipped" if (PACKAGE / "shipped").exists() else PACKAGE.parent / "templates"
"""the descriptions and catalogues that come with motionbook: in a wheel (hatch_build.py), or in the repository"""
MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
MOST = 1_000_000  # bytes; the largest description or catalogue that fits into a book has 60,000
KINDS = {stat.S_IFDIR: "this is a folder", stat.S_IFREG: ""}
CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x19\x1b-\x1f\x7f]")
"""control characters that no text has; old files end with \\x1a"""
OTHER = "this is a device or a pipe"


def irregular_kind(path: Path) -> str:
    """Return the kind of file at ``path``, empty for a regular file; it is not opened, as a pipe would block."""
    return KINDS.get(stat.S_IFMT(path.stat().st_mode), OTHER)


def require_file(path: Path, expected: str) -> None:
    """Raise ReadError unless ``path`` is a regular file, or a link to a file."""
    try:
        kind = irregular_kind(path)
    except (FileNotFoundError, NotADirectoryError) as error:
        raise ReadError(f"{path}: there is no such file") from error
    except (OSError, ValueError) as error:
        raise read_error(path, error, expected) from error
    if kind:
        raise ReadError(f"{path}: {kind}; expected {expected}")


def read_text(path: Path, expected: str, most: int = MOST, foreign: bool = False) -> str:
    """Return the text of a file in UTF-8; raise ReadError, which names what was ``expected``, where it has none.

    A ``foreign`` file may be in UTF-16 with its mark, or in Windows' code page, as spreadsheets save columns of text.
    """
    require_file(path, expected)
    try:
        with path.open("rb") as file:
            data = file.read(most + 1)
    except OSError as error:
        raise read_error(path, error, expected) from error
    if len(data) > most:
        raise ReadError(f"{path}: {path.stat().st_size:,} bytes; expected {expected}, of at most {most:,}")
    known = ["utf-8-sig", *(["cp1252"] if foreign and not CONTROL.search(data) else [])]
    for encoding in ["utf-16"] if foreign and data.startswith(MARKS) else known:
        with suppress(UnicodeDecodeError):
            return data.decode(encoding)
    raise ReadError(f"{path}: this is not a text; expected {expected} in UTF-8")


def read_error(path: Path, error: Exception, expected: str) -> ReadError:
    """Return the error for a file that cannot be read."""
    return ReadError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}; expected {expected}")
