"""A second process that evaluates a book's formulas while the first reads and judges it: verifying takes both cores.

It opens the same file for itself, under the same limits, and has its formulas joined and evaluated by the time that
the first asks. It says nothing by itself: what it does not answer, because it was killed, or read another state of the
file, or cannot be started, the first computes for itself, and finds the same.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbook.witnesses.line import Line

if TYPE_CHECKING:  # what the first process begins with must load in no time
    from workbook.book.address import Address, Strip
    from workbook.reading.contents import Cells
    from workbook.reading.files import BookFile
    from workbook.witnesses.witness import Answers, CellWitness, Model, Turn, Witness

Key = tuple[str, int]
EVALUATED = ("evaluated", 0)
NAME = "pycel"
"""the witness that evaluates beside"""
LARGEST = 20_000_000  # bytes of a file: both processes hold it
BEGIN = "import sys; sys.path[:] = {path!r}; from workbook.witnesses.beside import main; main({book!r})"


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

    def prepare(self, *needed: Any) -> None:
        """Let the process load, once it has evaluated, what it will need for what is said to it later."""
        with suppress(OSError):
            self._line.say(("load", needed))

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
        self._problems: Mapping[Address, str] | None = None
        self._heard: dict[Key, Any] = {}
        self._asked = 0

    @cached_property
    def here(self) -> Model:
        """The same formulas in this process."""
        return self._witness.model(self._file)

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""
        return self.here.problems if self._problems is None else self._problems

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""
        answer = self.answer(EVALUATED)
        if answer is None:
            return self.here.evaluate()
        values, self._problems = answer
        return dict(zip(self._file.contents.formula_cells, values, strict=True))

    def each(self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> Sequence[Any]:
        """Return the values of formula cells, each by itself, with ``values`` in the cells of ``strips``."""
        self._asked += 1
        self.say("each", self._asked, wanted, strips, values)
        answer: Sequence[Any] | None = self.answer(("each", self._asked))
        return self.here.each(wanted, strips, values) if answer is None else answer

    def elsewhere(self, strips: Sequence[Strip], turns: Sequence[Turn]) -> Callable[[], Answers]:
        """Begin with what :meth:`each` gives at each of ``turns``; return what yields it."""
        return Shared(self, strips, turns).answers

    def say(self, *message: Any) -> None:
        """Say something to the other process, if it is still there."""
        with suppress(OSError):
            self._line.say(message)

    def has(self, key: Key) -> bool:
        """Whether the other process has said something."""
        with suppress(EOFError):
            while self._line.waits:
                self._hear()
        return key in self._heard

    def answer(self, key: Key) -> Any:
        """Wait for what the other process says; return None where it is gone before that."""
        with suppress(EOFError):
            while key not in self._heard:
                self._hear()
        return self._heard.get(key)

    def _hear(self) -> None:
        key, said = self._line.hear()
        self._heard[key] = said


class Shared:
    """Turns that both processes take: this one from the first of them on, the other from the last."""

    def __init__(self, asked: Asked, strips: Sequence[Strip], turns: Sequence[Turn]) -> None:
        self._asked, self._strips, self._turns = asked, strips, turns
        self._mine: list[Any] = []  # what is stated at those that this process has taken
        asked.say("turns", strips, turns)
        while not asked.has(EVALUATED) and self._take():
            pass

    def answers(self) -> Answers:
        """Yield what the cells of each turn compute, and what is stated there."""
        while self._take():
            pass
        for n, turn in enumerate(self._turns):
            mine = self._mine[n] if n < len(self._mine) else None
            results, theirs = self._asked.answer(("turn", n)) or (None, None)
            stated = mine or theirs or turn.stated()
            if results is None:
                results = self._asked.here.each(turn.wanted, self._strips, stated.values)
            yield results, stated

    def _take(self) -> bool:
        """Take the next turn; return whether there was one that the other process had not begun."""
        n = len(self._mine)
        if n == len(self._turns) or self._asked.has(("begun", n)):
            return False
        self._asked.say("mine", n)
        self._mine.append(self._turns[n].stated())
        self._asked.say("at", n, self._mine[n].values)
        return True


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
    """Evaluate a book, and then whatever is asked for."""
    from workbook.reading.files import open_book, require_little_work
    from workbook.witnesses.pycel.model import PycelModel

    file = open_book(path, shown=False)
    require_little_work(file, path)
    line.say(digest(path))
    model = PycelModel(file.contents)
    values = model.evaluate()
    line.say((EVALUATED, ([values[a] for a in file.contents.formula_cells], model.problems)))
    serve(model, line)


def serve(model: Model, line: Line) -> None:
    """Answer what is asked, first what has come; meanwhile take turns, from the last, that the first process has not.

    It says which it begins, and what is stated there.
    """
    strips: Sequence[Strip] = ()
    turns: Sequence[Turn] = ()
    left: list[int] = []
    while True:
        if left and not line.waits:
            n = left.pop()
            line.say((("begun", n), True))
            stated = turns[n].stated()
            line.say((("turn", n), (model.each(turns[n].wanted, strips, stated.values), stated)))
            continue
        match line.hear():
            case "turns", strips, turns:
                left = list(range(len(turns)))
            case "mine", n:
                left = [other for other in left if other != n]
            case "at", n, values:
                line.say((("turn", n), (model.each(turns[n].wanted, strips, values), None)))
            case "each", n, wanted_cells, within, values:
                line.say((("each", n), model.each(wanted_cells, within, values)))
