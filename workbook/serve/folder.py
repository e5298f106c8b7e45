"""The folder that is served: its descriptions and workbooks by name, and nothing outside it."""

import hashlib
import re
from pathlib import Path

from workbook.errors import ReadError, WriteError

KINDS = (".toml", ".xlsx", ".xlsm")  # descriptions and workbooks: what the first page lists
MADE = (*KINDS, ".csv", ".json", ".html", ".scl", ".st", ".txt", ".xml")
"""what is written and downloaded: also cam tables, and the results of studies"""
NAME = re.compile(r"[^/\\:*?\"<>|\x00-\x1f]{1,120}")
LARGEST = 60_000_000  # bytes of an upload: what verify takes of a file at most


class Folder:
    """A folder of machines."""

    def __init__(self, path: Path) -> None:
        if not path.is_dir():
            raise ReadError(f"{path}: there is no such folder")
        self.path = path.resolve()

    def files(self) -> list[Path]:
        """Return its descriptions and workbooks, by name."""
        found = (path for path in self.path.iterdir() if path.suffix.lower() in KINDS)
        return sorted(path for path in found if path.is_file() and not path.name.startswith((".", "~$")))

    def file(self, name: str) -> Path:
        """Return a file of the folder; raise ReadError for a name that is none."""
        path = self._within(name)
        if path.suffix.lower() not in MADE or not path.is_file():
            raise ReadError(f"{name}: there is no such file of a machine in this folder")
        return path

    def free(self, name: str) -> Path:
        """Return where a new file can be written: the name, or that with a number."""
        path = self._within(name)
        if path.suffix.lower() not in MADE:
            raise WriteError(f"{name}: expected a name that ends in {', '.join(MADE)}")
        numbered = (path.with_stem(f"{path.stem}-{number}") for number in range(2, 1000))
        return path if not path.exists() else next(one for one in numbered if not one.exists())

    def _within(self, name: str) -> Path:
        path = self.path / name
        if not NAME.fullmatch(name) or name.startswith(".") or path.resolve().parent != self.path:
            raise ReadError(f"{name!r}: expected the plain name of a file in this folder")
        return path


def plain(name: str, otherwise: str) -> str:
    """Return the name of a file that was sent, without folders; ``otherwise`` where it is none."""
    last = Path(name).name
    return last if NAME.fullmatch(last) else otherwise


def state(path: Path) -> str:
    """Return by what a later version of a file is told from this one."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
