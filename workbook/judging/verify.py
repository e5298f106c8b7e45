"""Compare a workbook with the engine: every formula cell, at the values entered and at others, by witnesses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from workbook.book.address import Address
from workbook.entries.machine import Machine
from workbook.errors import ReadError, WitnessError
from workbook.judging.audit import audit
from workbook.judging.compare import ERRORS, TOLERANCE, difference, is_error
from workbook.judging.functions import calling, notes
from workbook.judging.matching import Match, Pair, Right
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, open_book
from workbook.templates import Template
from workbook.witnesses import WITNESSES, by_cell
from workbook.witnesses.witness import CellWitness, Model, Witness

LONG, SPREAD = 12, 6  # of tables of so many rows, one row in so many is looked at, at one of the other inputs
SHARE = 3  # of shorter tables and single cells, every cell at one in so many of the other inputs
ORDER = (
    "missing",
    "replaced",
    "formula",
    "changed",
    "name",
    "function",
    "unread",
    "error",
    "value",
    "follows",
    "witness",
)
"""The kinds of findings, causes before what follows from them."""


@dataclass(frozen=True)
class Finding:
    """One cell that is not what it should be."""

    sheet: str
    cell: str
    kind: str
    computed: Any
    expected: Any
    what: str = ""
    deviation: float = math.inf  # relative to the greatest value of the column
    witness: str = ""


@dataclass
class Ran:
    """A witness that was asked: its version, how many cells it was compared in, or why it was not."""

    name: str
    version: str | None
    compared: int = 0
    why: str = ""

    @property
    def absent(self) -> bool:
        """Whether the witness is not on this machine."""
        return self.version is None


@dataclass
class Report:
    """What ``verify`` found in one workbook."""

    path: Path
    template: str
    compared: int = 0
    findings: list[Finding] = field(default_factory=list)
    deviations: dict[str, float] = field(default_factory=dict)  # the largest of each sheet
    cells: dict[str, int] = field(default_factory=dict)  # compared on each sheet
    witnesses: list[Ran] = field(default_factory=list)
    unmatched: list[str] = field(default_factory=list)  # formula cells that belong to nothing declared
    notes: list[str] = field(default_factory=list)

    @property
    def agrees(self) -> bool:
        """Whether every formula cell computes what the engine computes."""
        return not self.findings

    @property
    def witness(self) -> str:
        """The witnesses that answered, with their versions."""
        return ", ".join(f"{w.name} {w.version}" for w in self.witnesses if not w.absent)

    def add(
        self, pair: Pair, kind: str, computed: Any, expected: Any, deviation: float = math.inf, by: str = ""
    ) -> None:
        """Enter a finding on a declared cell."""
        address = pair.address
        self.findings.append(Finding(address.sheet, address.a1, kind, computed, expected, pair.what, deviation, by))


def verify(path: Path, witnesses: Sequence[str] = ("pycel",)) -> Report:
    """Verify one workbook with the witnesses of these names.

    Raises ReadError or InputError where the book cannot be read, and ReadError for a witness of unknown name.
    """
    unknown = [name for name in witnesses if name not in WITNESSES]
    if unknown:
        raise ReadError(f"no witness is named {unknown[0]!r}; expected {', '.join(WITNESSES)}")
    file = open_book(path)
    entries = Entries(file, by_cell().values)
    report = Report(path, entries.template.name, notes=list(file.notes))
    machine = entries.machine()
    if entries.computed:
        report.notes.append(f"inputs that hold a formula of their own: {', '.join(entries.computed)}")
    judge(file, entries.template, machine, report, witnesses)
    return report


def judge(
    file: BookFile, template: Template, machine: Machine, report: Report, witnesses: Sequence[str] = ("pycel",),
    shapes: bool = True,
) -> None:  # fmt: skip
    """Enter into ``report`` all that is found in ``file``, whose inputs are ``machine``.

    ``shapes`` false leaves the text of formulas aside, so that values alone must tell.
    """
    match = Match(file, template.declare(machine))
    suspects = structure(match, report, shapes)
    calls = calling(file.contents, match.declared_at)
    report.notes += notes(file.workbook, calls)
    for remark in audit(match, template.model, calls):
        report.findings.append(Finding(remark.sheet, remark.cell, remark.kind, remark.found, remark.expected))
    asked: list[Witness] = [WITNESSES[name]() for name in witnesses]
    single = next((w for w in asked if isinstance(w, CellWitness)), None) or by_cell()
    model = single.model(file)
    computed = values(match, asked, single, model, report)
    error_values(match, model, computed, report, calls)
    try:
        variants = template.variants(machine)
    except ValidationError:  # numbers so large that no neighbour of theirs is one
        report.notes.append("the values entered leave no room for other ones: compared at these alone")
    else:
        elsewhere(match, single.name, model, variants, template, report, suspects)
    report.unmatched = sorted(str(a) for a in file.contents.formulas if a not in match.declared_at)
    report.findings.sort(key=lambda f: (ORDER.index(f.kind), -f.deviation))


def structure(match: Match, report: Report, shapes: bool = True) -> set[Address]:
    """Enter missing blocks, and formulas and constants that are not the declared ones; return those formulas."""
    for block, place in match.misfits:
        expected = f"{block.size} rows by {len(block.quantities)} columns"
        found = f"{place.rows} rows by {place.columns} columns" if place else None
        where = (place.sheet, place.cell(0, 0).a1) if place else (block.sheet.title, block.name)
        report.findings.append(Finding(*where, "missing", found, expected, block.title or block.quantities[0].label))
    suspects = set()
    for pair in match.pairs:
        if pair.cell.quantity.role == "input":
            continue
        if not pair.declared_formula:
            if pair.held != pair.cell.content:
                report.add(pair, "changed", pair.held, pair.cell.content)
        elif not (isinstance(pair.held, str) and pair.held.startswith("=")):
            report.add(pair, "missing" if pair.held is None else "replaced", pair.held, pair.cell.expected)
        elif not match.same_shape(pair):
            suspects.add(pair.address)
            if shapes:
                report.add(pair, "formula", pair.held, pair.cell.content)
    return suspects


def values(
    match: Match, asked: Sequence[Witness], single: CellWitness, model: Model, report: Report
) -> dict[Address, Any]:  # fmt: skip
    """Compare what each witness computes at the values entered; return what the first that answered computes.

    ``model`` is what the witness ``single`` has of the file already.
    """
    answer: dict[Address, Any] = {}
    for witness in asked:
        ran = Ran(witness.name, witness.version())
        report.witnesses.append(ran)
        if ran.absent:
            report.findings.append(Finding("", ran.name, "witness", "absent", "a witness that is on this machine"))
            continue
        try:
            computed = model.evaluate() if witness is single else witness.values(match.file)
        except WitnessError as error:
            ran.why = str(error)
            report.findings.append(Finding("", ran.name, "witness", str(error), "values to compare"))
            continue
        ran.compared = compared(match, model, computed, report, ran.name)
        answer = answer or computed
    report.compared = max((w.compared for w in report.witnesses), default=0)
    return answer


def error_values(match: Match, model: Model, computed: dict[Address, Any], report: Report, calls: set[Address]) -> None:
    """Enter the error values of cells that belong to nothing declared: constants, and the engineer's own formulas.

    A witness that does not know MOTION.* gives #NAME? in ``calls``, and in what follows from these.
    """
    contents = match.file.contents
    for address, value in {**contents.constants, **computed}.items():
        if not is_error(value) or value not in ERRORS or address in match.declared_at:
            continue
        follows = calls and address in contents.formulas and address not in model.problems
        if not (value == "#NAME?" and (address in calls or follows)):
            report.findings.append(Finding(address.sheet, address.a1, "error", value, "no error value"))


def compared(match: Match, model: Model, computed: dict[Address, Any], report: Report, by: str) -> int:
    """Compare one witness's values; tell the cells at fault from those that only follow them. Return how many."""
    count, wrong = 0, []
    formulas = set(match.file.contents.formula_cells)
    first = by == report.witnesses[0].name
    right = Right(match, match.declared)
    for pair in match.pairs:
        if not pair.declared_formula or pair.address not in formulas:
            continue
        count += 1
        value = computed.get(pair.address)
        deviation = difference(value, pair.cell.expected, right.peak(pair.address))
        sheet = pair.address.sheet
        if first:
            report.cells[sheet] = report.cells.get(sheet, 0) + 1
        if math.isfinite(deviation):
            report.deviations[sheet] = max(report.deviations.get(sheet, 0.0), deviation)
        if not deviation <= TOLERANCE:
            wrong.append((pair, value, deviation))
    if wrong:
        at_fault = faults(model, right, {pair.address for pair, _, _ in wrong}) if by != "saved" else None
        for pair, value, deviation in wrong:
            kind = "error" if is_error(value) else "value"
            own = at_fault is None or pair.address in at_fault or not at_fault
            report.add(pair, kind if own else "follows", value, pair.cell.expected, deviation, by)
    return count


