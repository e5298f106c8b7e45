"""The reports of a run: complete, escaped, whole in one file, and never written over another."""

import math
import subprocess
import sys
from datetime import UTC, datetime
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest

from workbook.errors import WriteError
from workbook.judging.batch import Outcome
from workbook.judging.report import ORDER, Check, Finding, Report, WitnessRun
from workbook.reports.html import xml_safe
from workbook.reports.page import DESIGN, KINDS, junit, page, require_writable

WHEN = datetime(2026, 3, 1, 13, 5, 9, tzinfo=UTC)
EVIL = "<script>alert('&\"')</script>\x07\ud800"
SAFE = "<script>alert('&\"')</script>\\x07\\ud800"


def wrong():
    """A report with all that a report can hold, and texts that must be escaped."""
    report = Report(Path("in/<b>&.xlsx"), "machine", compared=1234)
    report.cells = {"Drive": 1000, "Laws": 234}
    report.deviations = {"Drive": 0.25, "Laws": 3.1e-16}
    report.witnesses = [
        WitnessRun("pycel", "1.0b30", 1234),
        WitnessRun("libreoffice", None),
        WitnessRun("saved", "values", why="has none"),
    ]
    report.findings = [
        Finding("Drive", "D7", "replaced", 5.0, 1 / 3, f"Peak {EVIL}"),
        Finding("Drive", "D9", "value", 1.0, 1.25, "RMS", 0.25, "formulon"),
        Finding(EVIL, "A1", "error", "#DIV/0!", None, "", math.inf),
        Finding("", "libreoffice", "witness", "absent", "a witness that is on this machine"),
    ]
    report.declared = 1236
    report.witnesses[0].at_fault = 2
    report.checks = [Check("Drive", "D20", f"Peak torque {EVIL}", "FAIL"), Check("Drive", "D21", "RMS torque", "OK")]
    report.notices = [Finding("Drive", "B7", "notice", "Spitze", "Peak", f"label of {EVIL}")]
    report.own = ["Mine!A1", "Mine!B2"]
    report.notes = [f"inputs that hold a formula: {EVIL}"]
    return Outcome(report.path, "disagrees", report, sha256="ab" * 32, seconds=1.5)


def right():
    report = Report(Path("fine.xlsx"), "machine", compared=10, cells={"Laws": 10}, deviations={"Laws": 0.0})
    report.witnesses = [WitnessRun("pycel", "1.0b30", 10)]
    return Outcome(report.path, "agrees", report, sha256="cd" * 32)


def unreadable():
    return Outcome(Path("bad.xlsx"), "unreadable", reason="bad.xlsx: Timing!D7: found 'x'\nbad.xlsx: Timing!D8: empty")


def foreign():
    return Outcome(Path("other.xlsx"), "no machine", reason="other.xlsx: holds no machine of motionbook")


