"""The output of commands on reports, one or many, and of the laws: tables for people, JSON for machines."""

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeRemainingColumn
from rich.table import Column, Table

from engine.laws import CATALOGUE
from engine.laws.inverse import DERIVATIVES, continuity, law_joints
from workbook.errors import visible
from workbook.judging.batch import Outcome
from workbook.judging.report import FOLLOWS, Finding, Report
from workbook.reports.page import VERDICTS, figure, line, own_verdict, where
from workbook.reports.terminal import say, say_json, show_table, shown

WORST = 3  # findings of each of several workbooks that the terminal shows
MOST = 40  # findings that the terminal shows; --json has them all
FINDING = ("sheet", "cell", "kind", "computed", "expected", "what", "witness", "why")
WITNESS = ("name", "version", "absent", "compared", "at_fault", "unfinished", "why")
LONG = 50  # characters: a shorter formula is shown whole
AROUND = 12  # characters before and after the difference
WORD = re.compile(r"[\w.$!']")
FIGURES = {"C_v": "cv", "C_a+": "ca_max", "C_a−": "ca_min", "C_a,rms": "ca_rms", "C_j": "cj"}
FIGURES |= {"max(v·a)": "va_max"}
COSTS = {"min(v·a)": "va_min", "C_a,rms²/12": "loss"}
SMOOTH = ("smooth_at_ends", "smooth_inside")
VENDORS = {"siemens": "Siemens LCamHdl", "twincat": "TwinCAT", "codesys": "CODESYS", "sew": "SEW"}
EXPLAINED = (
    "C_a,rms²/12: heat of a pure inertia against the cubic's, the least between two rests; smooth: what is continuous."
)


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it."""
    if value is None or isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value)):
        return value
    return str(value)


def findings_data(report: Report, findings: Sequence[Finding]) -> list[dict[str, Any]]:
    """Return findings of a report as JSON's objects, each with the formula that should stand in its cell."""
    fields = ({field: plain(getattr(finding, field)) for field in FINDING} for finding in findings)
    return [data | {"formula": report.formulas.get((data["sheet"], data["cell"]), "")} for data in fields]


def report_data(report: Report) -> dict[str, Any]:
    """Return a report as JSON's objects and lists."""
    return {
        "file": str(report.path),
        **{name: getattr(report, name) for name in ("template", "agrees", "declared", "compared")},
        "checks": {
            "holds": report.holds,
            "all": len(report.checks),
            "failing": [asdict(c) for c in report.failing],
            "unfinished": report.unfinished,
        },
        "witnesses": [{name: getattr(ran, name) for name in WITNESS} for ran in report.witnesses],
        "deviations": report.deviations,
        **{name: findings_data(report, getattr(report, name)) for name in ("findings", "notices")},
        "own_cells": {"formulas": len(report.own), "not_evaluated": report.not_evaluated, "cells": report.own},
        "notes": report.notes,
    }


def show_report(report: Report, console: Console, everything: bool = False) -> None:
    """Print a report: what was compared on each sheet, then the findings, causes first; ``everything`` without end."""
    faults = Counter(f.sheet for f in report.findings)
    off = report.deviations
    rows = list[Sequence[str]]()
    for sheet, compared in report.cells.items():
        rows.append((sheet, f"{compared:,}", f"{off.get(sheet, 0.0):.1e}", str(faults[sheet] or "-")))
    headings = ("Sheet", "Formula cells", "Largest deviation", "Findings")
    show_table(console, headings, rows, title=shown(str(report.path)))
    if report.findings:
        show_findings(report, console, everything)
    if report.notices:
        rows = [(where(f), f.what, figure(f.computed), figure(f.expected)) for f in report.notices[:MOST]]
        title = "Notices: reworded or gone, but misleading nobody"
        show_table(console, ("Cell", "What", "Found", "Expected"), rows, title=title)
        if len(report.notices) > MOST:
            console.print(f"… and {len(report.notices) - MOST} more; --json lists them all")
    lines = [f"Note: {note}" for note in report.notes]
    if report.own:
        first = ", ".join(report.own[:8]) + (" …" if len(report.own) > 8 else "")
        lines.append(f"{report.own_words} ({first})")
    for text in (*lines, *verdict(report)):
        console.print(shown(text))


