"""A second process that evaluates a book's formulas while the first reads and judges it: verifying takes both cores.

It opens the same file for itself, under the same limits, and has its formulas joined and evaluated by the time that
the first asks. It says nothing by itself: what it does not answer, because it was killed, or read another state of the
file, or cannot be started, the first computes for itself, and finds the same.
"""

from __future__ import annotations

import hashlib
import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from itertools import starmap
from pathlib import Path
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # what the first process begins with must load in no time
    from workbook.book.address import Address
    from workbook.reading.contents import Cells
    from workbook.reading.files import BookFile
    from workbook.witnesses.witness import CellWitness, Found, Known, Model, Witness

NAME = "pycel"
"""the witness that evaluates beside"""
LARGEST = 20_000_000  # bytes of a file: both processes hold it
BEGIN = "import sys; sys.path[:] = {path!r}; from workbook.witnesses.beside import main; main({book!r})"


class Line:
    """Messages to another process and from it; a thread listens, so that neither waits while the other speaks."""

    def __init__(self, heard: Any, said: Any) -> None:
        self._heard, self._said = heard, said
        self._messages: SimpleQueue[bytes | None] = SimpleQueue()
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        with suppress(OSError, ValueError):
            while len(head := self._heard.read(8)) == 8:
                size = int.from_bytes(head, "big")
                message = self._heard.read(size)
                if len(message) < size:
                    break
                self._messages.put(message)
        self._messages.put(None)

    def say(self, message: Any) -> None:
        """Send a message; raise OSError where nobody listens any more."""
        data = pickle.dumps(message, pickle.HIGHEST_PROTOCOL)
        self._said.write(len(data).to_bytes(8, "big") + data)
        self._said.flush()

    def hear(self) -> Any:
        """Return the next message; raise EOFError where none will come any more."""
        data = self._messages.get()
        if data is None:
            self._messages.put(None)
            raise EOFError
        return pickle.loads(data)  # from a process that this one has started, or was started by


class Beside:
    """The second process, as the first knows it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        code = BEGIN.format(path=sys.path, book=str(path))
        self.process = subprocess.Popen(
            [sys.executable, *flags(), "-c", code],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self._line = Line(self.process.stdout, self.process.stdin)
        self._asked = False

    def witness(self, witness: Witness) -> Witness:
        """Return the witness that this process evaluates with as one that is asked there; any other as it is."""
        return Evaluating(witness, self) if witness.name == NAME else witness

    def line(self, file: BookFile) -> Line | None:
        """Return the line to the process, once, if it has read the same file; None where it has not."""
        asked, self._asked = self._asked, True
        try:
            same = not asked and file.path == self.path and not file.mended and self._line.hear() == digest(file.path)
        except (EOFError, OSError):
            return None
        return self._line if same else None

    def end(self) -> None:
        """End the process, whatever it does."""
        self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout):
            with suppress(OSError):
                if pipe is not None:
                    pipe.close()


class Evaluating:
    """A witness whose models are evaluated by the second process."""

    def __init__(self, witness: Any, beside: Beside) -> None:
        self.name, self.kept = witness.name, witness.kept
        self._witness, self._beside = witness, beside

    def version(self) -> str | None:
        """Return the witness's version."""
        said: str | None = self._witness.version()
        return said

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        return self.model(file).evaluate()

    def model(self, file: BookFile) -> Model:
        """Return the formulas of a file."""
        line = self._beside.line(file)
        model: Model = self._witness.model(file) if line is None else Asked(line, file, self._witness)
        return model


