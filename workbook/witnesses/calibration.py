"""The evaluators of a book, held at the entered values against what was saved and against each other.

None is right everywhere. An evaluator is trusted for a cell where it gives what Excel or LibreOffice saved there, else
where two give the same; through all cases the first of those trusted computes.
"""

import re
from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from typing import Any

from pycel.lib.function_info import all_excel_functions

from workbook.book.address import Address
from workbook.book.formula import FormulaError, functions_in, words
from workbook.errors import WitnessError, listed, quoted
from workbook.reading.contents import Cells, Contents
from workbook.reading.files import BookFile
from workbook.witnesses.agreement import same_value
from workbook.witnesses.pycel.compiled import check_function
from workbook.witnesses.pycel.graph import Graph
from workbook.witnesses.pycel.model import PycelModel
from workbook.witnesses.registry import WITNESSES
from workbook.witnesses.witness import CYCLE, evaluation_copy, naming_failures

FIRST = "pycel"  # the evaluator that is asked first: it holds the formulas open, and computes them fastest
NAMES = (FIRST, "formulon", "ironcalc", "libreoffice")  # those asked by default, the slowest last
QUICK = NAMES[:3]
ERRORS = frozenset("#DIV/0! #N/A #NAME? #NULL! #NUM! #REF! #VALUE! #SPILL! #CALC!".split())  # those that Excel has
CLOCK = frozenset("NOW TODAY RAND RANDBETWEEN RANDARRAY INFO CELL".split())  # whose value is another each time
NEWER = frozenset(
    (
        "ANCHORARRAY ARRAYTOTEXT BYCOL BYROW CHOOSECOLS CHOOSEROWS COPILOT DETECTLANGUAGE DROP EXPAND GROUPBY HSTACK"
        " IMAGE ISOMITTED LAMBDA MAKEARRAY MAP PERCENTOF PIVOTBY PY REDUCE REGEXEXTRACT REGEXREPLACE REGEXTEST SCAN"
        " SINGLE STOCKHISTORY TAKE TEXTAFTER TEXTBEFORE TEXTSPLIT TOCOL TOROW TRANSLATE TRIMRANGE VALUETOTEXT VSTACK"
        " WRAPCOLS WRAPROWS"
    ).split()
)  # functions of Excel that are not on pycel's list of all
LOST = 1e-4  # relative, of digits that programs lose otherwise, as in LOG10(COS(RADIANS(90)))
SMALLEST = 1e-12  # by which two numbers that are the same may deviate
LINK = re.compile(r"\[[^\]]+\][^!']*'?!")
ONLY_LINK = re.compile(r"=\+?(?:'[^'\[]*\[[^\]]+\][^']*'|\[[^\]]+\][\w.]*)!\$?[A-Za-z]{1,3}\$?\d+")
MANY = 2_000  # formula cells above which copies of a formula are tried at some of its rows
ROWS = 24  # of these


