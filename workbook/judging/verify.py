"""Verify a workbook: every formula cell against the engine, at the values entered and at variations of them."""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from workbook.book.address import Address
from workbook.book.quantity import FAIL, SAYS
from workbook.entries.machine import Machine
from workbook.errors import InputError, ReadError, WitnessError
from workbook.judging.comparison import Comparison, count_cells, is_error
from workbook.judging.display.cells import check_display
from workbook.judging.matching import Match, Pair, declared_place
from workbook.judging.report import ORDER, Check, Finding, Report, WitnessRun
from workbook.judging.structure import (
    audit,
    check_structure,
    layout_findings,
    mark_consequences,
    refuse_cut_cells,
    stale_functions,
)
from workbook.reading.contents import Cells
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, is_formula, open_book, require_little_work
from workbook.reading.table_fit import tear_lines
from workbook.templates import AnyTemplate
from workbook.witnesses.agreement import agreed_values
from workbook.witnesses.registry import ALL, WITNESSES
from workbook.witnesses.witness import CellWitness, evaluation_copy, naming_failures


def verify(path: Path, witnesses: Sequence[str] = ("pycel",)) -> Report:
    """Verify a workbook by the witnesses of these names, or by ``all`` that are on this machine.

    Raises ReadError or InputError for a book that cannot be read, a table that is torn or a witness that is unknown,
    WitnessError for any that is asked by name and is not on this machine.
    """
    names, absent = available_witnesses(witnesses)
    file = open_book(path)
    entries = Entries(file, agreed_values, refuse_cut_cells)
    if file.torn:
        raise InputError(tear_lines(file, file.torn))
    report = Report(path, entries.template.name, notes=list(file.notes))
    machine = entries.machine()
    report.notes += entries.beyond
    if entries.computed:
        cells = ", ".join(map(str, entries.computed))
        report.notes.append(f"inputs that hold a formula of their own: {cells}")
    judge(file, entries.template, machine, report, names, given=entries.computed, named=witnesses)
    report.witnesses += [WitnessRun(name, None) for name in absent]
    exact = entries.template.judge(machine)
    report.checks = [check.judged(exact) for check in report.checks]
    report.notes += exact.notes
    return report


def available_witnesses(witnesses: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the witnesses to ask, and those of ``all`` that are absent; raise as :func:`verify` does."""
    if unknown := [name for name in witnesses if name not in (*WITNESSES, ALL)]:
        known = ", ".join((*WITNESSES, ALL))
        raise ReadError(f"no witness is named {unknown[0]!r}; expected {known}")
    names = list(WITNESSES) if ALL in witnesses else list(dict.fromkeys(witnesses))
    absent = [name for name in names if WITNESSES[name]().version() is None]
    if named := [name for name in absent if name in witnesses]:
        mend = "--with all asks those that are"
        raise WitnessError(f"the witness {named[0]} is not on this machine; {mend}")
    return [name for name in names if name not in absent], absent


def judge(
    file: BookFile,
    template: AnyTemplate,
    machine: Machine,
    report: Report,
    witnesses: Sequence[str] = ("pycel",),
    given: Mapping[Address, Any] = MappingProxyType({}),
    named: Collection[str] = (),
) -> None:
    """Enter into ``report`` all findings in ``file``, whose inputs are ``machine``.

    ``given`` are the values of inputs that hold a formula. Witnesses that are ``named`` must answer, of the others any.
    """
    match = Match(file, template.declare(machine))
    report.findings += layout_findings(match)
    suspects = check_structure(match, report)
    report.notes += stale_functions(file.workbook)
    report.findings += audit(match, type(machine))
    own = count_own_cells(match, report, given)
    with evaluation_copy(file, own, given) as bare:
        require_little_work(bare, file.path)
        every = {name: make() for name, make in WITNESSES.items()}
        asked = [every[name] for name in witnesses]
        asked += [w for w in every.values() if w.kept and w not in asked]
        asked.sort(key=lambda w: w.kept)
        single = next(w for w in (*asked, *every.values()) if isinstance(w, CellWitness))
        with naming_failures(single):
            model = single.model(bare, (pair.address for pair in match.pairs))
        comparison = Comparison(match, bare, single, model, report)
        for witness in asked:
            comparison.ask(witness)
        for ran in report.witnesses:  # that failed though it was named, or as all did
            if ran.why and (not comparison.values or ran.name in named):
                failed = Finding("", ran.name, "witness", ran.why, "values to compare")
                report.findings.append(failed)
        comparison.compare_elsewhere(template, machine, suspects)
        report.checks = check_results(match, comparison.values)
        check_display(match, type(machine), comparison.values, report)
    mark_consequences(match, report, suspects)
    report.findings.sort(key=lambda f: (ORDER.index(f.kind), -f.deviation))
    blocks = match.declared.blocks.values()
    has_moved = any(file.places.get(block.name) != declared_place(block) for block in blocks)
    if report.findings and not has_moved:
        wrong = {(f.sheet, f.cell) for f in report.findings}
        cells = (((pair.address.sheet, pair.address.a1), pair.cell.content) for pair in match.pairs)
        report.formulas = {at: text for at, text in cells if at in wrong and is_formula(text)}
    count_cells(match, report)


def count_own_cells(match: Match, report: Report, given: Collection[Address]) -> set[Address]:
    """Count formula cells that belong to nothing declared; return those that nothing declared, but an input, needs."""
    contents = match.file.contents
    if not (own := {a for a in contents.formula_cells if a not in match.numbers}):
        return own
    ours = [p.address for p in match.pairs if p.declared_formula and p.address in contents.formulas]
    aside = own - contents.needed(own, ours)
    report.own = sorted(map(str, own))
    report.not_evaluated = len(aside - contents.needed(aside, given) if given else aside)
    return aside


def check_results(match: Match, computed: Cells) -> list[Check]:
    """Return the machine's checks, with what their cells compute, or what the engine says where these do not."""
    at = {pair.cell.block.name: pair for pair in match.pairs if not pair.cell.block.is_table}
    checks = []
    for sheet, quantity in match.declared.checks:
        pair = at.get(quantity.name)
        verdict = str(cell_text(pair, computed) or quantity.value or "unfinished")
        says = cell_text(at.get(f"{quantity.name}{SAYS}"), computed) if verdict == FAIL else ""
        where = (pair.address.sheet, pair.address.a1) if pair else (sheet.title, quantity.name)
        checks.append(Check(*where, quantity.label, verdict, says, quantity.name))
    return checks


def cell_text(pair: Pair | None, computed: Cells) -> str:
    """Return the text that a cell computes, or that the engine has for it; nothing where neither has any."""
    value = computed.get(pair.address) if pair else None
    if isinstance(value, str) and not is_error(value):
        return value
    return str(pair.cell.expected or "") if pair else ""
