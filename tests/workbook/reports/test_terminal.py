"""Nothing of a file or a path reaches the terminal unescaped: control characters, new lines, rich's markup, emoji."""

import io
import json
import os
import shutil
import tomllib
import zipfile
from pathlib import Path

import openpyxl
import pytest
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula
from rich.console import Console

from workbook import cli
from workbook.commands import make, verify
from workbook.errors import InputError, MotionbookError, visible
from workbook.judging.batch import Outcome
from workbook.judging.report import Finding, Report
from workbook.reports import console
from workbook.reports.terminal import say, say_data, shown

NASTY = "a\x1b[31mb\x9bc\nd\r\u2028e\u202ef[/red]g[bold]h:warning:i\x85\x00"
PLAIN = r"a\x1b[31mb\x9bc\nd\r\u2028e\u202ef[/red]g[bold]h:warning:i\x85\x00"
NAMES = ["a\x1b[31mb", "a\x9bb", "a\nb", "[/red]", "[bold]x", "x:warning:", "a\u202eb", "[link=file:x]y"]
posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such names")


def test_a_text_is_one_line():
    assert visible(NASTY) == PLAIN
    assert visible("Käse °C ∞ 漢字 😀") == "Käse °C ∞ 漢字 😀"
    assert visible("a\nb", safe="\n") == "a\nb"


@pytest.mark.parametrize("style", ["", "red"])
def test_no_text_is_markup(style, capsys):
    say(Console(force_terminal=False), NASTY, style)
    assert capsys.readouterr().out == f"{PLAIN}\n"
    assert shown(NASTY, style).plain == PLAIN


def test_errors_are_lines_that_a_terminal_does_not_obey():
    assert str(MotionbookError(NASTY)) == PLAIN
    assert InputError([NASTY, NASTY]).lines == [PLAIN, PLAIN]


def test_data_stays_data(capsys):
    texts = {"text": NASTY.replace("\n", ""), "surrogate": "\udcff", "plain": "é😀"}
    say_data(json.dumps(texts, ensure_ascii=False, indent=1))
    printed = capsys.readouterr().out
    assert json.loads(printed) == texts
    assert all(line.isprintable() for line in printed.splitlines())
    say_data('name = "a\u009bb"\n')
    assert tomllib.loads(capsys.readouterr().out) == {"name": "a\u009bb"}


def test_reports_are_not_obeyed(tmp_path, capsys):
    finding = Finding(NASTY, "A1", "changed", NASTY, NASTY, what=NASTY, why=NASTY)
    report = Report(tmp_path / NASTY.replace("\x00", ""), NASTY, notes=[NASTY])
    report.findings, report.notices, report.own = [finding], [finding], [NASTY]
    report.cells = {NASTY: 1}
    out = Console(width=2_000)
    console.show_report(report, out)
    console.show_summary(
        [Outcome(report.path, "disagrees", report), Outcome(report.path, "unreadable", reason="x")], out
    )
    printed = capsys.readouterr().out
    assert all(line.isprintable() for line in printed.splitlines())
    assert "[/red]" in printed
    assert ":warning:" in printed


