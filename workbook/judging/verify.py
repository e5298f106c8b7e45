"""Verify a workbook: every formula cell against the engine, at the values entered and at variations of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pydantic import ValidationError

from workbook.book.address import Address
from workbook.entries.machine import Machine
from workbook.errors import ReadError, WitnessError
from workbook.judging.audit import audit
from workbook.judging.compare import ERRORS
from workbook.judging.comparing import Comparison, count
from workbook.judging.functions import calling, notes
from workbook.judging.matching import Match
from workbook.judging.report import ORDER, Finding, Ran, Report
from workbook.judging.settings import settings
from workbook.judging.shown.book import displayed
from workbook.judging.structure import structure
from workbook.judging.verdict import checks
from workbook.reading.contents import Cells
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, open_book
from workbook.templates import AnyTemplate
from workbook.witnesses import WITNESSES, by_cell
from workbook.witnesses.agreed import agreed
from workbook.witnesses.witness import CellWitness, Model, Witness

ALL = "all"


def verify(path: Path, witnesses: Sequence[str] = ("pycel",)) -> Report:
    """Verify one workbook with the witnesses of these names, or with ``all`` that are on this machine.

    Raises ReadError or InputError where the book cannot be read, ReadError for a witness of unknown name, and
    WitnessError for one that is asked by name and is not on this machine.
    """
    names, absent = present(witnesses)
    file = open_book(path)
    entries = Entries(file, agreed)
    report = Report(path, entries.template.name, notes=list(file.notes))
    machine = entries.machine()
    if entries.computed:
        report.notes.append(f"inputs that hold a formula of their own: {', '.join(entries.computed)}")
    judge(file, entries.template, machine, report, names)
    report.witnesses += [Ran(name, None) for name in absent]
    return report


def present(witnesses: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the witnesses to ask, and those of ``all`` that are absent; raise as :func:`verify` does."""
    unknown = [name for name in witnesses if name not in (*WITNESSES, ALL)]
    if unknown:
        raise ReadError(f"no witness is named {unknown[0]!r}; expected {', '.join((*WITNESSES, ALL))}")
    names = list(WITNESSES) if ALL in witnesses else list(dict.fromkeys(witnesses))
    absent = [name for name in names if WITNESSES[name]().version() is None]
    named = [name for name in absent if name in witnesses]
    if named:
        raise WitnessError(f"the witness {named[0]} is not on this machine; --with all asks those that are")
    return [name for name in names if name not in absent], absent


def judge(
    file: BookFile, template: AnyTemplate, machine: Machine, report: Report, witnesses: Sequence[str] = ("pycel",),
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
    report.findings += settings(file.workbook)
    comparison = compared(match, report, witnesses)
    error_values(match, comparison.model, comparison.values, report, calls)
    try:
        variants = template.variants(machine)
    except ValidationError:  # numbers so large that no neighbour of theirs is one
        report.notes.append("the values entered leave no room for other ones: compared at these alone")
    else:
        comparison.elsewhere(map(template.declare, variants), len(variants), suspects)
    report.checks = checks(match, comparison.values)
    displayed(match, comparison.values, report)
    report.unmatched = sorted(str(a) for a in file.contents.formula_cells if a not in match.declared_at)
    report.findings.sort(key=lambda f: (ORDER.index(f.kind), -f.deviation))
    count(match, report)


def compared(match: Match, report: Report, names: Sequence[str]) -> Comparison:
    """Ask each witness of these names, and then those that keep values, whether they were named or not."""
    asked: list[Witness] = [WITNESSES[name]() for name in names]
    single = next((w for w in asked if isinstance(w, CellWitness)), None) or by_cell()
    asked += [w for w in (make() for name, make in WITNESSES.items() if name not in names) if w.kept]
    comparison = Comparison(match, single, report)
    for witness in sorted(asked, key=lambda w: w.kept):
        comparison.ask(witness, required=witness.name in names)
    return comparison


def error_values(match: Match, model: Model, computed: Cells, report: Report, calls: set[Address]) -> None:
    """Enter the error values of cells that belong to nothing declared: constants, and the engineer's own formulas.

    A witness that does not know MOTION.* gives #NAME? in ``calls``, and in what follows from these.
    """
    contents = match.file.contents
    constants = {address: contents.constants[address] for address in contents.errors}
    for address, value in {**constants, **computed}.items():
        if value not in ERRORS or address in match.declared_at:
            continue
        follows = calls and address in contents.formulas and address not in model.problems
        if not (value == "#NAME?" and (address in calls or follows)):
            report.findings.append(Finding(address.sheet, address.a1, "error", value, "no error value"))
