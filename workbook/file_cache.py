r"""A cache on disk of results on files, by the file's SHA-256 and the version of this program.

It lies in the system's folder of caches: ``~/.cache/motionbook``, ``~/Library/Caches/motionbook`` on macOS,
``%LOCALAPPDATA%\motionbook\Cache`` on Windows.
"""

import hashlib
import json
import platform
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from platformdirs import user_cache_path

from workbook.errors import WriteError
from workbook.writing.output_files import write_text

SOURCES = Path(__file__).parents[1]
MOST = 1_000_000  # bytes of an entry


def load_cached(what: str, sha256: str) -> dict[str, Any] | None:
    """Return the cached verdict of a file; None for nothing, or an entry of another version of the program."""
    with suppress(OSError, ValueError, RuntimeError):  # the last of a system that knows no home
        path = folder() / f"{sha256}.{what}.json"
        if path.stat().st_size <= MOST:
            known = json.loads(path.read_bytes())
            if isinstance(known, dict) and known.get("program") == program_digest():
                return known
    return None


def store_cached(what: str, sha256: str, data: dict[str, Any]) -> None:
    """Store ``data`` on a file; a folder that cannot be written to is no error."""
    text = json.dumps(data | {"program": program_digest()})
    with suppress(OSError, RuntimeError, WriteError):
        write_text(folder() / f"{sha256}.{what}.json", text, overwrite=True)


def folder() -> Path:
    """Return the folder by the convention of the system; raise RuntimeError where it knows no home."""
    path = user_cache_path("motionbook", appauthor=False)
    if not path.is_absolute():  # it would lie wherever the command is given
        raise RuntimeError(f"{path}: an absolute path is expected")
    return path


@cache
def program_digest() -> str:
    """Return a digest of this program: its modules by name, size and time of change, and Python."""
    state = hashlib.sha256(f"{sys.version} {platform.machine()}".encode())
    for room in ("engine", "workbook"):
        for path in sorted((SOURCES / room).rglob("*.py")):
            known = path.stat()
            state.update(f"{path.relative_to(SOURCES)} {known.st_size} {known.st_mtime_ns}".encode())
    return state.hexdigest()