@posix
@pytest.mark.parametrize("name", NAMES)
def test_names_of_files_are_not_obeyed(name, press, motionbook, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    for name_, stream in (("OUT", False), ("ERR", True)):  # as on a terminal, with its status line
        shown_on = Console(stderr=stream, force_terminal=True, width=500, color_system=None)
        for module in (cli, make, verify):
            if hasattr(module, name_):
                monkeypatch.setattr(module, name_, shown_on)
    tmp_path.joinpath(name).parent.mkdir(exist_ok=True)  # one of the names has a slash
    shutil.copy(press.path, f"{name}.xlsx")
    commands = [
        ["inputs", f"{name}.xlsx", "-o", f"{name}.toml"], ["inputs", f"{name}.xlsx", "-o", f"{name}.toml"],
        ["build", f"{name}.none"], ["verify", f"{name}.none", f"{name}.no"], ["verify", f"{name}.none"],
        ["regenerate", f"{name}.xlsx", "-o", f"{name}.xlsx"], ["inputs", f"{name}.xlsx", "-o", f"{name}/x.toml"],
    ]  # fmt: skip
    for arguments in commands:
        code, out, err = motionbook(*arguments)
        said = without_status(out + err)
        assert code in (0, 2), said
        assert "failed inside" not in said
        assert visible(name) in said
        assert [line for line in said.splitlines() if not line.isprintable()] == []


def without_status(said):
    """What is said without the codes by which rich itself moves the cursor."""
    for code in ("\x1b[?25l", "\x1b[?25h", "\x1b[2K", "\x1b[1A", "\r"):
        said = said.replace(code, "")
    return said


NASTY_WORD = "a\x1b[31mb\x9bc\n[/red]:warning:\u202e"
MISUSED = [
    ["verify", "--nope", NASTY_WORD], ["verify", f"--{NASTY_WORD}"], ["verify", f"-{NASTY_WORD}"], [NASTY_WORD],
    ["laws", NASTY_WORD], ["verify", "x", "--with", NASTY_WORD], ["verify", "x", "--jobs", NASTY_WORD],
    ["verify", "x", f"--json={NASTY_WORD}"], ["regenerate", NASTY_WORD], ["inputs"], ["--nope"],
    ["build", "a.toml", NASTY_WORD, NASTY_WORD], ["verify", "x", "--jobs", "0"], ["build", "-o"],
]  # fmt: skip


@pytest.mark.parametrize("arguments", MISUSED, ids=lambda words: " ".join(words).encode("unicode_escape").decode())
def test_a_misused_command_is_told_in_one_line(arguments, motionbook):
    code, out, err = motionbook(*arguments)
    assert (code, out) == (2, "")
    (line,) = err.splitlines()
    assert line.isprintable()
    assert line.endswith("See --help.")


def test_help_is_shown_where_nothing_is_asked(motionbook):
    code, out, err = motionbook()
    assert code == 2
    assert "verify" in out + err


@pytest.mark.parametrize("fault", [RuntimeError("[/red]\x1b"), RecursionError("deep"), MemoryError()])
def test_a_fault_of_ours_is_one_line_and_no_verdict(fault, motionbook, monkeypatch, tmp_path):
    def fail(*_, **__):
        raise fault

    monkeypatch.setattr(make, "read_machine", fail)
    code, out, err = motionbook("build", "-o", tmp_path / "book.xlsx")
    assert (code, out) == (2, "")
    (line,) = err.splitlines()
    assert line.startswith("motionbook failed inside")
    assert line.isprintable()


def test_what_goes_with_a_report_of_a_fault_has_formulas_but_no_values(motionbook, monkeypatch, tmp_path):
    book = openpyxl.Workbook()
    book.active.append([987654, '=IF(A1>321,"secret",A1*1.5)', "secret", True, ArrayFormula("E1:F1", "=A1:B1*321")])
    book.defined_names["load"] = DefinedName("load", attr_text="987654*Sheet!$A$1")
    book.save(tmp_path / "b.xlsx")
    monkeypatch.setattr("workbook.commands.oracle.draft", lambda file: 1 / 0)
    code, _, err = motionbook("oracle", tmp_path / "b.xlsx")
    report = Path(err.split()[-1])
    with zipfile.ZipFile(report) as parts:
        copy = openpyxl.load_workbook(io.BytesIO(parts.read("book1.xlsx")))
        text = parts.read("report.txt").decode()
        inside = zipfile.ZipFile(io.BytesIO(parts.read("book1.xlsx")))
        every = text + "".join(inside.read(name).decode() for name in inside.namelist())
    report.unlink()
    assert code == 2
    cells = [cell.value for cell in copy.active[1]]
    assert cells[:4] == [1, '=IF(A1>1,"",A1*1)', "x", True]
    assert (cells[4].ref, cells[4].text) == ("E1:F1", "=A1:B1*1")
    assert "in write_draft" in text
    assert not any(word in every for word in ("987654", "secret", "321", "b.xlsx"))
