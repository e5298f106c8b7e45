"""The audit: each rule names its own fault, most seeded faults are named, and nearly nothing in sound workbooks."""

import json
from random import Random

import openpyxl
import pytest

from tests import tiers
from tests.workbook.audit.books import write_book
from tests.workbook.audit.seeds import draw
from tests.workbook.evaluated import save_as_excel
from workbook.audit import audit
from workbook.audit.register import KINDS
from workbook.build import COMMITTED
from workbook.reading.files import open_book
from workbook.template import FOLDER

RISING = [[k + 1, 3 * k + 2, f"=A{k + 1}*B{k + 1}"] for k in range(8)]
SMALL = {  # rule: rows of a sheet, the cell that is named
    "pattern": ([*RISING[:3], [4, 11, "=A4*B5"], *RISING[4:]], "C4"),
    "typed-over": ([*RISING[:3], [4, 11, 44], *RISING[4:]], "C4"),
    "gap": ([*RISING[:3], [4, 11, None], *RISING[4:]], "C4"),
    "dollar": ([*RISING[:3], [4, 11, "=A4*B$4"], *RISING[4:]], "C4"),
    "moved-off": ([[2, 3], [], *([k, None, f"=A{k}*B{k - 2}"] for k in range(3, 9))], "C4"),
    "stuck": ([[k + 1, 3 * k + 2, "=A$1*5"] for k in range(8)], "C2"),
    "range": ([*RISING, [], [None, None, "=SUM(C1:C7)"]], "C10"),
    "unsorted": ([[1, 5], [4, 6], [3, 7], [9, 8], ["=VLOOKUP(3.5,A1:B4,2)"]], "A5"),
    "text-number": ([*RISING[:3], [4, "11", "=A4*B4"], *RISING[4:]], "B4"),
    "blank": ([*RISING[:3], [4, None, "=A4*B4"], *RISING[4:]], "B4"),
    "hidden-error": ([[1, 0, "=IFERROR(A1/B1,0)"]], "C1"),
    "circular": ([[1, "=A1+C1", "=B1*2"]], "B1"),
    "link": ([["=[3]Prices!B7*2"]], "A1"),
    "volatile": ([[3, '=INDIRECT("A1")*2']], "B1"),
    "dimension": ([["Length", 3, "m"], ["Time", 4, "s"], ["Speed", "=B1*B2", "m/s"]], "B3"),
    "scale": ([["Length", 3, "mm"], ["Time", 4, "s"], ["Speed", "=B1/B2", "m/s"]], "B3"),
    "typed-in": ([["Share of load", 0.365], ["Mass", 12], ["Load", "=B2*0.365"]], "B3"),
    "unread": ([[3], [5], [8], [9], [11], [], ["=A1+A2*2+A4*3+A5"]], "A3"),
}  # fmt: skip

INNOCENT = {  # what is meant so, as public workbooks have it: rows of a sheet in which nothing is named
    "no formula": [[1, 2], ["a", "b"]],
    "picked figures": [[3, 5], [4], *([None, None, f"=$A${1 + (k == 2)}-$B$1"] for k in range(6))],
    "a list not filled in": [[k + 1, None if k in (2, 5) else 3 * k + 2, f"=A{k + 1}*B{k + 1}"] for k in range(8)],
    "nothing filled in": [[1, 2, "=A1*B1"], [], [], [None, None, "=A4*B4"]],
    "a cross": [[None, "X", '=AND(A1="X",B1="X")']],
    "a row put in between": [[1], *([23] if k == 5 else [f"=A{k - (k == 6)}+5"] for k in range(1, 9))],
    "a series begins": [[1, 2, 9], *([k, 3 * k, f"=A{k}*B{k}"] for k in range(2, 9))],
    "a sum of its own": [*RISING[:4], ["so far", None, "=C3+C4"], *RISING[5:]],
    "a table's column": [[3, "=Table1[[#This Row],[a]]/'Other one'!A1", "=Table1[b]/Other!A1"]],
    "parts in a million": [["Drift [%]", "=(6/1000000)*B2*100"], ["Rise [°C]", 25]],
    "degrees an hour": [["Time [h]", 14], ["Angle [°]", "=(B1-12)*15"], ["Use [kWh]", 3650], ["Mean [kWh]", "=B3/365"]],
    "a share": [["Way [mm]", 3], ["Margin [%]", 1.15], ["Way with margin [mm]", "=B1*B2"]],
}  # fmt: skip


