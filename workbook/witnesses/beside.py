"""A second process that evaluates a book while the first judges it, which works out itself what that does not say."""

from __future__ import annotations

import hashlib
import multiprocessing
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbook.pool import cores

if TYPE_CHECKING:  # what the first process begins with must load in no time
    from workbook.book.address import Address, Strip
    from workbook.reading.contents import Cells
    from workbook.reading.files import BookFile
    from workbook.witnesses.witness import CellWitness, Given, Model

NAME = "pycel"  # the witness that evaluates beside
LARGEST = 20_000_000  # bytes of a file: both processes hold it


class Beside:
    """The second process, as the first knows it; a book's formulas as it has them, or this one where it is silent."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._pool = ProcessPoolExecutor(1, initializer=begin)
        self._read = self._ask(read, path)
        self.evaluated = self._ask(evaluate)
        self._problems: Mapping[Address, str] | None = None
        self._asked: tuple[CellWitness, BookFile]

    def _ask(self, task: Callable[..., Any], *arguments: Any) -> Future[Any] | None:
        """Let the process do something after all that it was asked before; None where it is gone."""
        with suppress(RuntimeError, OSError):
            return self._pool.submit(task, *arguments)
        return None

    def model(self, witness: CellWitness, file: BookFile) -> Model:
        """Return a file's formulas: evaluated there, if the process is of this witness and has read the same file."""
        self._asked = witness, file
        same = witness.name == NAME and file.path == self.path and not file.mended
        return self if same and answer(self._read) == digest(file.path) else self.here

    @cached_property
    def here(self) -> Model:
        """The same formulas in this process."""
        witness, file = self._asked
        return witness.model(file)

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""
        return self.here.problems if self._problems is None else self._problems

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""
        said = answer(self.evaluated)
        if said is None:
            return self.here.evaluate()
        values, self._problems = said
        return dict(zip(self._asked[1].contents.formula_cells, values, strict=True))

    def each(self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> Given:
        """Begin with the values of formula cells, each by itself; return what gives them."""
        asked = self._ask(each, wanted, strips, values)

        def given() -> Sequence[Any]:
            found: Sequence[Any] | None = answer(asked)
            return self.here.each(wanted, strips, values)() if found is None else found

        return given

    def end(self) -> None:
        """End the process, whatever it does."""
        for process in multiprocessing.active_children():
            process.kill()
        self._pool.shutdown(cancel_futures=True)


def answer(asked: Future[Any] | None) -> Any:
    """Wait for what the second process says; return None where it is gone before that, or could not do it."""
    with suppress(Exception):
        return asked.result() if asked is not None else None
    return None


def digest(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as data:
        return hashlib.file_digest(data, "sha256").hexdigest()


@contextmanager
def beside(books: Sequence[Path], witnesses: Sequence[str] | None, jobs: int | None) -> Iterator[Beside | None]:
    """Give a second process where one book is to be verified and there is a core for it; it ends with the block."""
    helper = None
    with suppress(OSError):
        if wanted(books, witnesses, jobs):
            helper = Beside(books[0])
    try:
        yield helper
    finally:
        if helper is not None:
            helper.end()


def wanted(books: Sequence[Path], witnesses: Sequence[str] | None, jobs: int | None) -> bool:
    """Whether a second process would be of use."""
    alone = len(books) == 1 and books[0].is_file() and books[0].stat().st_size <= LARGEST
    return alone and (not witnesses or NAME in witnesses) and min(cores(), jobs or 2) > 1


held: dict[str, Any] = {}  # of the second process, which does what follows: its file and its model


def begin() -> None:
    """Prepare the process, which lives until the first ends it."""
    import gc
    import signal

    gc.disable()
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def read(path: Path) -> str:
    """Read a book; return what tells its state."""
    from workbook.reading.files import open_book, require_little_work

    held["file"] = open_book(path, shown=False)
    require_little_work(held["file"], path)
    return digest(path)


def evaluate() -> tuple[list[Any], Mapping[Address, str]]:
    """Return the value of each of its formula cells, and why some could not be evaluated."""
    from workbook.witnesses.pycel.model import PycelModel

    contents = held.pop("file").contents
    held["model"] = PycelModel(contents)
    values = held["model"].evaluate()
    return [values[a] for a in contents.formula_cells], held["model"].problems


def each(wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> Sequence[Any]:
    """Return the values of formula cells, each by itself."""
    found: Sequence[Any] = held["model"].each(wanted, strips, values)()
    return found
