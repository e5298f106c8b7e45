"""The report of a run as one page of HTML, for the project's folder: no script, nothing fetched from elsewhere."""

from __future__ import annotations

import math
import platform
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, tostring

import workbook
from workbook.build import write_text
from workbook.errors import WriteError
from workbook.judging.compare import TOLERANCE
from workbook.judging.one import Outcome
from workbook.judging.report import Finding, Ran, Report
from workbook.visible import visible
from workbook.writing.place import refuse_existing, replace

VERDICTS = {
    "agrees": "Agrees",
    "fails": "Agrees; the design fails",
    "disagrees": "Disagrees",
    "unreadable": "Cannot be read",
    "no machine": "Skipped",
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
STYLE = """
:root { color-scheme: light; }
body { font: 10.5pt/1.45 "Segoe UI", "Helvetica Neue", Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 62rem; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.55rem; margin: 0 0 .3rem; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .6rem; padding-top: .9rem; border-top: 2px solid #1f3a5f; }
h3 { font-size: 1rem; margin: 1.5rem 0 .4rem; }
h1, h2, h3 { color: #1f3a5f; overflow-wrap: anywhere; }
p { margin: .4rem 0; max-width: 48rem; }
table { border-collapse: collapse; width: 100%; margin: .4rem 0; }
th, td { text-align: left; vertical-align: top; padding: .25rem .6rem .25rem 0; border-bottom: 1px solid #d5dae1;
  overflow-wrap: break-word; }
thead th { border-bottom: 1.5px solid #1f3a5f; font-weight: 600; white-space: nowrap; }
table.facts { width: auto; } table.facts th { font-weight: 600; white-space: nowrap; padding-right: 1.5rem; }
td { font-variant-numeric: tabular-nums; } .kind { white-space: nowrap; }
a, .value { overflow-wrap: anywhere; }
th.number, td.number { text-align: right; white-space: nowrap; padding-right: 1.4rem; }
div.wide { overflow-x: auto; } table.wide td { white-space: nowrap; }
table.wide thead th { white-space: normal; vertical-align: bottom; max-width: 9rem; }
code, .cell { font-family: Consolas, "DejaVu Sans Mono", monospace; font-size: .92em; }
.verdict { display: inline-block; font-weight: 600; padding: .1rem .6rem; border: 1.5px solid; border-radius: 3px; }
.agrees { color: #14612f; } .disagrees, .unreadable, .fails { color: #a31515; } .not-ours { color: #555; }
.quiet { color: #555; font-size: .92em; }
body:has(#live) { max-width: 112rem; }
.beside { display: grid; grid-template-columns: minmax(30rem, 2fr) 3fr; gap: 2rem; align-items: start; }
.beside textarea { box-sizing: border-box; width: 100%; font: 10pt/1.4 Consolas, "DejaVu Sans Mono", monospace; }
.left { position: sticky; top: 0; height: calc(100vh - 8rem); display: flex; flex-direction: column; }
.beside textarea { height: 34vh; white-space: pre; } #live h2 { margin-top: 1rem; }
#form { flex: 1; overflow: auto; border-bottom: 1px solid #d5dae1; }
#form h3, #form h4 { margin: .8rem 0 .2rem; } #form td, #form th { padding-right: .3rem; }
.edge { fill: #fff; stroke: #1f3a5f; stroke-width: 2; cursor: ew-resize; } .edge:focus { fill: #1f3a5f; outline: none; }
.lane { cursor: ew-resize; } .lane:focus { font-weight: 700; outline: none; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: .8rem; margin: 1.2rem 0; }
@media (max-width: 1200px) { .pictures { grid-template-columns: 1fr; } }
button { margin: 0 .3rem; } .busy::after { content: " … at work"; } td form, .above form { display: inline; }
.entry label:first-child { display: inline-block; min-width: 15rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); gap: 1rem; }
.gallery img { max-width: 100%; }
.sheet { font-size: 8pt; } .sheet h1 { font-size: 1.4rem; } .columns { display: grid; grid-template-columns: 2fr 3fr; }
.sheet td, .sheet th { padding: .1rem .3rem .1rem 0; white-space: normal; }
.sheet svg { max-height: 44mm; width: 100%; } .sheet .columns svg { max-height: 56mm; }
@media print {
  @page { size: A4; margin: 12mm 14mm; } .screen { display: none; } .pictures { grid-template-columns: 1fr 1fr; }
  body { font-size: 9pt; margin: 0; padding: 0; max-width: none; }
  h2, h3, thead { break-after: avoid; } thead { display: table-header-group; } tr { break-inside: avoid; }
  a { color: inherit; text-decoration: none; }
}
"""
Content = Element | str


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


def document(title: str, body: Sequence[Element]) -> str:
    """Return a page of HTML."""
    head = e("head", e("meta", charset="utf-8"), e("title", title), e("style", STYLE),
             e("meta", name="viewport", content="width=device-width, initial-scale=1"))  # fmt: skip
    html = e("html", head, e("body", *body), lang="en")
    return f"<!DOCTYPE html>\n{markup(html)}\n"


def summary(outcomes: Sequence[Outcome]) -> Element:
    """Return the table of all workbooks, each with a link to its section."""
    rows: list[list[Content]] = [
        [
            e("a", str(o.path), href=f"#book{number}"),
            f"{o.report.compared:,}" if o.report else "–",
            f"{len(o.report.causes):,}" if o.report else "–",
            verdict(o),
        ]
        for number, o in enumerate(outcomes, 1)
    ]
    return table(("Workbook", "Formula cells", "Findings", "Verdict"), rows, numbers=(1, 2))


def section(outcome: Outcome, name: str) -> list[Element]:
    """Return what is to be said of one workbook."""
    head = [e("h2", outcome.path.name, id=name), e("p", verdict(outcome))]
    if outcome.report is None:
        return head + [e("p", line) for line in outcome.reason.splitlines()]
    report = outcome.report
    found = (*checks(report), *sheets(report), *findings(report), *notices(report), *remarks(report))
    return [*head, facts(outcome, report), *found]


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
    return f"{ran.name} {ran.version}: {ran.why or counted(ran)}"


def counted(ran: Ran) -> str:
    """Return in words what came of the declared formula cells; each is counted once."""
    counts = ((ran.at_fault, "at fault"), (ran.unfinished, "unfinished"))
    return ", ".join([f"{ran.compared:,} cells compared", *(f"{n:,} {words}" for n, words in counts if n)])


def own_verdict(report: Report) -> str:
    """Return in words what the machine's own checks say."""
    failing = len(report.failing)
    said = f"{failing} of {len(report.checks)} FAIL" if failing else f"all {len(report.checks)} OK"
    return f"{said}, {report.unfinished:,} cells unfinished" if report.unfinished else said


def checks(report: Report) -> list[Element]:
    """Return the table of the machine's own checks that do not hold."""
    rows: list[list[Content]] = [
        [e("span", f"{c.sheet}!{c.cell}", css="cell"), c.what, c.found, c.says] for c in report.failing
    ]
    headings = ("Cell", "Check", "Says", "Where, and by how much")
    return [e("h3", "The machine's own checks that fail"), table(headings, rows, ())] if rows else []


def notices(report: Report) -> list[Element]:
    """Return the table of what is reworded or gone, and misleads nobody."""
    if not report.notices:
        return []
    headings = ("Cell", "What", "Found", "Expected")
    rows: list[list[Content]] = [[where(f), f.what, exact(f.computed), exact(f.expected)] for f in report.notices]
    return [e("h3", f"Notices ({len(report.notices):,}): reworded or gone, but misleading nobody"),
            table(headings, rows, ())]  # fmt: skip


def sheets(report: Report) -> list[Element]:
    """Return the table of sheets: what was compared on each, how much it deviates, what was found."""
    rows: list[list[Content]] = [
        [sheet, f"{report.cells.get(sheet, 0):,}", deviation(report.deviations.get(sheet)), str(len(found))]
        for sheet, found in by_sheet(report).items()
    ]
    headings = ("Sheet", "Formula cells", "Largest deviation", "Findings")
    return [e("h3", "Sheets"), table(headings, rows, numbers=(1, 2, 3))]


def by_sheet(report: Report) -> dict[str, list[Finding]]:
    """Return the findings of each sheet that was compared or has any, and those of no sheet."""
    found: dict[str, list[Finding]] = {sheet: [] for sheet in report.cells}
    for finding in report.findings:
        found.setdefault(finding.sheet or ELSEWHERE, []).append(finding)
    return found


def findings(report: Report) -> list[Element]:
    """Return the table of all findings, worst first, and what their kinds mean."""
    if not report.findings:
        return [
            e("h3", "Findings"),
            e("p", "None: every formula cell computes what the engine computes, and shows it."),
        ]
    headings = ("Cell", "Kind", "What", "Found", "Expected", "Deviation", "By")
    meanings = "; ".join(f"{kind}: {KINDS[kind]}" for kind in dict.fromkeys(f.kind for f in report.findings))
    return [
        e("h3", f"Findings, worst first: {report.findings_words}"),
        table(headings, [row(f) for f in report.findings], numbers=(5,)),
        e("p", f"{meanings}.", css="quiet"),
    ]


def row(finding: Finding) -> list[Content]:
    """Return what the table says of a finding."""
    cell, kind = e("span", where(finding), css="cell"), e("span", finding.kind, css="kind")
    found, expected = (e("span", text, css="value") for text in (told(finding), exact(finding.expected)))
    return [cell, kind, finding.what, found, expected, deviation(finding.deviation), finding.witness]


def told(finding: Finding) -> str:
    """Return what was found, and why it could not be evaluated."""
    return f"{exact(finding.computed)} ({finding.why})" if finding.why else exact(finding.computed)


def where(finding: Finding) -> str:
    """Return the cell of a finding, or what else it is about."""
    return f"{finding.sheet}!{finding.cell}" if finding.sheet else finding.cell


def remarks(report: Report) -> list[Element]:
    """Return the notes, and the formula cells of the engineer's own."""
    lines = [*report.notes, *([report.following_words] if report.following else [])]
    said = [e("h3", "Notes"), *(e("p", line) for line in lines)] if lines else []
    if report.own:
        said += [
            e("h3", f"Cells of your own ({len(report.own):,})"),
            e("p", f"{report.own_words}: the engine has no value for them."),
            e("p", ", ".join(report.own), css="cell"),
        ]
    return said


def verdict(outcome: Outcome) -> Element:
    """Return the verdict in words; its colour only repeats them."""
    return e("span", VERDICTS[outcome.verdict], css=f"verdict {outcome.verdict.replace(' ', '-')}")


def exact(value: Any) -> str:
    """Return a value with all digits that a spreadsheet keeps."""
    return f"{value:.15g}" if isinstance(value, float) else "empty" if value is None else str(value)


def deviation(value: float | None) -> str:
    """Return a relative deviation; a dash where there is none to give."""
    return "–" if value is None or not math.isfinite(value) else f"{value:.1e}" if value else "0"


def table(headings: Sequence[Content], rows: Iterable[Sequence[Content]], numbers: Sequence[int]) -> Element:
    """Return a table whose columns ``numbers`` stand to the right."""
    css = ["number" if i in numbers else "" for i in range(len(headings))]
    head = e("tr", *(e("th", text, css=c, scope="col") for text, c in zip(headings, css, strict=True)))
    body = [e("tr", *(e("td", text, css=c) for text, c in zip(row, css, strict=True))) for row in rows]
    return e("table", e("thead", head), e("tbody", *body))


def e(tag: str, *children: Content, css: str = "", **attributes: str) -> Element:
    """Return an element; texts are escaped when it is written, and made fit for XML here."""
    element = Element(tag, {**({"class": css} if css else {}), **{k: legal(v) for k, v in attributes.items()}})
    for child in children:
        if isinstance(child, Element):
            element.append(child)
        elif len(element):
            element[-1].tail = (element[-1].tail or "") + legal(child)
        else:
            element.text = (element.text or "") + legal(child)
    return element


def markup(*elements: Element) -> str:
    """Return elements as HTML."""
    return "".join(tostring(one, encoding="unicode", method="html") for one in elements)


def legal(text: str) -> str:
    """Return a text with a visible escape for each character that neither XML nor a file in UTF-8 can hold."""
    return visible(text, kept="\t\n")


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