def audited(book, path):
    book.save(path)
    return audit(open_book(path))


def named(report):
    return {(f.rule, (f.cell.sheet, f.cell.a1)) for f in report.shown()}


@pytest.mark.parametrize("rule", SMALL)
def test_a_rule_names_its_fault_and_says_why(rule, tmp_path):
    book, (rows, cell) = openpyxl.Workbook(), SMALL[rule]
    for row in rows:
        book.active.append(row)
    for finding in (findings := audited(book, tmp_path / "book.xlsx").shown()):
        if (finding.rule, finding.cell.a1) == (rule, cell):
            assert finding.why
            return
    pytest.fail(str(findings))


@pytest.mark.parametrize("case", INNOCENT)
def test_what_is_meant_so_is_not_named(case, tmp_path):
    book = openpyxl.Workbook()
    for row in INNOCENT[case]:
        book.active.append(row)
    assert audited(book, tmp_path / "book.xlsx").shown() == []


def test_a_sum_that_has_itself_is_a_circle(tmp_path):
    book = openpyxl.Workbook()
    for row in (*RISING, [None, None, "=SUM(C1:C9)"]):
        book.active.append(row)
    assert ("circular", ("Sheet", "C9")) in named(audited(book, tmp_path / "book.xlsx"))


def test_another_file_is_named_once_whatever_its_sheets(tmp_path):
    book = openpyxl.Workbook()
    for formula in ("=[3]Prices!B7*2", "=[3]Rates!B7*2", "=[4]Rates!B7*2"):
        book.active.append([formula])
    found = named(audited(book, tmp_path / "book.xlsx"))
    assert {cell for rule, (_, cell) in found if rule == "link"} == {"A1", "A3"}


@pytest.mark.parametrize(("total", "cells"), [("=SUM(C1:C4)", {"B5"}), ("=SUM(Other!C1:C4)", set())])
def test_a_number_among_totals_is_named_where_these_are_of_its_own_sheet(total, cells, tmp_path):
    book = openpyxl.Workbook()
    for row in (*([k, f"=A{k}*2", f"=A{k}*3"] for k in range(1, 5)), [None, 21, total]):
        book.active.append(row)
    other = book.create_sheet("Other")
    for k in range(1, 5):
        other.append([k, k, k])
    found = named(audited(book, tmp_path / "book.xlsx"))
    assert {cell for rule, (_, cell) in found if rule == "typed-over"} == cells


def test_sheets_are_compared_and_hidden_ones_named(tmp_path):
    """The rules that need two sheets; with these every rule has a case."""
    book = openpyxl.Workbook()
    first, second = book.active, book.create_sheet("Second")
    for sheet in (first, second):
        for k, word in enumerate("mass lever spring belt wheel".split(), 1):
            sheet.append([word, k, f"{word} squared", f"=B{k}*B{k}"])
    second["D4"] = "=B4*B4*1.1"
    third, fourth = book.create_sheet("Third"), book.create_sheet("Fourth")
    third.append(["Price of power", 0.21])
    third.append(["Cost", "=B1*Fourth!B1*Fourth!B2"])
    fourth.append(["Price of power", 0.24])
    fourth.append(["Days", 220])
    fourth.sheet_state = "hidden"
    rules = {rule for rule, _ in named(audited(book, tmp_path / "book.xlsx"))}
    assert rules >= {"drifted", "other-value", "hidden"}
    assert {*SMALL, "drifted", "other-value", "hidden", "stale"} == KINDS.keys()