class Evaluators:
    """The evaluators of a book: what each gives at the entered values, which are trusted, and where none is."""

    def __init__(self, file: BookFile, model: PycelModel, names: Sequence[str], given: Cells) -> None:
        self.file, self.model, self.names = file, model, list(names)
        self.notes: list[str] = []
        self.trusted: dict[Address, list[str]] = {}
        self.stale: dict[Address, Any] = {}  # what two give where another value was saved
        self.answers: dict[str, Cells] = {}  # without what an evaluator cannot compute
        self.gaps: dict[str, set[Address]] = {}  # the cells in which it fails by itself
        contents = file.contents
        self.cells = {*model.formulas, *(cell for cell in contents.failed if cell.sheet in file.workbook.sheetnames)}
        self.graph: Graph = model.graph({cell: contents.rough_areas(cell) for cell in contents.failed})
        self.clock = self.graph.reached({cell for cell in self.cells if functions_in(self.text(cell)) & CLOCK})
        self.circles: set[Address] = set()  # cells that compute from themselves, where no book may
        self.saved = file.saved if file.has_results else {}
        self.evidence = {} if not file.is_evidence else {x: v for x, v in self.saved.items() if v is not None}
        # a cell that is a link alone has the value that the other file gave
        links = {x: v for x, v in self.saved.items() if ONLY_LINK.fullmatch(self.text(x))}
        self.linked = {x: v for x, v in links.items() if v is not None and v not in ERRORS}
        self.given = {**given, **self.linked}
        if self.linked:
            cells = listed([f"{cell} {self.text(cell)}" for cell in self.linked])
            self.notes.append(f"of other files the values are used that were saved here: {cells}")
        self._settle()

    @cached_property
    def unnamed(self) -> set[Address]:
        """The cells that have #NAME? in Excel too: of words that it does not know, or of such a value read."""
        entered = {cell for cell, value in self.file.contents.constants.items() if value == "#NAME?"}
        own = {cell for cell in self.cells if has_unknown_word(self.text(cell), self.file.contents, cell.sheet)}
        return self.graph.reached(entered | own)

    def text(self, cell: Address) -> str:
        """Return the formula of a cell."""
        return self.file.contents.texts.get(cell) or str(self.file.value(cell))

    def _settle(self) -> None:
        """Ask one evaluator after the other, until each cell has one that is trusted."""
        left = self.cells - self.clock
        for name in list(self.names):
            if left or name == FIRST:
                try:
                    self._ask(name, left)
                except WitnessError as error:
                    self.drop(name, error)
                    continue
                left -= {cell for cell in left if self._is_settled(cell)}
        for cell in left - self.evidence.keys():  # by one alone, if by any
            self.trusted[cell] = [name for name in self.names if cell in self.answers.get(name, {})][:1]

    def drop(self, name: str, error: WitnessError) -> None:
        """Ask an evaluator no more, and note why."""
        self.notes.append(f"{name} was not asked further: {error}")
        self.names.remove(name)
        self.answers.pop(name, None)
        for cell, trusted in self.trusted.items():
            if name in trusted:
                rest = [other for other in trusted if other != name]
                self.trusted[cell] = rest or [n for n in self.names if cell in self.answers.get(n, {})][:1]

    def _ask(self, name: str, left: Collection[Address]) -> None:
        if name == FIRST:
            values = self.model.evaluate(self.given)
            if not (self.file.workbook.calculation and self.file.workbook.calculation.iterate):
                # where Excel has a value, it is of a branch that is not on the circle: of one it saves 0
                self.circles = {
                    cell for cell, value in values.items() if value == CYCLE and not self.evidence.get(cell)
                }
            self._enter(name, values)
        elif (rows := self._sample(left)) and self.agreed_rows(name, rows) >= {*left}:
            self._enter(name, {cell: self.answers[FIRST][cell] for cell in left})
        else:
            with naming_failures(witness := WITNESSES[name]()):
                ((_, values),) = witness.varied(self.file, [self.given])
            self._enter(name, values)

    def agreed_rows(self, name: str, rows: set[Address]) -> set[Address]:
        """Return the copies of each formula on which an evaluator agrees with pycel in all those that are tried."""
        first, contents = self.answers[FIRST], self.file.contents
        asked = rows | contents.read([*contents.constants, *contents.formula_cells], rows)
        own = {cell for cell in (*contents.constants, *self.cells) if cell not in asked}
        others = {cell: first[cell] for cell in asked - rows if cell in first}
        with (
            naming_failures(witness := WITNESSES[name]()),
            evaluation_copy(self.file, own, others | self.given) as copy,
        ):
            values = witness.values(copy)
        agree = {cell for cell in rows if is_same(values.get(cell), first[cell])}
        alike = rows_alike(contents, self.cells)
        return {cell for cells in alike if agree >= (rows & {*cells}) for cell in cells}

    def _sample(self, left: Collection[Address]) -> set[Address]:
        """Return some rows of each formula that is copied; nothing where all are to be asked."""
        contents = self.file.contents
        if len(left) <= MANY or self.gaps.get(FIRST) or contents.failed or self.answers.keys() != {FIRST}:
            return set()
        if any(functions_in(shape) & {"OFFSET", "INDIRECT"} for shape in {f.shape for f in contents.formulas.values()}):
            return set()
        return {
            cells[i * (len(cells) - 1) // (ROWS - 1)] if len(cells) > ROWS else cells[min(i, len(cells) - 1)]
            for cells in rows_alike(contents, self.cells)
            for i in range(ROWS)
        }

    def _enter(self, name: str, values: Cells) -> None:
        """Keep the values of an evaluator without those that are its own gaps, or follow from such."""
        values = values | self.given
        gaps = {cell for cell in self.cells if self._is_gap(name, cell, values.get(cell))}
        lacking = self.graph.reached(gaps) if gaps else set()
        self.gaps[name] = gaps
        self.answers[name] = {cell: values[cell] for cell in self.cells if cell in values and cell not in lacking}

    def _is_gap(self, name: str, cell: Address, value: Any) -> bool:
        if cell in self.given or cell in self.circles:
            return False
        if isinstance(value, str) and value in ERRORS and LINK.search(self.text(cell)):
            return True
        if value == "#NAME?":
            return cell not in self.unnamed
        return is_no_value(value) or (name == FIRST and cell in self.model.problems)

    def _is_settled(self, cell: Address) -> bool:
        """Whether an evaluator is trusted for a cell; enter which, and a saved value that two give otherwise."""
        by = {name: values[cell] for name, values in self.answers.items() if cell in values}
        if cell in self.circles:
            self.trusted[cell] = [FIRST]
            return True
        saved = self.saved.get(cell)
        right = [name for name in by if is_same(by[name], saved)]
        if right and cell in self.evidence:
            self.trusted[cell] = right
            return True
        for value in by.values():
            alike = [name for name in by if is_same(by[name], value)]
            if len(alike) > 1 or len(self.names) == 1:
                self.trusted[cell] = alike
                if not (saved is None or {*alike} & {*right} or same_value(value, saved, relative=LOST)):
                    self.stale[cell] = value
                return True
        return False

    def is_alone(self, cell: Address) -> bool:
        """Whether the evaluator of a cell is confirmed by no other."""
        confirmed = cell in self.evidence or cell in self.circles or len(self.names) == 1
        return len(self.trusted.get(cell, ())) == 1 and not confirmed

    def first(self, cell: Address) -> str | None:
        """Return the evaluator that computes a cell through all cases; None where none can."""
        return next(iter(self.trusted.get(cell, ())), None)

    def others(self, name: str, cell: Address) -> list[str]:
        """Return the other evaluators to ask for a cell: those not known to be wrong or unable there."""
        if cell in self.circles:
            return []
        asked = (other for other in self.names if other != name and cell in self.answers.get(other, {cell: None}))
        right = cell in self.evidence and cell not in self.stale
        return [other for other in asked if not right or other not in self.answers or other in self.trusted[cell]]

    def values(self, name: str, sets: Sequence[Cells], cells: Sequence[Address]) -> list[Cells]:
        """Return the values of cells that an evaluator gives at each set; none where it fails, and is dropped."""
        if name == FIRST:
            return [self.model.evaluate(given) for given in sets]
        try:
            with naming_failures(witness := WITNESSES[name]()):
                return [values for _, values in witness.varied(self.file, sets, cells)]
        except WitnessError as error:
            self.drop(name, error)
            return []

    def reasons(self) -> dict[Address, str]:
        """Return why no evaluator computes a cell, for each such cell: a function, a construct, or what it reads."""
        reasons = dict.fromkeys(self.clock, "another value each time")
        own = set.intersection(*self.gaps.values()) if self.gaps else set()
        constructs = {cell: construct_of(self.text(cell), cell in self.file.contents.arrays) for cell in own}
        for number in self.graph.order():
            cell = self.graph.cells.get(number)
            if cell in self.cells and cell not in reasons and self.first(cell) is None:
                sources = (self.graph.cells.get(source) for source in self.graph.sources(number))
                known = constructs.get(cell) or next((reasons[s] for s in sources if s in reasons), None)
                reasons[cell] = known or "no evaluator computes all that it reads"
        return reasons | {
            cell: constructs.get(cell, "a circle") for cell in self.cells - reasons.keys() if not self.first(cell)
        }

    def disputed(self, cell: Address) -> str:
        """Return the values of evaluators at the entered inputs where no two agree; else nothing."""
        by = {name: values[cell] for name, values in self.answers.items() if cell in values}
        return ", ".join(f"{name} {quoted(by[name])}" for name in by) if self.is_alone(cell) and len(by) > 1 else ""

    def line(self, cells: Collection[Address]) -> str:
        """Return in a line how many formulas were judged by whom, and why others could not be."""
        reasons = self.reasons()
        by = ((cell, self.trusted[cell]) for cell in cells if cell not in reasons)
        labels = ("disputed" if self.disputed(x) else FIRST if FIRST in t else " and ".join(t) for x, t in by)
        counts = [f"{number:,} {name}" for name, number in Counter(labels).most_common()]
        why = Counter(reasons[cell] for cell in cells if cell in reasons)
        if why:
            words = listed([f"{what} ×{number}" for what, number in why.most_common()])
            counts.append(f"{why.total():,} cannot ({words})")
        return f"{len(cells):,} formulas: {', '.join(counts) or 'none'}"


def present(names: Iterable[str]) -> list[str]:
    """Return those of evaluators that are on this machine."""
    return [name for name in names if WITNESSES[name]().version() is not None]


def is_same(value: Any, other: Any) -> bool:
    """Whether two values are the same but for rounding; of errors any two: evaluators differ in which comes first."""
    return same_value(value, other, SMALLEST) or {value, other} <= ERRORS


def is_no_value(value: Any) -> bool:
    """Whether an evaluator says by its value that it has none: nothing, or an error that Excel does not have."""
    return value is None or (
        isinstance(value, str) and value.startswith("#") and value.endswith(("!", "?")) and value not in ERRORS
    )


def rows_alike(contents: Contents, cells: Iterable[Address]) -> list[list[Address]]:
    """Return the formula cells of each formula that is copied down a column, in their order."""
    groups: dict[tuple[str, int, str], list[Address]] = {}
    for cell in cells:
        if cell in contents.formulas:
            groups.setdefault((cell.sheet, cell.column, contents.formulas[cell].shape), []).append(cell)
    return [sorted(group) for group in groups.values()]


def has_unknown_word(text: str, contents: Contents, sheet: str) -> bool:
    """Whether a formula has a function or a name that Excel would not know either."""
    functions = functions_in(text)
    if any(not (name in all_excel_functions or name in NEWER or contents.knows(name, sheet)) for name in functions):
        return True
    if "[" in text:
        return False
    names = (word.rpartition("!")[2] for kind, word in words(text) if kind == "name")
    return any(
        name.upper() not in ("TRUE", "FALSE") and not name.startswith("_xl") and not contents.knows(name, sheet)
        for name in names  # those of LET and LAMBDA begin so
    )


def construct_of(text: str, array: bool) -> str:
    """Return the part of a formula at which evaluators fail: a link, a function, another construct."""
    if LINK.search(text):
        return "external link"
    for name in sorted(functions_in(text)):
        try:
            check_function(name)
        except FormulaError:
            return name
    return "array formula" if array else "a name or reference"
