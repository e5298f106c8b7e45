"""The report of a run as one page of HTML, for the project's folder: no script, nothing fetched from elsewhere."""

import math
import platform
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

import workbook
from workbook.build import write_text
from workbook.errors import WriteError
from workbook.judging.compare import TOLERANCE
from workbook.judging.many import Outcome
from workbook.judging.report import Finding, Ran, Report
from workbook.reports.html import Content, document, e, table
from workbook.writing.place import refuse_existing, replace


class Verdict(NamedTuple):
    """What is said of a verdict on the page, in a row of the terminal, and of several workbooks; its colour there."""

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
    "entry": "an entry that look-ups take for a pattern, a value or another name",
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
    compared = sum(o.report.compared for o in outcomes if o.report)
    names = ", ".join(o.path.name for o in outcomes) if len(outcomes) < 3 else f"{len(outcomes)} workbooks"
    title = f"Verification of {names}"
    body = [
        e("h1", title),
        e("p", f"{when:%Y-%m-%d %H:%M:%S %z}, motionbook {workbook.__version__}, Python {platform.python_version()}, "
               f"{platform.system()} {platform.machine()}", css="quiet"),
        e("p", f"Each formula was compared with the generated one, and its value, at the entered inputs and at others, "
               f"with that of an independent engine. A value agrees where it deviates by no more than {TOLERANCE:.0e} "
               f"of the greatest in its column. {compared:,} formula cells were compared."),
    ]  # fmt: skip
    if len(outcomes) > 1:
        body.append(summary(outcomes))
    for number, outcome in enumerate(outcomes, 1):
        body += section(outcome, f"book{number}")
    return document(title, body)


def summary(outcomes: Sequence[Outcome]) -> Element:
    """Return the table of all workbooks, each with a link to its section."""
    rows: list[list[Content]] = []
    for number, o in enumerate(outcomes, 1):
        counts = (f"{o.report.compared:,}", f"{len(o.report.causes):,}") if o.report else ("–", "–")
        rows.append([e("a", str(o.path), href=f"#book{number}"), *counts, verdict(o)])
    return table(("Workbook", "Formula cells", "Findings", "Verdict"), rows, numbers=(1, 2))


def section(outcome: Outcome, name: str) -> list[Element]:
    """Return what is to be said of one workbook."""
    head = [e("h2", outcome.path.name, id=name), e("p", verdict(outcome))]
    if outcome.report is None:
        return head + [e("p", line) for line in outcome.reason.splitlines()]
    report = outcome.report
    failing: list[list[Content]] = []
    failing += ([e("span", f"{c.sheet}!{c.cell}", css="cell"), c.what, c.found, c.says] for c in report.failing)
    sheets: list[list[Content]] = []
    for sheet, found in by_sheet(report).items():
        largest = deviation(report.deviations.get(sheet))
        sheets.append([sheet, f"{report.cells.get(sheet, 0):,}", largest, str(len(found))])
    notices: list[list[Content]] = [[where(f), f.what, figure(f.computed, 15), figure(f.expected, 15)]
                                    for f in report.notices]  # fmt: skip
    title = f"Notices ({len(notices):,}): reworded or gone, but misleading nobody"
    checked = ("Cell", "Check", "Says", "Where, and by how much")
    return [
        *head, facts(outcome, report), *titled("The machine's own checks that fail", checked, failing),
        *titled("Sheets", ("Sheet", "Formula cells", "Largest deviation", "Findings"), sheets, (1, 2, 3)),
        *findings(report), *titled(title, ("Cell", "What", "Found", "Expected"), notices), *remarks(report),
    ]  # fmt: skip


def facts(outcome: Outcome, report: Report) -> Element:
    """Return the table of what was verified, and by what."""
    known: list[tuple[str, Content]] = [
        ("File", e("span", str(outcome.path.absolute()), css="value")),
        ("SHA-256", e("code", outcome.sha256)),
        ("Template", report.template),
        *(("Witness", witness(ran)) for ran in report.witnesses),
        ("Formula cells declared", f"{report.declared:,}"),
        ("Formula cells compared", f"{report.compared:,}"),
        ("Findings", report.findings_words),
        ("The machine's own checks", own_verdict(report)),
    ]
    return e("table", e("tbody", *(e("tr", e("th", k, scope="row"), e("td", v)) for k, v in known)), css="facts")


