"""The report of a run as JUnit XML, as CI servers read it: a suite for each workbook, a case for each sheet."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from xml.etree.ElementTree import Element, indent, tostring

from workbook.judging.one import Outcome
from workbook.judging.report import Finding, Report
from workbook.reports.html import e
from workbook.reports.page import by_sheet, exact, own_verdict, told, where, witness

DESIGN = "the machine's own checks"


def junit(outcomes: Sequence[Outcome], when: datetime) -> str:
    """Return the run as JUnit XML: findings are failures, a file that cannot be read is an error."""
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
        cases.append(design(name, outcome.report))
        known = [properties(outcome.sha256, outcome.report)]
    else:
        cases = [testcase(name, "open", unopened(outcome))]
        known = []
    made = e("testsuite", *known, *cases, name=name, timestamp=f"{when.astimezone(UTC):%Y-%m-%dT%H:%M:%S}",
             time=f"{outcome.seconds:.3f}", hostname="localhost")  # fmt: skip
    for key, value in counts([made], "testcase", "failure", "error", "skipped").items():
        made.set(key, value)
    return made


def unopened(outcome: Outcome) -> Element:
    """Return why there is no report: an error, unless the workbook was rightly skipped."""
    first = outcome.reason.partition("\n")[0]
    if outcome.verdict == "no machine":
        return e("skipped", message=first)
    return e("error", outcome.reason, message=first, type=outcome.verdict)


def case(book: str, sheet: str, found: Sequence[Finding]) -> Element:
    """Return the case of one sheet, failed by its findings."""
    if not found:
        return testcase(book, sheet)
    more = f" (and {len(found) - 1} more)" if len(found) > 1 else ""
    lines = "\n".join(line(finding) for finding in found)
    return testcase(book, sheet, e("failure", lines, message=line(found[0]) + more, type=found[0].kind))


def design(book: str, report: Report) -> Element:
    """Return the case of the machine itself: failed where its own checks are."""
    if report.holds:
        return testcase(book, DESIGN)
    lines = "\n".join(check.line for check in report.failing)
    return testcase(book, DESIGN, e("failure", lines, message=own_verdict(report), type="design"))


def testcase(book: str, name: str, *result: Element) -> Element:
    """Return a case; the classname lets a server list the sheets below their workbook."""
    return e("testcase", *result, classname=book, name=name, time="0")


def line(finding: Finding) -> str:
    """Return a finding in one line."""
    what = f" ({finding.what})" if finding.what else ""
    by = f" [{finding.witness}]" if finding.witness else ""
    found, expected = told(finding), exact(finding.expected)
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
