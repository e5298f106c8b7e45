"""Compare what each witness computes with the engine's values: at the values entered, and at variations of them."""

import math
from collections import Counter
from typing import Any

from pydantic import ValidationError

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.book.rows import is_number
from workbook.book.sentence import Sentence
from workbook.entries.machine import Machine
from workbook.errors import WitnessError
from workbook.judging.matching import Match, Pair
from workbook.judging.report import CAUSES, Report, WitnessRun
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.templates import AnyTemplate
from workbook.witnesses.witness import CellWitness, Model, Witness, in_full, naming_failures

TOLERANCE = 1e-9  # relative to the greatest value of the cell's column


def difference(computed: Any, expected: Any, peak: float) -> float:
    """Return the deviation relative to ``peak``: 0 for equal texts, or sentences but for rounding; else infinite."""
    if isinstance(expected, Sentence):
        return 0.0 if expected.says(computed) else math.inf
    if not (is_number(computed) and is_number(expected)):
        return 0.0 if type(computed) is type(expected) and computed == expected else math.inf
    gap = abs(computed - expected)
    return gap / peak if peak else (0.0 if gap == 0 else math.inf)


def is_error(value: Any) -> bool:
    """Whether a value is an error of spreadsheets."""
    return isinstance(value, str) and value.startswith("#")


class ExpectedValues:
    """The expected values of a matched file's cells, by a declaration of the same layout."""

    def __init__(self, match: Match, declared: Book) -> None:
        self._match = match
        # the engine's, what was entered in inputs, what is declared in constants
        self.values: list[Any] = []
        # the greatest sizes of columns, or declared scales where these are greater
        self.peaks: list[float] = []
        for pairs, _, q, column in match.by_quantity(declared):
            self.values += column
            sizes = (abs(v) for v in column if isinstance(v, int | float) and abs(v) < math.inf)
            self.peaks += [max(q.floor, *sizes, 0.0)] * len(pairs)

    def get(self, address: Address) -> Any:
        """Return the expected content of a cell; None for a cell that is not declared."""
        number = self._match.numbers.get(address)
        return None if number is None else self.values[number]

    def peak(self, address: Address) -> float:
        """Return the scale of a declared cell's deviations."""
        return self.peaks[self._match.numbers[address]]

    def differs(self, at: Address, value: Any) -> bool:
        """Whether a value of a cell is not the engine's, where the engine has any."""
        expected = self.get(at)
        return expected is not None and not difference(value, expected, self.peak(at)) <= TOLERANCE


# of tables of so many rows, a row in so many is looked at, at any of the other inputs
LONG, SPREAD = 12, 6
SHARE = 3  # of shorter tables and single cells, every cell at each in so many of the other inputs
NO_EVIDENCE = "as built: no evidence of its own"


