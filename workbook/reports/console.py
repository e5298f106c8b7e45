"""What the commands print: tables for people, JSON for machines."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

from rich.console import Console
from rich.table import Table

from workbook.judging.report import FOLLOWS, Finding, Ran, Report
from workbook.reports.differing import differing
from workbook.reports.page import own_verdict, where
from workbook.reports.terminal import say, shown

MOST = 40  # findings that the terminal shows; --json has them all


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it."""
    if value is None or isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value)):
        return value
    return str(value)


def report_data(report: Report) -> dict[str, Any]:
    """Return a report as JSON's objects and lists."""
    return {
        "file": str(report.path),
        "template": report.template,
        "agrees": report.agrees,
        "declared": report.declared,
        "compared": report.compared,
        "checks": checks_data(report),
        "witnesses": [witness_data(w) for w in report.witnesses],
        "deviations": report.deviations,
        "findings": [finding_data(f) for f in report.findings],
        "notices": [finding_data(f) for f in report.notices],
        "following": len({(f.sheet, f.cell) for f in report.following}),
        "own_cells": {"formulas": len(report.own), "not_evaluated": report.not_evaluated, "cells": report.own},
        "notes": report.notes,
    }


def checks_data(report: Report) -> dict[str, Any]:
    """Return the machine's own verdict as JSON's object."""
    failing = [
        {"sheet": c.sheet, "cell": c.cell, "what": c.what, "found": c.found, "says": c.says} for c in report.failing
    ]
    return {"holds": report.holds, "all": len(report.checks), "failing": failing, "unfinished": report.unfinished}


def witness_data(w: Ran) -> dict[str, Any]:
    """Return what came of a witness as JSON's object."""
    counts = {"compared": w.compared, "at_fault": w.at_fault, "unfinished": w.unfinished}
    return {"name": w.name, "version": w.version, "absent": w.absent, **counts, "why": w.why}


def finding_data(f: Finding) -> dict[str, Any]:
    """Return a finding as JSON's object."""
    values = {"computed": plain(f.computed), "expected": plain(f.expected)}
    return {
        "sheet": f.sheet,
        "cell": f.cell,
        "kind": f.kind,
        **values,
        "what": f.what,
        "witness": f.witness,
        "why": f.why,
    }


def show_report(report: Report, console: Console, everything: bool = False) -> None:
    """Print a report: what was compared on each sheet, then the findings, causes first; ``everything`` without end."""
    sheets = Table("Sheet", "Formula cells", "Largest deviation", "Findings", title_justify="left")
    sheets.title = shown(str(report.path))
    for sheet, compared in report.cells.items():
        deviation = report.deviations.get(sheet, 0.0)
        faults = sum(f.sheet == sheet for f in report.findings)
        sheets.add_row(shown(sheet), f"{compared:,}", f"{deviation:.1e}", str(faults) if faults else "-")
    console.print(sheets)
    if report.findings:
        show_findings(report, console, everything)
    if report.notices:
        show_notices(report, console)
    lines = [f"Note: {note}" for note in report.notes]
    if report.following:
        lines.append(report.following_words)
    if report.own:
        first = ", ".join(report.own[:8]) + (" …" if len(report.own) > 8 else "")
        lines.append(f"{report.own_words} ({first})")
    lines += verdict(report)
    for line in lines:
        console.print(shown(line))


def verdict(report: Report) -> list[str]:
    """Return in lines what came of the cells, of the witnesses that were not asked, and of the machine's own checks."""
    said = "every one computes what the engine computes" if report.agrees else report.findings_words
    lines = [f"Not on this machine: {w.name}" for w in report.witnesses if w.absent]
    lines += [f"Not compared by {w.name}: {w.why}" for w in report.witnesses if w.why and not report.tells(w)]
    lines.append(f"{report.compared:,} of {report.declared:,} formula cells compared by {report.witness}: {said}.")
    for c in report.failing[:MOST]:
        lines.append(f"{c.found}  {c.sheet}!{c.cell}  {c.what}" + (f": {c.says}" if c.says else ""))
    if len(report.failing) > MOST:
        lines.append(f"… and {len(report.failing) - MOST} more")
    return [*lines, f"The machine's own checks: {own_verdict(report)}."]


def show_notices(report: Report, console: Console) -> None:
    """Print as a table what is reworded or gone, and misleads nobody."""
    table = Table("Cell", "What", "Found", "Expected", title="Notices: reworded or gone, but misleading nobody",
                  title_justify="left")  # fmt: skip
    for f in report.notices[:MOST]:
        table.add_row(*(shown(text) for text in (where(f), f.what, figure(f.computed), figure(f.expected))))
    console.print(table)
    if len(report.notices) > MOST:
        console.print(f"… and {len(report.notices) - MOST} more; --json lists them all")


def show_findings(report: Report, console: Console, everything: bool) -> None:
    """Print the findings as a table, with a column for the witness where there are several.

    What only follows from others is counted by sheet, unless ``everything`` is asked for, or nothing else is found.
    """
    listed = report.findings if everything else report.causes
    headings = ["Cell", "What", "Kind", "Computes", "Expected"]
    table = Table(*headings, title="Findings, causes first", title_justify="left")
    if len(report.witnesses) > 1:
        table.add_column("By")
    told = listed if everything else listed[:MOST]
    for f in told:
        found, expected = map(figure, differing(f.computed, f.expected))
        row = (where(f), f.what, f.kind, f"{found} ({f.why})" if f.why else found, expected, f.witness)
        table.add_row(*(shown(text) for text in row[: len(table.columns)]))
    console.print(table)
    if len(listed) > len(told):
        say(console, f"… and {len(listed) - len(told)} more; --all lists them")
    if len(listed) < len(report.findings):
        sheets = Counter(f.sheet for f in report.findings if f.kind == FOLLOWS)
        counted = ", ".join(f"{count:,} on {sheet}" for sheet, count in sheets.items())
        say(console, f"Cells that are wrong only because of these: {counted}; --all lists them")


def figure(value: Any) -> str:
    """Return a value for a table."""
    return f"{value:.10g}" if isinstance(value, float) else "empty" if value is None else str(value)
