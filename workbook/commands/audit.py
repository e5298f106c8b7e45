"""Audit workbooks without declarations: print what the rules find, as a table, JSON or SARIF."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from workbook.audit.finding import SURE, Finding
from workbook.audit.register import KINDS, Audit
from workbook.audit.register import audit as audited
from workbook.errors import AGREES, DISAGREES, UNREADABLE, ReadError
from workbook.judging.batch import find_workbooks
from workbook.reading.files import open_book
from workbook.reports import page
from workbook.reports.page import result, sarif_log
from workbook.reports.terminal import ERR, OUT, say, say_json, show_table, shown

LEVELS = {"high": "error", "medium": "warning", "low": "note"}  # of SARIF
MOST = 60  # findings of a workbook that the terminal shows


def audit(paths: Sequence[Path], as_json: bool, sarif: Path | None, force: bool, everything: bool) -> int:
    """Audit workbooks, print what was found, the unsure only if ``everything`` is asked for; return the exit code."""
    page.require_writable(sarif, (".sarif", ".json"), force)
    results: list[dict[str, Any]] = []
    files: list[dict[str, Any]] = []
    code, least = AGREES, SURE[-1] if everything else SURE[-2]
    targets, failed = find_workbooks(paths)
    unreadable = [(outcome.path, outcome.reason) for outcome in failed]
    for path, _ in targets:
        try:
            with ERR.status(shown(f"Auditing {path} …")):
                report = audited(open_book(path))
        except ReadError as error:
            unreadable.append((path, str(error)))
            continue
        findings = report.shown(least)
        code = max(code, DISAGREES if findings else AGREES)
        results += [result(path, f.rule, LEVELS[f.sure], line(f), str(f.cell)) for f in findings]
        files.append(data(path, report, findings))
        if not as_json:
            show(path, report, findings)
    for path, reason in unreadable:
        say(ERR, reason, "red")
        results.append(result(path, "unreadable", "error", reason))
        files.append({"file": str(path), "reason": reason, "formulas": 0, "findings": []})
        code = UNREADABLE
    if as_json:
        say_json({"files": files})
    page.write(sarif, lambda: sarif_log(KINDS | {"unreadable": page.OTHERS["unreadable"]}, results), force)
    return code


def line(finding: Finding) -> str:
    """Return a finding in a line."""
    neighbours = f"; {finding.neighbours}" if finding.neighbours else ""
    return f"{finding.cell}: {finding.why} (sure: {finding.sure}{neighbours})"


def data(path: Path, report: Audit, findings: Sequence[Finding]) -> dict[str, Any]:
    """Return a report as JSON's objects and lists."""
    each = [vars(f) | {"cell": str(f.cell)} for f in findings]
    return {"file": str(path), "formulas": report.formulas, "findings": each, "notes": report.notes}


def show(path: Path, report: Audit, findings: Sequence[Finding]) -> None:
    """Print the findings of a workbook as a table, and how many there are of each rule."""
    rows = [(str(f.cell), f.rule, f.sure, f.why, f.neighbours) for f in findings[:MOST]]
    if rows:
        show_table(OUT, ("Cell", "Rule", "Sure", "Why", "Beside it"), rows, title=shown(str(path)))
    if len(findings) > MOST:
        say(OUT, f"… and {len(findings) - MOST:,} more; --json lists them all")
    for note in report.notes:
        say(OUT, f"Note: {note}")
    unsure = len(report.findings) - len(findings)
    counts = ", ".join(f"{rule} {count}" for rule, count in Counter(f.rule for f in findings).items())
    more = f"; --all lists {unsure:,} that are less sure" if unsure else ""
    say(OUT, f"{path}: {report.formulas:,} formula cells, {counts or 'nothing found'}{more}")