@pytest.mark.parametrize(("program", "sure"), [("Microsoft Excel", "high"), ("A Copier", "medium")])
@pytest.mark.sample(1)
def test_a_saved_value_that_two_evaluators_do_not_give_is_named(program, sure, tmp_path):
    """Of a file that asks to be computed at opening, as XlsxWriter leaves it, no saved value counts."""
    path = save_as_excel(tmp_path / "b.xlsx", {"A1": 2, "A2": ("=A1*3", 6), "A3": ("=A1*4", 9)}, program)
    assert [(f.cell.a1, f.sure) for f in audit(open_book(path)).shown() if f.rule == "stale"] == [("A3", sure)]
    unasked = save_as_excel(tmp_path / "c.xlsx", {"A1": 2, "A3": ("=A1*4", 9)}, program, asks=True)
    assert audit(open_book(unasked)).shown() == []


@pytest.mark.parametrize("number", [40, pytest.param(320, marks=pytest.mark.nightly)])
def test_of_faults_as_people_make_them_most_are_named(number, tmp_path):
    """A finding counts at a cell of the fault, if the sound workbook does not have it."""
    seed = tiers.seed("audit") if number > 40 else "audit by day"
    missed = [
        kind
        for kind, sound, faulty, cells in draw(seed, number)
        if not {cell for _, cell in named(audited(faulty, tmp_path / "faulty.xlsx"))
                - named(audited(sound, tmp_path / "sound.xlsx"))} & cells
    ]  # fmt: skip
    assert len(missed) <= 0.4 * number, missed


@pytest.mark.parametrize("number", [12, pytest.param(120, marks=pytest.mark.nightly)])
def test_of_a_thousand_formulas_at_most_one_is_named_in_sound_workbooks(number, tmp_path):
    seed = tiers.seed("sound") if number > 12 else "sound by day"
    reports = [audited(write_book(Random(f"{seed}, {k}")), tmp_path / "book.xlsx") for k in range(number)]
    alarms = [str(f) for report in reports for f in report.shown()]
    assert len(alarms) * 1_000 <= sum(report.formulas for report in reports), alarms


@pytest.mark.parametrize("name", tiers.by_day(COMMITTED, "motion-composer"))
def test_in_the_committed_workbooks_too(name):
    report = audit(open_book((FOLDER / name).with_suffix(".xlsx")))
    assert len(report.shown()) * 1_000 <= report.formulas, report.shown()


def test_the_command_writes_json_and_sarif_and_ends_by_what_it_finds(motionbook, tmp_path):
    book = openpyxl.Workbook()
    for row in SMALL["typed-over"][0]:
        book.active.append(row)
    path, log = tmp_path / "book.xlsx", tmp_path / "audit.sarif"
    book.save(path)
    code, out, _ = motionbook("audit", path, "--json", "--sarif", log)
    (finding,) = json.loads(out)["files"][0]["findings"]
    assert (code, finding["cell"], finding["rule"], finding["sure"]) == (1, "Sheet!C4", "typed-over", "high")
    (result,) = json.loads(log.read_text(encoding="utf-8"))["runs"][0]["results"]
    assert (result["ruleId"], result["level"]) == ("typed-over", "error")
    assert "C3 has =A3*B3" in result["message"]["text"]
    assert "typed-over" in motionbook("audit", path)[1]
    book.active["C4"] = "=A4*B4"
    book.save(path)
    assert motionbook("audit", path)[0] == 0
    (tmp_path / "broken.xlsx").write_bytes(b"PK")
    code, out, err = motionbook("audit", tmp_path, "--all")
    assert code == 2
    assert "broken.xlsx" in err
    assert "nothing found" in out
    assert motionbook("audit", tmp_path / "none.xlsx")[0] == 2
