"""Books that evaluators other than Excel stumble over: none is blamed for what an evaluator cannot compute."""

import openpyxl
import pytest
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula
from openpyxl.worksheet.table import Table

from tests.workbook.evaluated import save_as_excel
from workbook.oracle.declarations import Oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book

NAMES = ("pycel", "formulon", "ironcalc")


def judged(path, cells, inputs, outputs, prepare=lambda sheet: None, names=NAMES, cases=12):
    """Return the judge and its report on a book of such cells, and functions by cells."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "S"
    for at, value in cells.items():
        sheet[at] = value
    prepare(sheet)
    book.save(path / "b.xlsx")
    oracle = Oracle("x")
    given = [oracle.input(cell, low=low, high=high) for cell, (low, high) in inputs.items()]
    for cell, function in outputs.items():
        oracle.output(cell, inputs=given)(function)
    judge = Judge(open_book(path / "b.xlsx"), oracle)
    return judge, judge.judge(cases, witnesses=names)


def with_names(sheet):
    for name, text in {"g": "9.81", "load": "S!$A$1", "rate": "S!$A$1*60"}.items():
        sheet.parent.defined_names[name] = DefinedName(name, attr_text=text)


def with_table(sheet):
    sheet.add_table(Table(displayName="Inertias", ref="A1:B3"))


THREADS = {"B1": 1.27, "B2": 2.39, "B3": 3.18, "E1": 2.0, "E2": "=INDEX(B:B,MATCH(E1,B:B,1)+1)"}
CASES = {
    "a whole column": (THREADS, {"E1": (1.3, 3)}, {"E2": lambda n: min(x for x in (1.27, 2.39, 3.18) if x > n)}, None),
    "names of numbers and of formulas": (
        {"A1": 5, "B1": "=g*A1", "B2": "=load*2", "B3": "=rate/60"}, {"A1": (0.5, 2)},
        {"B1": lambda a: 9.81 * a, "B2": lambda a: 2 * a, "B3": lambda a: a}, with_names,
    ),
    "a table": (
        {"A1": "Part", "B1": "J", "A2": "screw", "B2": 1.2, "A3": "motor", "B3": 1.1, "D1": "=SUM(Inertias[J])"},
        {"B2": (0.5, 2)}, {"D1": lambda a: a + 1.1}, with_table,
    ),
    "a formula over several cells": (
        {"A1": 1, "B1": 10, "A2": 2, "B2": 20, "C1": ArrayFormula("C1:C2", "=A1:A2*B1:B2"), "E1": "=SUM(C1:C2)"},
        {"A1": (0.5, 2)}, {"E1": lambda a: 10 * a + 40}, None,
    ),
    "IF without else": (
        {"B1": 3200, "B2": 3000, "B3": '=IF(B1>B2,"too fast")'}, {"B1": (2000, 4000)},
        {"B3": lambda n: "too fast" if n > 3000 else False}, None,
    ),
    "a link in a cell that nothing reads": (
        {"A1": 2, "B1": "=[1]Sheet1!$A$1*A1", "B2": "=A1*3"}, {"A1": (1, 3)}, {"B2": lambda a: 3 * a}, None,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_no_book_is_blamed_for_what_an_evaluator_lacks(name, tmp_path):
    cells, inputs, outputs, prepare = CASES[name]
    _, report = judged(tmp_path, cells, inputs, outputs, prepare or (lambda sheet: None))
    assert (report.wrong, report.warnings, report.unusable) == ([], [], [])
    assert {*report.states.values()} == {"agrees"}


@pytest.mark.parametrize("name", ["a whole column", "a table", "a formula over several cells", "IF without else"])
def test_a_fault_there_is_found_or_told_as_disputed(name, tmp_path):
    cells, inputs, outputs, prepare = CASES[name]
    wrong = {
        cell: lambda *x, right=right: "no" if isinstance(right(*x), str) else right(*x) + 1
        for cell, right in outputs.items()
    }
    _, report = judged(tmp_path, cells, inputs, wrong, prepare or (lambda sheet: None))
    assert {*report.states.values()} <= {"differs", "disputed"}
    assert len(report.wrong) + len(report.warnings) == len(outputs)


def test_the_line_says_who_judged_and_why_others_could_not(tmp_path):
    cells = {"A1": 2, "B1": "=[1]S!$A$1*A1", "B2": "=A1*3", "B3": "=NOW()", "B4": "=MEDIAN(A1,3)", "B5": "=NOSUCH(A1)"}
    judge, report = judged(tmp_path, cells, {"A1": (1, 3)}, {"B2": lambda a: 3 * a, "B5": lambda a: "#NAME?"})
    line = judge.evaluators.line(judge.formulas)
    assert line.startswith("5 formulas: 2 pycel, 1 formulon and ironcalc, 2 cannot (")
    assert "external link ×1" in line
    assert report.states.keys() == set(judge.targets)
    assert {*report.states.values()} == {"agrees"}


def test_cells_that_an_array_of_today_fills_are_of_another_value_each_time(tmp_path):
    cells = {"A1": "=TODAY()", "B1": ArrayFormula("B1:B2", "=A1+{0;1}"), "B2": "=", "C1": "=B2*2", "D1": "=2*3"}

    def as_excel(sheet):
        sheet["B2"].data_type = "f"  # written without a text

    judge, _ = judged(tmp_path, cells, {}, {"D1": lambda: 6.0}, as_excel)
    assert {cell.a1 for cell in judge.evaluators.clock} == {"A1", "B1", "B2", "C1"}


def declared(path, values):
    """Return the states of cells declared to have these values, and the judge."""
    oracle = Oracle("x")
    for cell, value in values.items():
        oracle.output(cell, inputs=[])(lambda value=value: value)
    judge = Judge(open_book(path), oracle)
    report = judge.judge(1, witnesses=NAMES)
    return {cell.a1: state for cell, state in report.states.items()}, judge, report


def test_what_excel_saved_decides_who_is_trusted(tmp_path):
    """Excel has FALSE where TRUE is 1; CHOOSE needs no branch that it does not take; an entered #NAME? goes on."""
    cells = {
        "A1": ("=TRUE=1", False), "A2": ('=CHOOSE(2,A2,"no circle")', "no circle"), "A4": ("=A3+1", "#NAME?"),
        "A5": ("=1/0+A3", "#NAME?"), "A6": ("=ROUND(2.5,0)", 4),
        "A7": ("=CHAR(1)", "_x0001_"), "A8": ("=10*LOG10(COS(RADIANS(90)))", -162.12841279011377),
    }  # fmt: skip
    path = save_as_excel(tmp_path / "b.xlsx", cells | {"A3": "#NAME?"})
    states, judge, report = declared(path, {cell: value for cell, (_, value) in cells.items()} | {"A7": "\x01"})
    assert states == dict.fromkeys(cells, "agrees") | {"A6": "cannot", "A8": "cannot"}
    assert report.wrong == []
    states, judge, report = declared(path, {"A6": 3.0})  # the saved value is stale
    assert [(fault.cell.a1, fault.kind) for fault in report.wrong] == [("A6", "stale")]
    assert "pycel" in judge.evaluators.trusted[report.wrong[0].cell]


