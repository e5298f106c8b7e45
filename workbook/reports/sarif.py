"""The report of a run as SARIF 2.1.0, as code hosts and CI servers show it beside the changed files.

Source: OASIS, Static Analysis Results Interchange Format (SARIF) Version 2.1.0, 2020.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

import workbook
from workbook.judging.one import Outcome
from workbook.judging.report import Check, Finding
from workbook.reports.junit import line
from workbook.reports.page import KINDS

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
OTHERS = {"design": "a check of the machine's own fails", "unreadable": "the file cannot be read"}


def sarif(outcomes: Sequence[Outcome]) -> str:
    """Return the run: each finding is an error, each failing check of a machine a warning."""
    rules = [{"id": kind, "shortDescription": {"text": words}} for kind, words in (KINDS | OTHERS).items()]
    driver = {"name": "motionbook", "version": workbook.__version__, "rules": rules}
    results = [result for outcome in outcomes for result in of_one(outcome)]
    run = {"tool": {"driver": driver}, "columnKind": "unicodeCodePoints", "results": results}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, ensure_ascii=False, indent=1) + "\n"


def of_one(outcome: Outcome) -> Iterator[dict[str, Any]]:
    """Yield the results of one workbook."""
    if outcome.report is None:
        if outcome.verdict == "unreadable":
            yield result(outcome, "unreadable", "error", outcome.reason)
        return
    for finding in outcome.report.findings:
        yield result(outcome, finding.kind, "error", line(finding), cell(finding))
    for check in outcome.report.failing:
        yield result(outcome, "design", "warning", check.line, cell(check))


def cell(one: Finding | Check) -> str:
    """Return the cell of a finding or a check with its sheet."""
    return f"{one.sheet}!{one.cell}"


def result(outcome: Outcome, rule: str, level: str, text: str, cell: str = "") -> dict[str, Any]:
    """Return a result; the cell is its logical location, as a workbook has no lines."""
    where: dict[str, Any] = {"physicalLocation": {"artifactLocation": {"uri": outcome.path.as_posix()}}}
    if cell:
        where["logicalLocations"] = [{"fullyQualifiedName": cell}]
    return {"ruleId": rule, "level": level, "message": {"text": text}, "locations": [where]}