def verdict(report: Report) -> list[str]:
    """Return in lines what came of the cells, of the witnesses that were not asked, and of the machine's own checks."""
    text = "every one computes what the engine computes" if report.agrees else report.findings_words
    lines = [f"Not on this machine: {w.name}" for w in report.witnesses if w.absent]
    lines += [f"Not compared by {w.name}: {w.why}" for w in report.witnesses if w.why and not report.tells(w)]
    lines.append(f"{report.compared:,} of {report.declared:,} formula cells compared by {report.witness}: {text}.")
    for c in report.failing[:MOST]:
        lines.append(f"{c.found}  {c.sheet}!{c.cell}  {c.what}" + (f": {c.says}" if c.says else ""))
    if len(report.failing) > MOST:
        lines.append(f"… and {len(report.failing) - MOST} more")
    return [*lines, f"The machine's own checks: {own_verdict(report)}."]


def show_findings(report: Report, console: Console, everything: bool) -> None:
    """Print the findings; what only follows from others is counted by sheet, unless ``everything`` is asked for."""
    listed = report.findings if everything else report.causes
    headings = "Cell What Kind Computes Expected By".split()[: 6 if len(report.witnesses) > 1 else 5]
    first, rows = listed if everything else listed[:MOST], []
    for f in first:
        computed, expected = map(figure, differing_middles(f.computed, f.expected))
        value = f"{computed} ({f.why})" if f.why else computed
        row = (where(f), f.what, f.kind, value, expected, f.witness)
        rows.append(row[: len(headings)])
    show_table(console, headings, rows, title="Findings, causes first")
    if len(listed) > len(first):
        say(console, f"… and {len(listed) - len(first)} more; --all lists them")
    if len(listed) < len(report.findings):
        sheets = Counter(f.sheet for f in report.findings if f.kind == FOLLOWS)
        counted = ", ".join(f"{count:,} on {sheet}" for sheet, count in sheets.items())
        say(console, f"Cells that are wrong only because of these: {counted}; --all lists them")


def differing_middles(held: Any, expected: Any) -> tuple[Any, Any]:
    """Return two long formulas without what both begin and end with, ``…`` in its place; others as they are."""
    both = held, expected
    if not all(isinstance(text, str) and text.startswith("=") for text in both) or max(map(len, both)) <= LONG:
        return both
    same = alike(held, expected)
    end = min(alike(held[::-1], expected[::-1]), min(map(len, both)) - same)
    begin = max(0, same - AROUND)
    while begin and WORD.match(held[begin - 1]) and WORD.match(held[begin]):  # not within a name
        begin -= 1
    before, after = "…" if begin else "", "…" if end > AROUND else ""
    return (
        f"{before}{held[begin : len(held) - end + AROUND]}{after}",
        f"{before}{expected[begin : len(expected) - end + AROUND]}{after}",
    )


def alike(text: str, other: str) -> int:
    """Return with how many of the same characters two texts begin."""
    return next((k for k, (a, b) in enumerate(zip(text, other, strict=False)) if a != b), min(len(text), len(other)))


