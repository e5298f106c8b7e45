"""The value of a formula that an engineer entered where a number or a text is expected: it must be beyond doubt."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from typing import Any

from workbook.book.address import Address
from workbook.book.formula import words
from workbook.book.rows import is_number
from workbook.errors import DisputedError, WitnessError, quoted
from workbook.reading.contents import Cells, Contents
from workbook.reading.files import BookFile, require_little_work
from workbook.witnesses.registry import WITNESSES
from workbook.witnesses.witness import CYCLE, Witness, evaluation_copy, naming_failures

ENOUGH = 2  # evaluators that must agree
DEVIATION, ZERO = 1e-9, 1e-15  # relative, and of what is zero but for rounding
MOST = 160  # characters of why a witness failed
UNKNOWN = (None, "#NAME?")  # what a witness has for a function that it does not know
UNABLE = {"pycel": (*UNKNOWN, "#VALUE!", "#REF!")}  # and what it has for more that it cannot take
# functions that read other cells than those they name, or more of these than their values
ELSEWHERE = frozenset(
    ("INDIRECT OFFSET CELL INFO SHEET SHEETS FORMULATEXT ISFORMULA SUBTOTAL AGGREGATE GETPIVOTDATA EVALUATE").split()
)
SIGNS = frozenset("+-*/^&=<>%")
OVER_ARRAYS = frozenset(("SUMPRODUCT(", "MMULT(", "LOOKUP("))  # functions that take all cells computed in them


def agreed_values(
    file: BookFile, asked: Collection[Address] = (), names: Iterable[str] = WITNESSES
) -> Callable[[Address], Any]:
    """Return a function that gives a cell's value, or raises DisputedError unless two of ``names`` agree on it."""
    return Evaluation(file, asked, names).value


class Evaluation:
    """The values of a file by the witnesses in succession, each asked only where it is needed."""

    def __init__(self, file: BookFile, asked: Collection[Address], names: Iterable[str]) -> None:
        self._file, self._names = file, list(names)
        self._said: dict[str, Cells] = {}
        self._failed: dict[str, str] = {}  # why a witness cannot open a file
        self._asked = asked
        self._left: dict[str, Iterator[Collection[Address]]] = {}  # the files that a witness was not given yet

    def value(self, address: Address) -> Any:
        """Return the value of a cell; raise DisputedError as :func:`agreed_values` says."""
        self._require_one_cell(address)
        by_name: dict[str, Any] = {}
        for name, values in self._witnesses(address):
            by_name[name] = values.get(address)
            if by_name[name] == CYCLE:
                raise DisputedError("it computes from itself, or from cells that do")
            known = {name: value for name, value in by_name.items() if value not in UNABLE.get(name, UNKNOWN)}
            alike = len(by_name) == ENOUGH and not {*by_name.values()} & {*UNKNOWN} and len({*by_name.values()}) == 1
            if len(known) == ENOUGH or alike:
                saved = self._file.saved.get(address)
                first, *others = (known if len(known) == ENOUGH else by_name).values()
                if all(same_value(first, value) for value in (*others, *([] if saved is None else [saved]))):
                    return first
                raise DisputedError(", ".join(self._told(address, by_name)))
        why = [*self._told(address, by_name), *self._failed.values()]
        raise DisputedError(f"it cannot be computed by {ENOUGH} evaluators ({'; '.join(why)})")

    def _require_one_cell(self, address: Address) -> None:
        """Raise DisputedError where the value hangs on a range of which Excel takes one cell, unless it was saved."""
        if self._file.saved.get(address) is not None:
            return
        contents = self._file.contents
        formulas = set(contents.formula_cells)
        needed = contents.needed(formulas - {address}, formulas & {address}) | (formulas & {address})
        for cell in sorted(needed):
            text = self._file.value(cell)
            if cell not in contents.arrays and isinstance(text, str) and needs_intersection(text):
                where = "it" if cell == address else f"{cell}"
                raise DisputedError(f"{where} computes with a range where Excel takes one cell of it")

    def _told(self, address: Address, values: dict[str, Any]) -> list[str]:
        saved = self._file.saved.get(address)
        all_said = values if saved is None else values | {"the file as it was saved": saved}
        return [f"{name} has {quoted(value)}" for name, value in all_said.items()]

    def _witnesses(self, address: Address) -> Iterator[tuple[str, Cells]]:
        """Yield the witnesses that evaluate, with the values of formula cells."""
        for name in self._names:
            witness = WITNESSES[name]()
            if witness.kept or witness.version() is None:
                continue
            values = self._said.setdefault(name, {})
            try:
                if address not in values:
                    values |= self._values(name, witness, address)
            except (WitnessError, OSError) as error:  # the latter of a file that is gone since it was opened
                self._failed[name] = str(error)[:MOST]
                continue
            yield name, values

    def _values(self, name: str, witness: Witness, address: Address) -> Cells:
        """Return the values of a witness in the first file that it can open; else in any of what a cell depends on."""
        for cells in self._left.setdefault(name, files_of(self._file.contents, self._asked)):
            try:
                return self._computed(witness, cells)
            except WitnessError as error:
                self._failed[name] = str(error)[:MOST]
        alone = not reads_elsewhere(self._file.contents, {address})
        if not alone and name in self._failed:
            raise WitnessError(self._failed[name])
        return self._computed(witness, {address} if alone else self._file.contents.formula_cells)

    def _computed(self, witness: Witness, cells: Collection[Address]) -> Cells:
        """Return the values of a witness in a file of formula cells and of those on which they depend."""
        aside = set(self._file.contents.formula_cells).difference(cells)
        with evaluation_copy(self._file, aside - self._file.contents.needed(aside, cells), {}) as bare:
            require_little_work(bare, self._file.path)
            with naming_failures(witness):
                return witness.values(bare)