def witness(ran: Ran) -> str:
    """Return in words what came of a witness."""
    if ran.absent:
        return f"{ran.name}: absent from this machine, not asked"
    counts = ((ran.at_fault, "at fault"), (ran.unfinished, "unfinished"))  # each declared cell is counted once
    counted = ", ".join([f"{ran.compared:,} cells compared", *(f"{n:,} {words}" for n, words in counts if n)])
    return f"{ran.name} {ran.version}: {ran.why or counted}"


def own_verdict(report: Report) -> str:
    """Return in words what the machine's own checks say."""
    failing = len(report.failing)
    said = f"{failing} of {len(report.checks)} FAIL" if failing else f"all {len(report.checks)} OK"
    return f"{said}, {report.unfinished:,} cells unfinished" if report.unfinished else said


def titled(title: str, heads: Sequence[str], rows: list[list[Content]], numbers: Sequence[int] = ()) -> list[Element]:
    """Return a table below its title; nothing where it has no rows."""
    return [e("h3", title), table(heads, rows, numbers)] if rows else []


def by_sheet(report: Report) -> dict[str, list[Finding]]:
    """Return the findings of each sheet that was compared or has any, and those of no sheet."""
    found: dict[str, list[Finding]] = {sheet: [] for sheet in report.cells}
    for finding in report.findings:
        found.setdefault(finding.sheet or ELSEWHERE, []).append(finding)
    return found


def findings(report: Report) -> list[Element]:
    """Return the table of all findings, worst first, and what their kinds mean."""
    if not report.findings:
        said = "None: every formula cell computes what the engine computes, and shows it."
        return [e("h3", "Findings"), e("p", said)]
    headings = ("Cell", "Kind", "What", "Found", "Expected", "Deviation", "By")
    meanings = "; ".join(f"{kind}: {KINDS[kind]}" for kind in dict.fromkeys(f.kind for f in report.findings))
    head = e("h3", f"Findings, worst first: {report.findings_words}")
    rows: list[list[Content]] = [
        [e("span", where(f), css="cell"), e("span", f.kind, css="kind"), f.what, e("span", told(f), css="value"),
         e("span", figure(f.expected, 15), css="value"), deviation(f.deviation), f.witness] for f in report.findings
    ]  # fmt: skip
    return [head, table(headings, rows, numbers=(5,)), e("p", f"{meanings}.", css="quiet")]


def told(finding: Finding) -> str:
    """Return what was found, and why it could not be evaluated."""
    found = figure(finding.computed, 15)
    return f"{found} ({finding.why})" if finding.why else found


def where(finding: Finding) -> str:
    """Return the cell of a finding, or what else it is about."""
    return f"{finding.sheet}!{finding.cell}" if finding.sheet else finding.cell


def remarks(report: Report) -> list[Element]:
    """Return the notes, and the formula cells of the engineer's own."""
    lines = [*report.notes, *([report.following_words] if report.following else [])]
    said = [e("h3", "Notes"), *(e("p", line) for line in lines)] if lines else []
    if report.own:
        said += [e("h3", f"Cells of your own ({len(report.own):,})"),
                 e("p", f"{report.own_words}: the engine has no value for them."),
                 e("p", ", ".join(report.own), css="cell")]  # fmt: skip
    return said


def verdict(outcome: Outcome) -> Element:
    """Return the verdict in words; its colour only repeats them."""
    return e("span", VERDICTS[outcome.verdict].page, css=f"verdict {outcome.verdict.replace(' ', '-')}")


def figure(value: Any, digits: int = 10) -> str:
    """Return a value for a table; a spreadsheet keeps 15 digits."""
    return f"{value:.{digits}g}" if isinstance(value, float) else "empty" if value is None else str(value)


def deviation(value: float | None) -> str:
    """Return a relative deviation; a dash where there is none to give."""
    return "–" if value is None or not math.isfinite(value) else f"{value:.1e}" if value else "0"


def ready(path: Path | None, suffixes: Sequence[str], overwrite: bool) -> None:
    """Raise WriteError, before the work begins, where a report may not be written to ``path``."""
    if path is None:
        return
    if path.suffix.lower() not in suffixes:
        raise WriteError(f"{path}: expected the name of a report, ending in {' or '.join(suffixes)}")
    refuse_existing(path, overwrite)


def write(path: Path | None, text: Callable[[], str], overwrite: bool) -> None:
    """Write a report where one was asked for, whole or not at all; raise WriteError where that cannot be."""
    if path is not None:
        replace(path, lambda draft: write_text(draft, text()), overwrite)
