"""Verify a workbook: every formula cell against the engine, at the values entered and at variations of them."""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from pydantic import ValidationError

from workbook.book.address import Address
from workbook.entries.machine import Machine
from workbook.errors import ReadError, WitnessError
from workbook.judging.audit import audit
from workbook.judging.comparing import Comparison, count
from workbook.judging.functions import notes
from workbook.judging.layout import follow, laid_out, layout
from workbook.judging.matching import Match
from workbook.judging.moved import put_back
from workbook.judging.order import in_order, is_empty_row, unlike
from workbook.judging.report import NOTICE, ORDER, Finding, Ran, Report
from workbook.judging.right import Variation
from workbook.judging.settings import settings
from workbook.judging.shown.book import displayed
from workbook.judging.structure import structure
from workbook.judging.verdict import checks
from workbook.reading.contents import Cells
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, open_book
from workbook.reading.work import require_little_work
from workbook.templates import AnyTemplate
from workbook.witnesses.agreed import agreed
from workbook.witnesses.bare import without
from workbook.witnesses.beside import Beside
from workbook.witnesses.names import ALL
from workbook.witnesses.registry import WITNESSES, by_cell
from workbook.witnesses.witness import CellWitness, Witness


def verify(path: Path, witnesses: Sequence[str] = ("pycel",), beside: Beside | None = None) -> Report:
    """Verify one workbook with the witnesses of these names, or with ``all`` that are on this machine.

    ``beside`` is a second process that evaluates this book meanwhile.

    Raises ReadError or InputError where the book cannot be read, ReadError for a witness of unknown name, and
    WitnessError for one that is asked by name and is not on this machine.
    """
    names, absent = present(witnesses)
    file = open_book(path)
    entries = Entries(file, agreed, in_order)
    if beside is not None:
        beside.prepare(Variation, entries.template)
    report = Report(path, entries.template.name, notes=list(file.notes))
    for found in entries.moved:
        (report.notices if found.kind == NOTICE else report.findings).append(found)
    machine = entries.machine()
    report.notes += entries.beyond
    if entries.computed:
        report.notes.append(f"inputs that hold a formula of their own: {', '.join(map(str, entries.computed))}")
    judge(file, entries.template, machine, report, names, given=entries.computed, beside=beside, named=witnesses)
    report.witnesses += [Ran(name, None) for name in absent]
    if not machine.design.replaced:
        report.notes += entries.template.truths(machine)
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
    shapes: bool = True, given: Mapping[Address, Any] = MappingProxyType({}), beside: Beside | None = None,
    named: Collection[str] = (),
) -> None:  # fmt: skip
    """Enter into ``report`` all that is found in ``file``, whose inputs are ``machine``.

    ``shapes`` false leaves the text of formulas aside, so that values alone must tell. ``given`` are the values of
    inputs that hold a formula. Witnesses that are ``named`` must answer, of the others one.
    """
    match, machine = laid_out(file, template, machine)
    if any(pair.declared_formula and pair.held is None for pair in match.pairs):
        report.findings += put_back(file, match.declared)
        match = Match(file, match.declared)
    report.findings += layout(match)
    suspects = structure(match, report, shapes)
    report.notes += notes(file.workbook)
    for remark in audit(match, type(machine)):
        report.findings.append(Finding(remark.sheet, remark.cell, remark.kind, remark.found, remark.expected))
    report.findings += settings(file.workbook)
    own = own_cells(match, report, given)
    with without(file, own, given) as bare:
        require_little_work(bare, file.path)
        asked = witnesses_named(witnesses, beside)
        single = next((w for w in asked if isinstance(w, CellWitness)), None) or by_cell()
        comparison = Comparison(match, bare, single, report)
        try:
            variants = template.variants(machine)
        except ValidationError:  # numbers so large that no neighbour of theirs is one
            report.notes.append("the values entered leave no room for other ones: compared at these alone")
        else:
            comparison.ask_elsewhere([Variation(template, m, match.columns) for m in variants], suspects)
        for witness in asked:
            comparison.ask(witness)
        comparison.require_answers(named)
        if any(map(is_empty_row, report.notices)):
            unlike(values_as_they_stand(file.path), match, comparison.values, report)
        computed = len(report.findings)
        report.checks = checks(match, comparison.values)
        displayed(match, type(machine), comparison.values, report)
        comparison.elsewhere(computed)
    follow(match, report, suspects)
    report.findings.sort(key=lambda f: (ORDER.index(f.kind), -f.deviation))
    count(match, report)


def values_as_they_stand(path: Path) -> Cells:
    """Return the values of the formula cells of a file whose entries are not put in order."""
    return by_cell().model(open_book(path)).evaluate()


def own_cells(match: Match, report: Report, given: Collection[Address]) -> set[Address]:
    """Count the formula cells that belong to nothing declared; return those that nothing declared depends on.

    On some of them an input may depend whose value is among ``given``.
    """
    contents = match.file.contents
    own = {a for a in contents.formula_cells if a not in match.declared_at}
    if not own:
        return own
    declared = [p.address for p in match.pairs if p.declared_formula and p.address in contents.formulas]
    aside = own - contents.needed(own, declared)
    report.own = sorted(map(str, own))
    report.not_evaluated = len(aside - contents.needed(aside, given) if given else aside)
    return aside


def witnesses_named(names: Sequence[str], beside: Beside | None) -> list[Witness]:
    """Return the witnesses of these names, and then those that keep values, whether they were named or not."""
    asked: list[Witness] = [WITNESSES[name]() for name in names]
    asked += [w for w in (make() for name, make in WITNESSES.items() if name not in names) if w.kept]
    if beside is not None:
        asked = list(map(beside.witness, asked))
    return sorted(asked, key=lambda w: w.kept)
