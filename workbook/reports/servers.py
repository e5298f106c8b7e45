"""The report of a run as CI servers and code hosts read it: JUnit XML, and SARIF 2.1.0 beside the changed files.

Source: OASIS, Static Analysis Results Interchange Format (SARIF) Version 2.1.0, 2020.
"""

import json
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from typing import Any
from xml.etree.ElementTree import Element, indent, tostring

import workbook
from workbook.judging.many import Outcome
from workbook.judging.report import Finding, Report
from workbook.reports.html import e
from workbook.reports.page import KINDS, by_sheet, figure, own_verdict, told, where, witness

DESIGN = "the machine's own checks"
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
OTHERS = {"design": "a check of the machine's own fails", "unreadable": "the file cannot be read"}


def junit(outcomes: Sequence[Outcome], when: datetime) -> str:
    """Return the run as JUnit XML: a suite for each workbook, a case for each sheet; findings are failures."""
    suites = [suite(outcome, when) for outcome in outcomes]
    root = e("testsuites", *suites, name="motionbook verify", **counts(suites, "testcase", "failure", "error"))
    root.set("time", f"{sum(o.seconds for o in outcomes):.3f}")
    indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'


def suite(outcome: Outcome, when: datetime) -> Element:
    """Return the suite of one workbook."""
    name = str(outcome.path)
    if outcome.report:
        cases = [case(name, sheet, found) for sheet, found in by_sheet(outcome.report).items()]
        lines = "\n".join(check.line for check in outcome.report.failing)
        failed = e("failure", lines, message=own_verdict(outcome.report), type="design")
        cases.append(testcase(name, DESIGN, *([] if outcome.report.holds else [failed])))
        known = [properties(outcome.sha256, outcome.report)]
    else:
        first = outcome.reason.partition("\n")[0]
        why = e("error", outcome.reason, message=first, type=outcome.verdict)
        if outcome.verdict == "no machine":  # it was rightly passed over
            why = e("skipped", message=first)
        cases, known = [testcase(name, "open", why)], []
    made = e("testsuite", *known, *cases, name=name, timestamp=f"{when.astimezone(UTC):%Y-%m-%dT%H:%M:%S}",
             time=f"{outcome.seconds:.3f}", hostname="localhost")  # fmt: skip
    for key, value in counts([made], "testcase", "failure", "error", "skipped").items():
        made.set(key, value)
    return made


def case(book: str, sheet: str, found: Sequence[Finding]) -> Element:
    """Return the case of one sheet, failed by its findings."""
    if not found:
        return testcase(book, sheet)
    more = f" (and {len(found) - 1} more)" if len(found) > 1 else ""
    lines = "\n".join(line(finding) for finding in found)
    return testcase(book, sheet, e("failure", lines, message=line(found[0]) + more, type=found[0].kind))


def testcase(book: str, name: str, *result: Element) -> Element:
    """Return a case; the classname lets a server list the sheets below their workbook."""
    return e("testcase", *result, classname=book, name=name, time="0")


def line(finding: Finding) -> str:
    """Return a finding in one line."""
    what = f" ({finding.what})" if finding.what else ""
    by = f" [{finding.witness}]" if finding.witness else ""
    found, expected = told(finding), figure(finding.expected, 15)
    return f"{where(finding)}{what}: {finding.kind}: found {found}, expected {expected}{by}"


def properties(sha256: str, report: Report) -> Element:
    """Return what was verified, and by what."""
    known = {"sha256": sha256, "template": report.template, "declared": str(report.declared)}
    known |= {"compared": str(report.compared), "checks": own_verdict(report)}
    known |= {"following": report.following_words} if report.following else {}
    known |= {"own cells": report.own_words} if report.own else {}
    known |= {f"witness {ran.name}": witness(ran) for ran in report.witnesses}
    return e("properties", *(e("property", name=name, value=value) for name, value in known.items()))


def counts(suites: Sequence[Element], *tags: str) -> dict[str, str]:
    """Return how many of the ``tags`` the suites hold, by the attributes in which JUnit gives them."""
    named = {"testcase": "tests", "failure": "failures", "error": "errors", "skipped": "skipped"}
    return {named[tag]: str(sum(sum(1 for _ in s.iter(tag)) for s in suites)) for tag in tags}


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
        yield result(outcome, finding.kind, "error", line(finding), f"{finding.sheet}!{finding.cell}")
    for check in outcome.report.failing:
        yield result(outcome, "design", "warning", check.line, f"{check.sheet}!{check.cell}")


def result(outcome: Outcome, rule: str, level: str, text: str, cell: str = "") -> dict[str, Any]:
    """Return a result; the cell is its logical location, as a workbook has no lines."""
    where: dict[str, Any] = {"physicalLocation": {"artifactLocation": {"uri": outcome.path.as_posix()}}}
    if cell:
        where["logicalLocations"] = [{"fullyQualifiedName": cell}]
    return {"ruleId": rule, "level": level, "message": {"text": text}, "locations": [where]}