class Comparison:
    """A matched file, what it should hold, and ``bare``: the file, or a copy without own cells, for the witnesses."""

    def __init__(self, match: Match, bare: BookFile, single: CellWitness, model: Model, report: Report) -> None:
        self.match, self.bare, self.single, self.model = match, bare, single, model
        self.report = report
        self.right = ExpectedValues(match, match.declared)
        cells = set(match.file.contents.formula_cells)
        declared = [pair for pair in match.pairs if pair.declared_formula]
        self.pairs = {pair.address: pair for pair in declared if pair.address in cells}
        self.values: Cells = {}  # of the first witness that computed any
        self._first_wrong: set[Address] = set()  # by that witness
        report.cells |= Counter(pair.address.sheet for pair in declared)

    def ask(self, witness: Witness) -> None:
        """Compare what a witness says, or enter why it says nothing; raise WitnessError where all rests on it."""
        ran = WitnessRun(witness.name, witness.version())
        self.report.witnesses.append(ran)
        try:
            file = self.match.file if witness.kept else self.bare
            with naming_failures(witness):
                values = self.model.evaluate() if witness is self.single else witness.values(file)
                if not witness.kept:
                    self._require_most(witness, values)
        except WitnessError as error:
            if witness is self.single:
                raise
            ran.why = str(error)
            return
        if witness.kept:
            self._kept(ran, values)
        else:
            self._computed(ran, values)

    def _require_most(self, witness: Witness, values: Cells) -> None:
        """Raise WitnessError where a witness itself failed in half of the cells: that is no fault of theirs."""
        raised = self.model.raised if witness is self.single else ()
        lacking = [a for a in self.pairs if a in raised or values.get(a) is None]
        wanted = {a for a, pair in self.pairs.items() if pair.cell.expected is not None} if lacking else set()
        without = [a for a in lacking if a in wanted]
        if without and 2 * len(without) >= len(wanted):
            why = self.model.problems.get(without[0], "no value") if raised else "no value"
            most = f"in {len(without):,} of {len(wanted):,} formula cells, the first {without[0]}: {why}"
            raise WitnessError(f"{in_full(witness.name, witness.version())} failed {most}")

    def _computed(self, ran: WitnessRun, values: Cells) -> None:
        """Enter the cells at fault, and those that are wrong only because they refer to such."""
        wrong = self._wrong(values, first=not self.values)
        places = [pair.address for pair, _ in wrong]
        self._first_wrong = self._first_wrong if self.values else set(places)
        at_fault = self._at_fault(places)
        explained = bool(at_fault) or any(f.kind in CAUSES for f in self.report.findings)
        problems = self.model.problems if ran.name == self.single.name else {}
        for pair, deviation in wrong:
            value = values.get(pair.address)
            own = pair.address in at_fault or not explained or pair.address not in self._first_wrong
            kind = "follows" if not own else "error" if is_error(value) else "value"
            unknown = "it could not be evaluated" if value is None else ""
            why = problems.get(pair.address, "") or unknown
            self.report.add(pair, kind, value, pair.cell.expected, deviation, ran.name, why)
        self.values = self.values or values

    def _at_fault(self, places: list[Address]) -> set[Address]:
        """Return the cells that are wrong even when all that they refer to is right."""
        numbers = [self.match.numbers[a] for a in places]
        alone = self.model.each(numbers, self.right.values) if numbers else []
        return {a for a, value in zip(places, alone, strict=True) if self.right.differs(a, value)}

    def _kept(self, ran: WitnessRun, values: Cells) -> None:
        """Enter values that the file was saved with and that no longer are what its cells compute."""
        if self.match.file.as_built:
            ran.version = f"{ran.version}, {NO_EVIDENCE}"
        for pair, deviation in self._wrong(values, first=False):
            held, computed = values.get(pair.address), self.values.get(pair.address)
            peak = self.right.peak(pair.address)
            if not self.values or not difference(held, computed, peak) <= TOLERANCE:
                self.report.add(pair, "saved", held, pair.cell.expected, deviation, ran.name)

    def _wrong(self, values: Cells, first: bool) -> list[tuple[Pair, float]]:
        """Return the cells that are not what they should be, with their deviations."""
        wrong = []
        for address, pair in self.pairs.items():
            if (expected := pair.cell.expected) is None:  # unfinished
                continue
            value = values.get(address)
            alike = value == expected and type(value) is type(expected)
            deviation = 0.0 if alike else difference(value, expected, self.right.peak(address))
            if first and math.isfinite(deviation):
                known = self.report.deviations
                known[address.sheet] = max(known.get(address.sheet, 0.0), deviation)
            if not deviation <= TOLERANCE:
                wrong.append((pair, deviation))
        return wrong

    def compare_elsewhere(self, template: AnyTemplate, machine: Machine, suspects: set[Address]) -> None:
        """Enter what is wrong at variations of the inputs: cells in turn, the ``suspects`` at each."""
        try:
            machines = template.variants(machine)
        except ValidationError:  # numbers so large that no neighbour of theirs is a number
            note = "the values entered leave no room for other ones: compared at these alone"
            self.report.notes.append(note)
            return
        known = {(f.sheet, f.cell) for f in self.report.findings}
        pairs = {a: p for a, p in self.pairs.items() if a in self.match.file.contents.formulas}
        turns = by_variation(pairs, suspects, len(machines))
        for k, (turn, varied) in enumerate(zip(turns, machines, strict=True), 1):
            right = ExpectedValues(self.match, template.declare(varied))
            by = f"{self.single.name}, at variation {k} of the inputs"
            values = self.model.each([self.match.numbers[a] for a in turn], right.values)
            for a, value in zip(turn, values, strict=True):
                if right.differs(a, value) and (a.sheet, a.a1) not in known:
                    known.add((a.sheet, a.a1))
                    deviation = difference(value, right.get(a), right.peak(a))
                    self.report.add(self.pairs[a], "value", value, right.get(a), deviation, by)


def by_variation(pairs: dict[Address, Pair], suspects: set[Address], variations: int) -> list[list[Address]]:
    """Return the cells that are looked at in each variation."""
    by_turn: list[list[Address]] = [[] for _ in range(variations)]
    for n, (address, pair) in enumerate(pairs.items()):
        i, every = pair.cell.i, SHARE if pair.cell.block.size < LONG else variations
        spread = i // SPREAD % variations + (variations if i % SPREAD else 0)
        first = n % SHARE if pair.cell.block.size < LONG else spread
        for turn in by_turn if address in suspects else by_turn[first::every]:
            turn.append(address)
    return by_turn


def count_cells(match: Match, report: Report) -> None:
    """Count each declared formula cell once for each witness that answered: compared, at fault, or unfinished."""
    formulas = [pair for pair in match.pairs if pair.declared_formula]
    cells = {(p.address.sheet, p.address.a1) for p in formulas} if report.findings else set()
    unfinished = {(p.address.sheet, p.address.a1) for p in formulas if p.cell.expected is None}
    blocks = match.declared.blocks.values()
    columns = ((block.size, q) for block in blocks for q in block.quantities)
    report.declared = sum(size for size, q in columns if q.formula is not None)
    for ran in (ran for ran in report.witnesses if ran.answered):
        others = {w.name for w in report.witnesses} - {ran.name}
        own = [f for f in report.findings if f.witness.partition(",")[0] not in others]
        faulty = {(f.sheet, f.cell) for f in own} & cells
        ran.at_fault = report.declared - len(formulas) + len(faulty)
        ran.unfinished = len(unfinished - faulty)
        ran.compared = report.declared - ran.at_fault - ran.unfinished
    report.compared = max((w.compared for w in report.witnesses), default=0)