class Asked:
    """A file's formulas as the second process has them; as this one has them from when it does not answer."""

    def __init__(self, line: Line, file: BookFile, witness: CellWitness) -> None:
        self._line, self._file, self._witness = line, file, witness
        self._numbers = {address: n for n, address in enumerate(file.contents.formula_cells)}
        held = cells_of(file)
        self._cells, self._known = [*held, *((a, None) for a in empty(file, held))], len(held)
        self._problems: Mapping[Address, str] | None = None
        self._heard: list[Any] = []
        self._asked = 0

    @cached_property
    def _here(self) -> Model:
        return self._witness.model(self._file)

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""
        return self._here.problems if self._problems is None else self._problems

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""
        answer = self._answer(0)
        if answer is None:
            return self._here.evaluate()
        values, self._problems = answer
        return dict(zip(self._numbers, values, strict=True))

    def each(self, wanted: Iterable[Address], found: Found) -> Cells:
        """Return the value of each formula cell of ``wanted`` by itself, with ``found`` in the cells it refers to."""
        return self._ask(list(wanted), found, list(starmap(found, self._cells)))()

    def later(self, wanted: Iterable[Address], known: Known) -> Callable[[], Cells]:
        """Ask for what :meth:`each` returns with what is ``known``; return what waits for it."""
        return self._ask(list(wanted), known.get, known.all(self._cells))

    def _ask(self, wanted: list[Address], found: Found, values: list[Any]) -> Callable[[], Cells]:
        number = self._asked = self._asked + 1
        with suppress(OSError):  # of a process that is gone: then it does not answer either
            if number == 1:
                self._line.say([address for address, _ in self._cells[self._known :]])
            self._line.say(([self._numbers[a] for a in wanted], values))

        def answered() -> Cells:
            answer = self._answer(number)
            return self._here.each(wanted, found) if answer is None else dict(zip(wanted, answer, strict=True))

        return answered

    def _answer(self, number: int) -> Any:
        """Return an answer by its number, counted from 0, that of the first evaluation; None where none comes."""
        with suppress(EOFError):
            while len(self._heard) <= number:
                self._heard.append(self._line.hear())
        return self._heard[number] if number < len(self._heard) else None


def cells_of(file: BookFile) -> list[tuple[Address, Any]]:
    """Return the cells of a file with what they hold if that is no formula, in the same order in both processes."""
    contents = file.contents
    return [*((a, None) for a in contents.formula_cells), *contents.constants.items()]


def empty(file: BookFile, held: Iterable[tuple[Address, Any]]) -> list[Address]:
    """Return the cells within the places that names lead to in which the file has nothing."""
    known = {address for address, _ in held}
    cells = (address for p in file.places.values() for j in range(p.columns) for address in p.down(j))
    return list(dict.fromkeys(address for address in cells if address not in known and address.column))


def digest(path: Path) -> bytes:
    """Return the SHA-256 of a file."""
    with path.open("rb") as data:
        return hashlib.file_digest(data, "sha256").digest()


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
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return alone and (not witnesses or NAME in witnesses) and min(cores, jobs or cores) > 1


def flags() -> list[str]:
    """Return the options with which Python was started that a process of its own should have too."""
    return [option for option in ("-B",) if sys.flags.dont_write_bytecode]


def main(book: str) -> None:
    """Read a book, evaluate it and answer, until nobody asks any more: the second process."""
    import gc
    import signal

    gc.disable()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the first process ends this one
    heard, said = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr
    with suppress(EOFError, OSError):
        answer(Path(book), Line(heard, said))
    os._exit(0)  # the memory need not be tidied


def answer(path: Path, line: Line) -> None:
    """Evaluate a book, and then each set of its cells that is asked for."""
    from workbook.reading.files import open_book
    from workbook.reading.work import require_little_work
    from workbook.witnesses.pycel.model import PycelModel

    file = open_book(path)
    require_little_work(file)
    line.say(digest(path))
    model = PycelModel(file.contents)
    values = model.evaluate()
    formulas = file.contents.formula_cells
    line.say(([values[a] for a in formulas], model.problems))
    cells = [*(address for address, _ in cells_of(file)), *line.hear()]
    while True:
        numbers, found = line.hear()
        wanted_cells = [formulas[n] for n in numbers]
        results = model.each(wanted_cells, dict(zip(cells, found, strict=True)).get)
        line.say([results[a] for a in wanted_cells])
