"""The report of a run: a page of HTML; JUnit XML for CI servers; SARIF 2.1.0 for code hosts.

Source: OASIS, Static Analysis Results Interchange Format (SARIF) Version 2.1.0, 2020.
"""

import json
import math
import platform
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

import workbook
from workbook.errors import WriteError
from workbook.judging.batch import Outcome
from workbook.judging.comparison import TOLERANCE
from workbook.judging.report import Finding, Report, WitnessRun
from workbook.reports.html import document, render
from workbook.writing.output_files import refuse_existing, write_text

COUNTED = (("tests", ""), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped"))
DESIGN = "the machine's own checks"
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
OTHERS = {"design": "a check of the machine's own fails", "unreadable": "the file cannot be read"}


class Verdict(NamedTuple):
    """The words for a verdict on the page, in a row of the terminal, and of several workbooks; its colour there."""

    page: str
    row: str
    several: str
    colour: str


VERDICTS = {
    "agrees": Verdict("Agrees", "agrees", "agree", "green"),
    "fails": Verdict("Agrees; the design fails", "agrees, DESIGN FAILS", "agree and fail their own checks", "red"),
    "disagrees": Verdict("Disagrees", "DISAGREES", "disagree", "red"),
    "unreadable": Verdict("Cannot be read", "CANNOT BE READ", "cannot be read", "red"),
    "no machine": Verdict("Skipped", "skipped, no machine", "skipped (no machine)", "dim"),
}
KINDS = {
    "layout": "a row or a column was put into a table, or is gone from it",
    "missing": "a cell or block that should be there is not",
    "replaced": "a value stands where a formula should",
    "formula": "the formula is not the one that was generated",
    "changed": "a text or constant is not as generated",
    "name": "a defined name does not lead where it should",
    "setting": "a setting by which the program shows other values than the formulas have",
    "function": "a function that the witnesses do not agree on, or a volatile one",
    "unread": "an input that no formula reads",
    "error": "the formula gives an error value",
    "value": "the formula gives another value than the engine",
    "follows": "the cell is right in itself, but refers to one that is not",
    "saved": "the value that the file was saved with, and shows on opening, is not what the cell computes",
    "shown": "what is displayed tells another number, quantity or verdict than the cell has",
    "witness": "a witness did not give its values",
}
ELSEWHERE = "(no sheet)"


def page(outcomes: Sequence[Outcome], when: datetime) -> str:
    """Return the report of a run: a summary of all workbooks, then a section for each."""
    names = ", ".join(o.path.name for o in outcomes) if len(outcomes) < 3 else f"{len(outcomes)} workbooks"
    versions = f"motionbook {workbook.__version__}, Python {platform.python_version()}"
    return document(
        f"Verification of {names}",
        "reports/page.html",
        when=f"{when:%Y-%m-%d %H:%M:%S %z}",
        outcomes=outcomes,
        versions=f"{versions}, {platform.system()} {platform.machine()}",
        tolerance=f"{TOLERANCE:.0e}",
        compared=sum(o.report.compared for o in outcomes if o.report),
    )


def witness(ran: WitnessRun) -> str:
    """Return in words what came of a witness."""
    if ran.absent:
        return f"{ran.name}: absent from this machine, not asked"
    # each declared cell is counted once
    counts = ((ran.at_fault, "at fault"), (ran.unfinished, "unfinished"))
    counted = ", ".join([f"{ran.compared:,} cells compared", *(f"{n:,} {words}" for n, words in counts if n)])
    return f"{ran.name} {ran.version}: {ran.why or counted}"


def own_verdict(report: Report) -> str:
    """Return in words what the machine's own checks say."""
    failing = len(report.failing)
    words = f"{failing} of {len(report.checks)} FAIL" if failing else f"all {len(report.checks)} OK"
    return f"{words}, {report.unfinished:,} cells unfinished" if report.unfinished else words


def by_sheet(report: Report) -> dict[str, list[Finding]]:
    """Return the findings of each sheet that was compared or has any, and those of no sheet."""
    findings: dict[str, list[Finding]] = {sheet: [] for sheet in report.cells}
    for finding in report.findings:
        findings.setdefault(finding.sheet or ELSEWHERE, []).append(finding)
    return findings


def found_words(finding: Finding) -> str:
    """Return the value of a finding, and the reason where it could not be evaluated."""
    value = figure(finding.computed, 15)
    return f"{value} ({finding.why})" if finding.why else value


def where(finding: Finding) -> str:
    """Return the cell of a finding, or what else it is about."""
    return f"{finding.sheet}!{finding.cell}" if finding.sheet else finding.cell


def figure(value: Any, digits: int = 10) -> str:
    """Return a value for a table; a spreadsheet keeps 15 digits."""
    if isinstance(value, float):
        return f"{value:.{digits}g}"
    return "empty" if value is None else str(value)


def deviation(value: float | None) -> str:
    """Return a relative deviation; a dash where there is none to give."""
    return "–" if value is None or not math.isfinite(value) else f"{value:.1e}" if value else "0"


def require_writable(path: Path | None, suffixes: Sequence[str], overwrite: bool) -> None:
    """Raise WriteError, before the work begins, where a report may not be written to ``path``."""
    if path is not None and path.suffix.lower() not in suffixes:
        raise WriteError(f"{path}: expected the name of a report, ending in {' or '.join(suffixes)}")
    refuse_existing(path, overwrite)


def write(path: Path | None, text: Callable[[], str], overwrite: bool) -> None:
    """Write a report where it was asked for, whole or not at all; raise WriteError where that cannot be."""
    if path is not None:
        write_text(path, text(), overwrite)


class Case(NamedTuple):
    """A case of JUnit: whether it failed, is an error or was skipped, and why."""

    name: str
    tag: str = ""
    message: str = ""
    type: str = ""
    lines: str = ""


def junit(outcomes: Sequence[Outcome], when: datetime) -> str:
    """Return the run as JUnit XML: a suite for each workbook, a case for each sheet; findings are failures."""
    return render(
        "reports/junit.xml",
        suites=[(outcome, cases(outcome)) for outcome in outcomes],
        counted=COUNTED,
        when=f"{when.astimezone(UTC):%Y-%m-%dT%H:%M:%S}",
        count=lambda cases, tag: sum(tag in ("", case.tag) for case in cases),
    )


def cases(outcome: Outcome) -> list[Case]:
    """Return a case for each sheet of a workbook and for its own checks, or a case for a book that was not read."""
    report, case_list = outcome.report, list[Case]()
    if report is None:
        # it was rightly passed over
        tag = "skipped" if outcome.verdict == "no machine" else "error"
        return [Case("open", tag, outcome.reason.partition("\n")[0], outcome.verdict, outcome.reason)]
    for sheet, some in by_sheet(report).items():
        more = f" (and {len(some) - 1} more)" if len(some) > 1 else ""
        failed = ("failure", line(some[0]) + more, some[0].kind, "\n".join(map(line, some))) if some else ()
        case_list.append(Case(sheet, *failed))
    lines = "\n".join(check.line for check in report.failing)
    failed = () if report.holds else ("failure", own_verdict(report), "design", lines)
    return [*case_list, Case(DESIGN, *failed)]


def line(finding: Finding) -> str:
    """Return a finding in a line."""
    what = f" ({finding.what})" if finding.what else ""
    by = f" [{finding.witness}]" if finding.witness else ""
    value, expected = found_words(finding), figure(finding.expected, 15)
    return f"{where(finding)}{what}: {finding.kind}: found {value}, expected {expected}{by}"


def sarif(outcomes: Sequence[Outcome]) -> str:
    """Return the run: each finding is an error, each failing check of a machine a warning."""
    results = []
    for outcome in outcomes:
        if outcome.verdict == "unreadable":
            results.append(result(outcome.path, "unreadable", "error", outcome.reason))
        for f in outcome.report.findings if outcome.report else ():
            results.append(result(outcome.path, f.kind, "error", line(f), f"{f.sheet}!{f.cell}"))
        for check in outcome.report.failing if outcome.report else ():
            results.append(result(outcome.path, "design", "warning", check.line, f"{check.sheet}!{check.cell}"))
    return sarif_log(KINDS | OTHERS, results)


def sarif_log(kinds: Mapping[str, str], results: Sequence[dict[str, Any]]) -> str:
    """Return the log of a run by its kinds of findings, in words, and its results."""
    rules = [{"id": kind, "shortDescription": {"text": words}} for kind, words in kinds.items()]
    driver = {"name": "motionbook", "version": workbook.__version__, "rules": rules}
    run = {"tool": {"driver": driver}, "columnKind": "unicodeCodePoints", "results": results}
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(log, ensure_ascii=False, indent=1) + "\n"


def result(path: Path, rule: str, level: str, text: str, cell: str = "") -> dict[str, Any]:
    """Return a result; the cell is its logical location, as a workbook has no lines."""
    where: dict[str, Any] = {"physicalLocation": {"artifactLocation": {"uri": path.as_posix()}}}
    if cell:
        where["logicalLocations"] = [{"fullyQualifiedName": cell}]
    return {"ruleId": rule, "level": level, "message": {"text": text}, "locations": [where]}