def faults(model: Model, right: Right, wrong: set[Address]) -> set[Address]:
    """Return the cells that are wrong even when all that they refer to is right."""
    computed = model.each(wrong, right.get)
    return {a for a, value in computed.items() if not difference(value, right.get(a), right.peak(a)) <= TOLERANCE}


def elsewhere(
    match: Match, by: str, model: Model, machines: list[Machine], template: Template, report: Report,
    suspects: set[Address],
) -> None:  # fmt: skip
    """Compare at other inputs, each cell with the right values around it.

    Formulas that are not the declared ones are evaluated at every variation, the others in turn.
    """
    if any(place is None for _, place in match.misfits):
        return
    known = {(f.sheet, f.cell) for f in report.findings}
    pairs = {p.address: p for p in match.pairs if p.declared_formula and p.address in match.file.contents.formulas}
    for k, (machine, turn) in enumerate(zip(machines, turns(pairs, suspects, len(machines)), strict=True), 1):
        right = Right(match, template.declare(machine))
        for a, value in model.each(turn, right.get).items():
            deviation = difference(value, right.get(a), right.peak(a))
            if not deviation <= TOLERANCE and (a.sheet, a.a1) not in known:
                known.add((a.sheet, a.a1))
                where = f"{by}, at variation {k} of the inputs"
                report.add(pairs[a], "value", value, right.get(a), deviation, where)


def turns(pairs: dict[Address, Pair], suspects: set[Address], variations: int) -> list[list[Address]]:
    """Return the cells that are looked at in each variation."""
    found: list[list[Address]] = [[] for _ in range(variations)]
    for n, (address, pair) in enumerate(pairs.items()):
        cell = pair.cell
        if address in suspects:
            every, first = 1, 0
        elif cell.block.size < LONG:
            every, first = SHARE, n % SHARE
        else:
            every, first = variations, cell.i // SPREAD % variations + (variations if cell.i % SPREAD else 0)
        for turn in found[first::every]:
            turn.append(address)
    return found