def files_of(contents: Contents, asked: Collection[Address]) -> Iterator[Collection[Address]]:
    """Yield formula cells for files until a witness can open a file: all, though they take long, if more is read."""
    if reads_elsewhere(contents, asked):
        yield contents.formula_cells
        asked = [cell for cell in asked if not reads_elsewhere(contents, {cell})]
    if asked:
        yield asked


def reads_elsewhere(contents: Contents, asked: Collection[Address]) -> bool:
    """Whether formulas, or those they depend on, that can be taken apart read more than the cells that they name."""
    others = set(contents.formula_cells).difference(asked)
    read = (contents.formulas.get(cell) for cell in contents.needed(others, asked).union(asked))
    return not all(formula is None or formula.functions.isdisjoint(ELSEWHERE) for formula in read)


def same_value(value: Any, other: Any, zero: float = ZERO, relative: float = DEVIATION) -> bool:
    """Whether two values are the same but for rounding; numbers also by a difference of ``zero``."""
    if is_number(value) and is_number(other):
        return math.isclose(value, other, rel_tol=relative, abs_tol=zero)
    return type(value) is type(other) and bool(value == other)


def needs_intersection(formula: str) -> bool:
    """Whether a range stands for a single cell of it (support.microsoft.com, "Implicit intersection operator: @")."""
    parts = list(words(formula.removeprefix("=")))
    begun: list[str] = []
    for k, (kind, word) in enumerate(parts):
        if kind == "function" or word == "(":
            begun.append(word.upper())
        elif word == ")" and begun:
            begun.pop()
        elif kind == "lines" or (kind == "reference" and is_range(word)):
            called = [word for word in begun if word != "("]
            if not called or (is_operand(parts, k) and OVER_ARRAYS.isdisjoint(called)):
                return True
    return False


def is_range(word: str) -> bool:
    """Whether a reference means several cells."""
    first, _, last = word.rpartition("!")[2].replace("$", "").upper().partition(":")
    return last not in ("", first)


def is_operand(parts: list[tuple[str, str]], k: int) -> bool:
    """Whether a sign of an operation stands before or behind a word, its brackets left aside."""
    before, after = k - 1, k + 1
    while before >= 0 and after < len(parts) and (parts[before][1], parts[after][1]) == ("(", ")"):
        before, after = before - 1, after + 1
    beside = [parts[at][1] for at in (before, after) if 0 <= at < len(parts)]
    return not SIGNS.isdisjoint(beside)