class Read(HTMLParser):
    """A page as a browser reads it: its tags with their attributes, and its text."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.said, self.open = [], "", []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in ("meta", "br", "hr", "img", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.said += data + "|"


def test_the_page_says_all_of_the_report():
    said = Read(page([wrong()], WHEN)).said
    for expected in (
        "<b>&.xlsx", "ab" * 32, "2026-03-01 13:05:09 +0000", "machine",
        "pycel 1.0b30: 1,234 cells compared, 2 at fault",
        "declared|1,236", "1 of 2 FAIL", "Drive!D20|Peak torque", "Notices (1)", "Drive!B7|label of", "|Spitze|Peak|",
        "libreoffice: absent from this machine, not asked", "saved values: has none", "Drive|1,000|2.5e-01|2|",
        "Laws|234|3.1e-16|0|", "Drive!D7|replaced|", "|5|0.333333333333333|–|",
        "Drive!D9|value|RMS|1|1.25|2.5e-01|formulon|",
        "#DIV/0!|empty|", "Mine!A1, Mine!B2", SAFE, "Disagrees",
    ):  # fmt: skip
        assert expected in said


def test_the_page_is_well_formed_escaped_and_fetches_nothing():
    text = page([wrong(), right(), unreadable(), foreign()], WHEN)
    read = Read(text)
    assert read.open == []
    assert text.startswith("<!DOCTYPE html>")
    assert {tag for tag, _ in read.tags} <= {
        "html", "head", "meta", "title", "style", "body", "main", "h1", "h2", "h3", "p", "a", "span", "code",
        "table", "thead", "tbody", "tr", "th", "td",
    }  # fmt: skip
    assert {name for _, given in read.tags for name in given} <= {
        "lang", "charset", "name", "content", "class", "id", "href", "scope", "data-at",
    }  # fmt: skip
    assert all(given["href"].startswith("#book") for _, given in read.tags if "href" in given)
    assert "url(" not in text
    assert "@import" not in text
    text.encode()  # no halves of characters


def test_a_page_of_several_links_from_the_summary_to_each_section():
    outcomes = [wrong(), right(), unreadable(), foreign()]
    read = Read(page(outcomes, WHEN))
    links = [given["href"][1:] for tag, given in read.tags if tag == "a"]
    assert links == [given["id"] for _, given in read.tags if "id" in given]
    assert len(links) == len(outcomes)
    assert "bad.xlsx: Timing!D8: empty" in read.said
    assert "Skipped" in read.said


def test_the_page_explains_every_kind_of_finding():
    assert set(KINDS) == set(ORDER)


def test_junit_has_a_suite_a_workbook_and_a_case_a_sheet():
    root = ElementTree.fromstring(junit([wrong(), right(), unreadable(), foreign()], WHEN).encode())
    first, second, third, fourth = root
    assert [c.get("name") for c in first.findall("testcase")] == ["Drive", "Laws", SAFE, "(no sheet)", DESIGN]
    assert [len(c.findall("failure")) for c in first.findall("testcase")] == [1, 0, 1, 1, 1]
    assert first.find(f'testcase[@name="{DESIGN}"]/failure').text == f"Drive!D20 (Peak torque {SAFE}): FAIL"
    failure = first.find("testcase/failure")
    assert "Drive!D7" in failure.get("message")
    assert failure.text.count("\n") == 1
    assert "Drive!D9 (RMS): value: found 1, expected 1.25 [formulon]" in failure.text
    assert first.find("properties/property[@name='sha256']").get("value") == "ab" * 32
    assert (second.get("tests"), second.get("failures")) == ("2", "0")
    assert third.find("testcase/error").get("message") == "bad.xlsx: Timing!D7: found 'x'"
    assert fourth.find("testcase/skipped") is not None
    assert {k: root.get(k) for k in ("tests", "failures", "errors")} == {"tests": "9", "failures": "4", "errors": "1"}


def test_every_character_is_made_fit_or_kept():
    for code in (*range(0x3000), *range(0xD700, 0xE000), *range(0xFE00, 0x10100)):
        text = xml_safe(chr(code))
        ElementTree.fromstring(f"<a>{text}</a>" if text not in "<&" else "<a/>")
    assert xml_safe("ÿ_max ≤ 9 m/s², 中文 😀\u00a0\n\t") == "ÿ_max ≤ 9 m/s², 中文 😀\u00a0\n\t"


@pytest.mark.parametrize("name", ["book.xlsx", "report", "report.xml"])
def test_a_report_takes_no_name_of_another_kind_even_by_force(tmp_path, name):
    """``--report book.xlsx --force`` must not replace a workbook."""
    with pytest.raises(WriteError, match="expected the name of a report"):
        require_writable(tmp_path / name, (".html", ".htm"), overwrite=True)


def test_the_command_writes_both_reports_also_where_a_file_cannot_be_read(tmp_path):
    html, xml = tmp_path / "new" / "r.html", tmp_path / "r.xml"
    command = [sys.executable, "-m", "workbook", "verify", str(tmp_path / "gone.xlsx")]
    done = subprocess.run([*command, "--report", html, "--junit", xml], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "there is no such file" in Read(html.read_text(encoding="utf-8")).said
    assert ElementTree.parse(xml).getroot().get("errors") == "1"
    again = subprocess.run([*command, "--report", html], capture_output=True, text=True, check=False)
    assert again.returncode == 2
    assert "the file exists" in again.stderr