def test_a_link_has_the_value_that_was_saved_of_it(tmp_path):
    cells = {"A1": 2.0, "B1": ("=[1]S!$A$1", 5.0), "B2": ("=B1*A1", 10.0), "B3": ("='[2]x y'!A1", "#REF!")}
    cells |= {"B4": ("=A1*[1]S!$A$1", 10.0), "B5": ("='C:\\a-b\\[c d.xlsx]e-f'!A1", 3.0)}
    path = save_as_excel(tmp_path / "b.xlsx", cells)
    states, judge, report = declared(path, {"B2": 10.0, "B1": 5.0})
    assert (states, report.wrong) == ({"B1": "agrees", "B2": "agrees"}, [])
    assert {cell.a1 for cell in judge.evaluators.linked} == {"B1", "B5"}
    assert any("=[1]S!$A$1" in note for note in report.notes)
    oracle = Oracle("x")
    oracle.output("B2", inputs=[oracle.input("A1", low=1, high=3)])(lambda a: 5 * a)
    report = Judge(open_book(path), oracle).judge(8, witnesses=NAMES)
    assert (report.wrong, {*report.states.values()}) == ([], {"agrees"})


def test_what_a_copier_saved_is_no_evidence(tmp_path):
    path = save_as_excel(tmp_path / "b.xlsx", {"A1": 1, "A2": ("=MEDIAN(A1,3)", 2.0)}, "A Copier")
    judge = declared(path, {"A2": 2.0})[1]
    assert (judge.evaluators.evidence, judge.evaluators.trusted[judge.targets[0]]) == ({}, ["formulon", "ironcalc"])