@contextmanager
def progress(console: Console, words: str, total: int) -> Iterator[Callable[[int, str], None]]:
    """Show a bar, on a terminal only; give a function that takes how many more are done, and the words beside it."""
    told = TextColumn(words), BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}")
    columns = (SpinnerColumn(), *told, TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("", total=total)
        yield lambda count, text: bar.update(task, advance=count, description=escape(visible(text)))


def show(
    outcomes: Sequence[Outcome], out: Console, err: Console, as_json: bool, alone: bool, everything: bool = False
) -> None:
    """Print a run: in full where a file was named ``alone``, else the summary of all."""
    if not alone and as_json:
        compared = sum(o.report.compared for o in outcomes if o.report)
        files = []
        for o in outcomes:  # its report, or the reason why there is none
            none: dict[str, Any] = {"compared": 0, "findings": [], "reason": o.reason}
            known = report_data(o.report) | {"sha256": o.sha256} if o.report else none
            files.append({"file": str(o.path), "verdict": o.verdict} | known)
        say_json({"files": files, "compared": compared})
        return
    if not alone:
        show_summary(outcomes, out)
        return
    for text in outcomes[0].reason.splitlines():
        say(err, text, "red")
    if outcomes[0].report and as_json:
        say_json(report_data(outcomes[0].report))
    elif outcomes[0].report:
        show_report(outcomes[0].report, out, everything)


def show_summary(outcomes: Sequence[Outcome], console: Console) -> None:
    """Print a table of all workbooks, the worst of the findings in each, and the sums."""
    table = Table("Workbook", *(Column(name, justify="right") for name in ("Formula cells", "Findings")))
    table.add_column("Verdict", no_wrap=True)
    for o in outcomes:
        shown_verdict = VERDICTS[o.verdict]
        counts = (f"{o.report.compared:,}", f"{len(o.report.causes):,}") if o.report else ("-", "-")
        table.add_row(shown(str(o.path)), *counts, shown(shown_verdict.row, shown_verdict.colour))
    console.print(table)
    for o in outcomes:
        show_worst(o, console)
    compared = sum(o.report.compared for o in outcomes if o.report)
    count = Counter[str](outcome.verdict for outcome in outcomes)
    texts = [f"{count[verdict]} {words.several}" for verdict, words in VERDICTS.items() if count[verdict]]
    verified = sum(outcome.report is not None for outcome in outcomes)
    say(console, f"{compared:,} formula cells compared in {verified} workbooks: {', '.join(texts)}.")


def show_worst(outcome: Outcome, console: Console) -> None:
    """Print why a workbook cannot be read, or the worst of its findings."""
    for text in outcome.reason.splitlines() if outcome.verdict == "unreadable" else ():
        say(console, text)
    report = outcome.report
    lines = [*map(line, report.causes), *(check.line for check in report.failing)] if report else []
    for text in lines[:WORST]:
        say(console, f"{outcome.path}: {text}")
    if len(lines) > WORST:
        say(console, f"{outcome.path}: and {len(lines) - WORST:,} more; verify it alone, or add --report")


def catalogue() -> list[dict[str, Any]]:
    """Return every law's names, source, coefficients, for its parameters as delivered, continuity, names elsewhere."""
    rows: list[dict[str, Any]] = []
    for law in (family() for family in CATALOGUE):
        figures = {name: plain(getattr(law.coefficients, field)) for name, field in (FIGURES | COSTS).items()}
        orders = continuity(law_joints(law, law.as_pieces()))
        smooth = dict(zip(SMOOTH, (DERIVATIVES[order] for order in orders), strict=True))
        facts = {"code": law.code, "name": law.name, "aliases": list(law.aliases)}
        facts |= {"source": law.source} | figures | smooth
        rows.append(facts | {"names": law.vendors._asdict()})
    return rows


def show_catalogue(console: Console) -> None:
    """Print the catalogue of laws: figures, what each costs, then the names that they have elsewhere."""
    rows = catalogue()
    show_laws(console, rows, FIGURES, ())
    console.print("Unit rise and time, parameters as delivered. --json adds aliases and sources.")
    show_laws(console, rows, COSTS, SMOOTH)
    console.print(EXPLAINED)
    named = ([row["code"], *(row["names"][vendor] for vendor in VENDORS)] for row in rows if any(row["names"].values()))
    show_table(console, ("Code", *VENDORS.values()), named, title="Names elsewhere, as far as they are sure")


def show_laws(console: Console, rows: Sequence[dict[str, Any]], numbers: Iterable[str], words: Iterable[str]) -> None:
    """Print a table of the laws with some of their figures, and what is stated of them in words."""
    table = Table()
    for heading in ("Code", "Law", *numbers, *(word.replace("_", " ") for word in words)):
        table.add_column(heading, no_wrap=heading != "Law", justify="right" if heading in numbers else "left")
    for row in rows:
        figures = ("∞" if row[f] == "inf" else f"{row[f]:.5g}" for f in numbers)
        table.add_row(row["code"], row["name"], *figures, *(row[word] for word in words))
    console.print(table)
