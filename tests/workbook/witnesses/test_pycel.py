"""The pycel witness: against figures worked by hand, and against workbooks that mean harm."""

from __future__ import annotations

import datetime
import math
import os
from itertools import chain
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from openpyxl import Workbook
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula, DataTableFormula
from pycel.excelutil import build_operator_operand_fixup

from workbook.book.address import Address
from workbook.book.columns import Formulas
from workbook.book.formula import FormulaError, read
from workbook.reading.contents import Contents
from workbook.witnesses.pycel import compiled, shortcuts
from workbook.witnesses.pycel.limits import build_operators
from workbook.witnesses.pycel.model import PycelModel
from workbook.witnesses.pycel.shortcuts import plain

SHEET = "Sheet 1"


def evaluate(workbook: Workbook) -> dict[Address, Any]:
    return PycelModel(workbook).evaluate()


def book(cells: dict[str, Any], names: dict[str, str] | None = None, other: dict[str, Any] | None = None) -> Workbook:
    """A workbook of two sheets, ``Sheet 1`` with ``cells`` and ``Other`` with ``other``."""
    workbook = Workbook()
    workbook.active.title = SHEET
    workbook.create_sheet("Other")
    for sheet, content in ((workbook[SHEET], cells), (workbook["Other"], other or {})):
        for a1, value in content.items():
            sheet[a1] = value
    for name, text in (names or {}).items():
        workbook.defined_names[name] = DefinedName(name, attr_text=text)
    return workbook


def at(a1: str, sheet: str = SHEET) -> Address:
    return Address.parse(a1, sheet)


def value(formula: str, cells: dict[str, Any] | None = None) -> Any:
    """What ``formula`` computes in cell Z99."""
    return evaluate(book({**(cells or {}), "Z99": formula}))[at("Z99")]


def problem(formula: str) -> tuple[Any, str]:
    model = PycelModel(book({"Z99": formula}))
    return model.evaluate()[at("Z99")], model.problems.get(at("Z99"), "")


TABLE = {"A1": 3, "A2": 1.5, "A3": -4, "A4": "text", "A5": True, "B1": 10, "B2": 20, "B3": 30, "C1": 0.5, "D1": "5"}
WORKED = {
    "=IF(A1>A2,1,2)": 1, "=AND(A1>0,A3<0)": True, "=OR(A1<0,A3>0)": False, "=NOT(A5)": False, "=MIN(A1:A5)": -4,
    "=MAX(A1:B3,7)": 30, "=ABS(A3)": 4, "=SIGN(A3)": -1, "=SQRT(A1*12)": 6, "=SIN(PI()/6)": 0.5, "=COS(PI()/3)": 0.5,
    "=TAN(PI()/4)": 1, "=ATAN2(1,1)": math.pi / 4, "=ATAN2(-1,0)": math.pi, "=PI()": math.pi, "=EXP(1)": math.e,
    "=LN(EXP(2))": 2, "=LOG10(1000)": 3, "=POWER(2,10)": 1024, "=2^-1": 0.5, "=INT(-2.5)": -3,
    "=ROUND(2.675,2)": 2.68, "=ROUND(-2.5,0)": -3, "=SUM(A1:A5)": 0.5, "=SUMPRODUCT(A1:A3,B1:B3)": -60,
    "=SUMPRODUCT(B1)": 10, "=SUMPRODUCT(B1*(B2-B3))": -100, "=SUMPRODUCT(B1,B2)": 200,
    "=ROUND(SUMPRODUCT(A1:A3,B1:B3)/7,2)": -8.57, "=PRODUCT(A1:A5)": -18, "=PRODUCT(A4,C1:C9)": 0.5,
    "=PRODUCT(A4)": 0, "=PRODUCT(A1,1/0)": "#DIV/0!", "=PRODUCT(1E200,1E200)": "#NUM!", "=AVERAGE(B1:B3)": 20,
    "=COUNT(A1:A5)": 3, '=COUNTIF(B1:B3,">15")': 2, '=COUNTIF(A1:A5,"text")': 1, "=INDEX(B1:B3,2)": 20,
    "=INDEX(A1:B3,3,2)": 30, "=MATCH(25,B1:B3,1)": 2, "=MATCH(20,B1:B3,0)": 2, "=MATCH(9,B1:B3,1)": "#N/A",
    '=CHOOSE(2,"a","b")': "b", "=LARGE(B1:B3,1)": 30, "=SMALL(B1:B3,2)": 20, "=ISNUMBER(A4)": False,
    "=RADIANS(180)": math.pi, "=DEGREES(PI())": 180, "=A1&A4": "3text", "=50%": 0.5, "=A5+1": 2, "=D1*2": 10,
    "=A9+1": 1, "=A9": 0, '=A9=""': True, "=ROW(B7)": 7, "=COLUMN(C1:D3)": 3, "=A1:A1": 3, "=INDEX(A1:A1,1)": 3,
    "=  A1 +\n 1": 4, "=+A1": 3, "=007": 7, "=SUM({1,2;3,4})": 10, "=IF(TRUE,1,2)": 1, "='Sheet 1'!A1": 3,
    "='Sheet 1'!A1:'Sheet 1'!A2": 3, "=$A$1+A$2+$A3": 0.5, "=a1+sum(b1:b2)": 33, "=B3:A1": 3,
    "=INDEX(A1,1)": 3, "=INDEX(A1,1,1)": 3, "=INDEX(A1,2)": "#REF!", "=INDEX(A9,1)": 0,
}  # fmt: skip


@pytest.mark.parametrize("formula", WORKED)
def test_functions_give_the_figures_worked_by_hand(formula: str) -> None:
    expected = WORKED[formula]
    found = value(formula, TABLE)
    if isinstance(expected, str | bool):
        assert found == expected
        assert type(found) is type(expected)
    else:
        assert found == pytest.approx(expected, rel=1e-14, abs=1e-15)


def test_a_chain_of_5000_rows_is_evaluated() -> None:
    cells: dict[str, Any] = {"A1": 1} | {f"A{row}": f"=A{row - 1}+1" for row in range(2, 5001)}
    backwards = {f"B{row}": f"=B{row + 1}+1" for row in range(1, 5000)} | {"B5000": 1}
    found = evaluate(book(cells | backwards))
    assert (found[at("A5000")], found[at("B1")]) == (5000, 5000)


@pytest.mark.parametrize(
    "cells",
    [
        {"A1": "=A1+1"},
        {"A1": "=B1", "B1": "=C1+1", "C1": "=A1"},
        {"A1": "=SUM(B1:B3)", "B2": "=A1"},
        {"A1": "=B1+C1", "B1": "=A1", "C1": "=B1"},
    ],
)
def test_cells_of_a_cycle_are_found_and_named(cells: dict[str, str]) -> None:
    model = PycelModel(book(cells | {"E1": "=2*E2", "E2": 4}))
    found = model.evaluate()
    assert found == {at(a1): "#CYCLE!" for a1 in cells} | {at("E1"): 8}
    assert all("itself" in model.problems[at(a1)] or "themselves" in model.problems[at(a1)] for a1 in cells)


def test_what_follows_a_cycle_is_no_number() -> None:
    model = PycelModel(book({"A1": "=B1", "B1": "=A1", "C1": "=SUM(A1:A9)", "D1": "=C1+1"}))
    assert {model.evaluate()[at(a1)] for a1 in ("C1", "D1")} == {"#CYCLE!"}
    assert "depend on themselves" in model.problems[at("D1")]


def test_names_mean_cells_and_ranges_of_either_scope() -> None:
    names = {"rate": f"'{SHEET}'!$B$1", "Stages": "Other!$A$1:$A$3", "ωu": "Other!$A$2"}
    cells = {"A1": "=2*rate", "A2": "=SUM(stages)", "A3": "=RATE+ωu", "A4": "=Other!rate", "B1": 7}
    workbook = book(cells, names, {"A1": 1, "A2": 2, "A3": 3, "B1": "=rate", "C1": 100})
    workbook["Other"].defined_names["rate"] = DefinedName("rate", attr_text="Other!$C$1")
    found = evaluate(workbook)
    assert [found[at(f"A{i}")] for i in range(1, 5)] == [14, 6, 9, 100]
    assert found[at("B1", "Other")] == 100


@pytest.mark.parametrize("text", ["#REF!", "Gone!$A$1", "A1*2", "Other!$A:$A", "[1]Other!$A$1", "Other!A1"])
def test_names_that_lead_nowhere_are_problems(text: str) -> None:
    model = PycelModel(book({"A1": "=lost+1"}, {"lost": text}))
    assert model.evaluate()[at("A1")] in ("#NAME?", "#REF!")
    assert model.problems[at("A1")]


def test_sheets_are_found_whatever_they_are_called() -> None:
    workbook = Workbook()
    titles = ["It's", "B7", "2026", "α β", 'say "x"', "Q1.a"]
    for i, title in enumerate(titles):
        workbook.create_sheet(title)["A1"] = i
        quoted = title.replace("'", "''")
        workbook["Sheet"].cell(i + 1, 1).value = f"='{quoted}'!A1+'{quoted.upper()}'!$A$1"
    found = evaluate(workbook)
    assert [found[Address("Sheet", i + 1, 1)] for i in range(len(titles))] == [2 * i for i in range(len(titles))]


@pytest.mark.parametrize(
    ("formula", "error"),
    [
        ("=1/0", "#DIV/0!"),
        ("=5/Z9", "#DIV/0!"),
        ("=SQRT(-1)", "#NUM!"),
        ("=LN(0)", "#NUM!"),
        ('="a"+1', "#VALUE!"),
        ("=#N/A", "#N/A"),
        ("=Sheet1!#REF!+1", "#REF!"),
        ("=10^400", "#NUM!"),
        ("=1E308*10", "#NUM!"),
        ("=EXP(1000)", "#NUM!"),
        ("=POWER(-4,1/2)", "#NUM!"),
    ],
)
def test_errors_are_excels_and_travel(formula: str, error: str) -> None:
    cells = {"A1": formula, "B1": "=A1+1", "C1": "=MAX(1,B1)", "D1": "=IF(FALSE,C1,2)", "E1": "=ISNUMBER(A1)"}
    model = PycelModel(book(cells))
    found = model.evaluate()
    assert [found[at(a1)] for a1 in ("A1", "B1", "C1", "D1", "E1")] == [error, error, error, 2, False]
    assert not model.problems


@pytest.mark.parametrize(
    ("formula", "error", "reason"),
    [
        ("=XLOOKUP(1,A1:A2,B1:B2)", "#NAME?", "XLOOKUP"),
        ("=_xlfn.LET(_xlpm.x,1,x)", "#NAME?", ""),
        ("=OFFSET(A1,1,1)", "#NAME?", "OFFSET"),
        ("=[1]Sheet1!A1", "#NAME?", "cannot be read"),
        ("='[book.xlsx]Sheet1'!A1", "#REF!", "another file"),
        ("=Sheet1:Other!A1", "#NAME?", "Sheet1"),
        ("='Sheet 1'!A1:Other!B2", "#REF!", "spans sheets"),
        ("=Nowhere!A1", "#REF!", "no sheet"),
        ("=SUM(A:A)", "#REF!", "whole"),
        ("=SUM($1:$3)", "#REF!", "whole"),
        ("=SUM(A1:XFD1048576)", "#REF!", "200,000"),
        ("=A1048577", "#NAME?", "no cell"),
        ("=XFE1", "#NAME?", "no cell"),
        ("=Table1[x]", "#NAME?", "Table1"),
        ("=A1#", "#NAME?", "cannot be read"),
        ("=A1:INDEX(B1:B3,2)", "#NAME?", "cannot be read"),
        ("=A1:A3 A2:B2", "#REF!", "intersected"),
        ("=1+", "#NAME?", "compile"),
        ("=((1)", "#NAME?", "compile"),
        ('="open', "#NAME?", "cannot be read"),
        ("=1E999", "#NUM!", "larger"),
        ("=lost", "#NAME?", "lost"),
        ("=" + "ABS(" * 400 + "1" + ")" * 400, "#VALUE!", "nested"),
        ("=1" + "+1" * 3000, "#VALUE!", "nested"),
        ("=" + "(" * 3000 + "1" + ")" * 3000, None, ""),
        ("=" + "-" * 3000 + "1", "#VALUE!", ""),
        ("=1" + "+1" * 5000, "#NAME?", "8,192"),
        ("=" + "'" * 8000, "#NAME?", "cannot be read"),
        ("=" + '"' * 7999, "#NAME?", "cannot be read"),
    ],
)
def test_what_cannot_be_evaluated_is_a_problem_and_no_crash(formula: str, error: str | None, reason: str) -> None:
    found, why = problem(formula)
    if error is not None:
        assert found == error
        assert reason in why
        assert why
        assert "\n" not in why


HOSTILE = [
    '="\\" & __import__(\'os\').mkdir(\'{0}\') & "\\"',
    "=\"\\\"&__import__(\"os\").mkdir(\"{0}\")&\"\\\"",
    '=__import__("os").mkdir("{0}")',
    "=EVAL(\"__import__('os').mkdir('{0}')\")",
    "=OPEN(\"{0}\",\"w\")",
    "=EXEC(\"open('{0}','w')\")",
    "=GETATTR(1,\"x\")",
    "=BREAKPOINT()",
    '=\'x")or(__import__("os").mkdir("{0}"))or("\'!A1',
    "='x\\'!A1&\"+open('{0}','w')+\"",
    '="a\n"&open("{0}","w")',
    "=LAMBDA(x,open(\"{0}\",\"w\"))",
    "=IF(1,{{open(\"{0}\",\"w\")}})",
    "=_R_(\"A1\")&_C_(\"A1\")&lambdas",
    "=MATH.__LOADER__(\"{0}\")",
]  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE)
def test_nothing_of_a_file_is_ever_executed(text: str, tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    found, why = problem(text.format("struck"))
    assert os.listdir(tmp_path) == []
    assert why or isinstance(found, str)


@given(st.text(alphabet=st.characters(exclude_categories=["Cs", "Cc"]), min_size=1, max_size=20))
def test_any_text_comes_back_as_it_was(text: str) -> None:
    quoted = text.replace('"', '""')
    assert value(f'=IF(TRUE,"{quoted}","")') == text


@given(st.text(alphabet="=+-*/^&<>(),;:%{}[]!'\"$# ABCabc019._\\?@\n", max_size=40))
def test_any_formula_gives_a_value_or_a_problem(text: str) -> None:
    workbook = book({"A1": 1, "B2": "x"})
    cell = workbook[SHEET]["Z99"]
    cell.value, cell.data_type = "=" + text, "f"
    found = PycelModel(workbook).evaluate()[at("Z99")]
    assert isinstance(found, int | float | str | bool)


@pytest.mark.parametrize(
    "formula",
    ["=9^9^9^9", "=9^(9^9)", "=POWER(9,POWER(9,9))", "=FACT(1E9)", "=FACTDOUBLE(1E9)", "=TRUNC(1,1E9)",
     "=ROUND(5,-1E9)", "=PV(9,1E9,1)", "=SUM({9,9}^{1E9,1E9})", "=SUM(POWER({9,9},1E9))"],
)  # fmt: skip
def test_no_number_fills_the_memory(formula: str) -> None:
    assert problem(formula) == ("#NUM!", "")


@pytest.mark.parametrize("criterion", ["(a+)+$*", "*a*a*a*a*b", "a{9}{9}{9}?"])
def test_no_criterion_searches_for_ever(criterion: str) -> None:
    cells = {"A1": "a" * 200, "B1": f'=COUNTIF(A1:A3,"{criterion}")', "B2": f'=MATCH("{criterion}",A1:A3,0)'}
    model = PycelModel(book(cells))
    assert set(model.evaluate().values()) == {"#VALUE!"}
    assert all("criterion" in why for why in model.problems.values())
    assert value('=COUNTIF(A1:A3,"a*")+MATCH("?a*",A1:A3,0)', cells) == 2


def test_numbers_and_texts_do_not_grow_from_cell_to_cell() -> None:
    cells: dict[str, Any] = {"A1": 10, "B1": "text"}
    cells |= {f"A{row}": f"=A{row - 1}*A{row - 1}" for row in range(2, 80)}
    cells |= {f"B{row}": f"=B{row - 1}&B{row - 1}" for row in range(2, 80)}
    found = evaluate(book(cells))
    assert found[at("A9")] == pytest.approx(1e256)
    assert found[at("A12")] == "#NUM!"
    assert found[at("B79")] == "#VALUE!"
    cells = {"A1": "a" * 30_000, "A2": '=SUBSTITUTE(A1,"a",A1)', "A3": '=LEN(SUBSTITUTE(A1,"a","b"))'}
    assert list(evaluate(book(cells)).values()) == ["#VALUE!", 30_000]


def test_pycels_operators_are_untouched_but_for_the_bounded_power() -> None:
    stock, ours = (build(lambda *_: None) for build in (build_operator_operand_fixup, build_operators))
    operands = (2, 0.5, -3, 0, "4", "x", None, True, "#N/A", ((1, 2), (3, 4)))
    for op in ("Add", "Sub", "Mult", "Div", "Pow", "Eq", "Lt", "GtE", "BitAnd", "USub"):
        for left in operands:
            for right in operands:
                if isinstance(expected := stock(left, op, right), complex):
                    expected = "#NUM!"
                if op == "Pow" and left in (0, None) and right in (0, None):
                    expected = "#NUM!"  # as Excel has it
                assert ours(left, op, right) == expected


def test_array_and_table_formulas_are_problems() -> None:
    workbook = book({"A1": 1, "D1": "=C1+1"})
    sheet = workbook[SHEET]
    sheet["B1"] = ArrayFormula("B1:B2", "=A1:A2*2")
    sheet["C1"] = DataTableFormula("C1:C3", r1="A1")
    model = PycelModel(workbook)
    found = model.evaluate()
    assert [found[at(a1)] for a1 in ("B1", "C1", "D1")] == ["#VALUE!"] * 3
    assert set(model.problems) == {at("B1"), at("C1")}


@given(
    st.lists(st.dictionaries(st.sampled_from(["A1", "A2", "B1", "C9"]), st.sampled_from([0, 1, True, 2.5, "x", None])))
)
def test_evaluating_again_equals_evaluating_afresh(rounds: list[dict[str, Any]]) -> None:
    cells = {"A1": 1, "A2": 2, "D1": "=A1+A2", "D2": "=IF(ISNUMBER(A1),D1,B1)", "D3": "=SUM(A1:C9)", "D4": "=D3&D2"}
    model = PycelModel(book(cells))
    for changes in rounds:
        inputs = {at(a1): v for a1, v in changes.items()}
        again, afresh = model.evaluate(inputs), PycelModel(book(cells)).evaluate(inputs)
        assert again == afresh
        assert [type(v) for v in again.values()] == [type(v) for v in afresh.values()]


def test_a_range_that_grows_too_large_down_a_column_is_refused_in_its_own_row() -> None:
    contents = Contents(book({"A1": 5, "XFD3": "=SUM($A$1:XFC3)", "XFD13": "=SUM($A$1:XFC13)"}))
    model = PycelModel(contents)
    assert model.evaluate() == {at("XFD3"): 5, at("XFD13"): "#REF!"}
    assert "200,000" in model.problems[at("XFD13")]
    assert contents.read([at("B12"), at("B14")]) == {at("B12")}


WORDS = ["B{r}", "$B{r}", "B${r}", "B{a}", "$C${r}:D{r}", "B{a}:C{r}", "C$7:C{r}", "{r}", "1.{r}", "x_{r}", '"B{r}"',
         "LOG10({r})", "B1{r}", "'Sheet {r}'!B{r}", "Other!$C{a}", "B0{r}", "AB{r}:AB{r}", "{r}E{a}"]  # fmt: skip


ROWS = st.lists(st.integers(1, 25), min_size=2, max_size=3)


@given(st.lists(st.tuples(st.lists(st.sampled_from(WORDS), min_size=1, max_size=4), ROWS), max_size=5))
def test_formulas_that_differ_in_their_row_are_read_as_each_by_itself(
    columns: list[tuple[list[str], list[int]]],
) -> None:
    area = Contents(book({"A1": 1}, {f"x_{r}": f"'{SHEET}'!$A${r}" for r in range(1, 26)})).area
    formulas = Formulas(SHEET, area)
    for words, row in ((words, row) for words, rows in columns for row in rows):
        text = "=" + "+".join(words).format(r=row, a=row - 1)
        assert outcome(lambda t=text, r=row: formulas.read(t, r)) == outcome(lambda t=text: read(t, SHEET, area))


def outcome(reading: Any) -> Any:
    """Shape, arguments and functions of a formula, or its fault."""
    try:
        formula = reading()
    except FormulaError as error:
        return error.value
    return formula.shape, formula.arguments, formula.functions


NUMBERS = st.one_of(st.integers(-(10**6), 10**6), st.floats(-1e9, 1e9))


FAR = NUMBERS.map(lambda x: x * 1e200)
LONG = st.lists(st.one_of(NUMBERS, FAR, st.sampled_from([0.1 + 0.2, 0.3])), min_size=6, max_size=6)


@given(LONG, st.sampled_from([*shortcuts.SIMPLE, "Div", "Pow"]), st.one_of(LONG, NUMBERS), st.booleans(), st.booleans())
def test_arrays_hold_what_is_made_of_each_element(one: Any, name: str, two: Any, turned: bool, wide: bool) -> None:
    left, right = (two, one) if turned else (one, two)
    operate = shortcuts.operate
    pairs = zip(*(part if isinstance(part, list) else [part] * 6 for part in (left, right)), strict=True)
    each = [outcome_of(lambda a=a, b=b: operate(a, name, b)) for a, b in pairs]
    ranges = [
        shortcuts.Range(zip(*[iter(part)] * (3 if wide else 1), strict=True)) if isinstance(part, list) else part
        for part in (left, right)
    ]
    for _ in range(2):  # what was made once is known
        made = outcome_of(lambda: plain(operate(ranges[0], name, ranges[1])))
        if made is OverflowError:
            assert OverflowError in each
            continue
        assert [len(row) for row in made] == ([3, 3] if wide else [1] * 6)
        assert same_values(chain(*made), each)


def outcome_of(made: Any) -> Any:
    """What is made, or that it overflows."""
    with np.errstate(all="ignore"):
        try:
            return made()
        except OverflowError:
            return OverflowError


def same_values(made: Any, own: Any) -> bool:
    """Whether values are the same, numbers to the last digit but one."""
    return all(
        a == b or (isinstance(a, float | int) and isinstance(b, float | int) and abs(a - b) <= 4e-16 * abs(b))
        for a, b in zip(made, own, strict=True)
    )


STRAIGHT = [
    "=SIN({})", "=COS({})", "=SQRT({})", "=ABS({})", "=EXP({})", "=LN({})", "=MIN({},A1)", "=MAX({},A1,B1)",
    "=MAX(A1:C2,{})", "=MAX(C1:C1)", "=MIN(A1:C1)", "=INDEX(A1:B2,{})", "=INDEX(A1:A2,{})", "=INDEX(C1:C1,{})",
    "=INDEX(C1:C3,1)", "=INDEX(C1:C3,2.0)", "=INDEX(A1:B2,{},2)", "=IF({}>1,A1,B2)", "=IF({},A1,B2)",
    "=IF(A1>B1,A1:B1,{})", "=SUM(IF({}>1,A1:B2,3))", "=SUM(IF({}>1,3,A1:B2))", "=SUM(IF({}>1,A1:A2,B1:B2))",
    "=SUM({})", "=SUM(A1:C2)", "=SUM(LN(A1:C1))", "=SUM(ABS(A1:C2))", "=SMALL(A1:C1,2)", "=SMALL(A1:B2,{})",
    "=SMALL(A1:C3,2)", "=SMALL(B3:C3,1)", "=SUMPRODUCT(A1:C1)", "=SUMPRODUCT(A1:B1,{})", "=SUMPRODUCT(A1:C1,A1:C1)",
    "=SUMPRODUCT(A1:A2,A1:C1)", "=SUMPRODUCT((A1:C1>5)*A1:C1)", "=SUMPRODUCT((D1:D5>{})*D1:D5)", "=SUM(D1:D5*{})",
    "=MAX(D1:D5-{})", "=SUMPRODUCT(SQRT(D1:D5-{}))", "=SUMPRODUCT(ABS(D1:D5-{}))", "=SUMPRODUCT(D1:D5>{})",
    "=INDEX(D1:D5*{},3)", "=MATCH(6,D1:D5*{},0)", "=SUMPRODUCT(IF(D1:D5>{},D1:D5,1))", "=D1:D5*{}", "=MIN(D1:D5/{})",
    "=SUMPRODUCT((D1:D5=3)*1)", "=SUMPRODUCT(SIGN(D1:D5-{})*D1:D5^2)", "=SUMPRODUCT(D1:D5*D1:D5,D1:D5-{})",
    "=IF({}=2,D1:D5*2,1)", "=SUMPRODUCT(LN(D1:D5-2),D1:D5)", "=SUMPRODUCT(SIN(D1:D5)*COS(D1:D5)+EXP(0-D1:D5))",
    "=SUM((D1:D5>{})+(D1:D5<4))", "=SUMPRODUCT((D1:D5>2)*(D1:D5<={}))", "=COUNT(D1:D5*{})", '=D1:D5&"x"',
    "=SMALL(D1:D5,{})", "=SMALL(D1:E5,{}+1)", "=MATCH({},D1:D5)", "=MATCH({},E1:E5,1)", "=MATCH(2,D1:E1,{})",
    "=MATCH({},A1:E1,1)", "=SUM(INDEX(A1:B2,{},0))", "=SUMPRODUCT(INDEX(D1:E5,{},0),{{3,4}},2^{{0,1}})",
]  # fmt: skip


@pytest.mark.parametrize("value", [0, 1, 2, 3, -1, 0.5, 2.0, True, "x", "2", None, "#N/A"])
def test_the_straight_ways_of_functions_lead_where_pycels_own_lead(value: Any, monkeypatch: Any) -> None:
    cells = {"A1": 5, "A2": 6, "B1": 7, "B2": 8, "C1": value, "A3": "–", "B3": '=""', "C3": 3}
    cells |= {"D1": 1, "D2": 2.5, "D3": 3, "D4": 4.25, "D5": 6, "E1": 3, "E2": 1.5, "E3": 2, "E4": 2, "E5": -1}
    cells |= {f"Z{row}": formula.format("C1") for row, formula in enumerate(STRAIGHT, 1)}
    kept = {"__builtins__", "_C_", "_R_", "_REF_", "pi", "chosen"}
    shortened = PycelModel(book(cells)).evaluate()
    monkeypatch.setattr(shortcuts, "SHORTCUTS", {})
    monkeypatch.setattr(shortcuts, "COUNTED", {})
    monkeypatch.setattr(compiled, "_space", {k: v for k, v in compiled._space.items() if k in kept})
    monkeypatch.setitem(compiled._space, "excel_operator_operand_fixup", build_operators(lambda *_: None))
    compiled.compiled.cache_clear()
    try:
        own = PycelModel(book(cells)).evaluate()
    finally:
        compiled.compiled.cache_clear()
    assert len(own) == len(STRAIGHT) + 1
    for row, formula in enumerate(STRAIGHT, 1):
        assert same_values([shortened[at(f"Z{row}")]], [own[at(f"Z{row}")]]), formula


def test_a_problem_goes_when_its_cause_goes() -> None:
    model = PycelModel(book({"A1": 5, "A2": "=BAHTTEXT(A1)", "A3": "=COUNTIF(B1:B3,A1)"}))
    model.evaluate({at("A1"): True})
    assert at("A2") in model.problems
    model = PycelModel(book({"A1": "=", "A2": '=LEFT("abc",A3)', "A3": 1}))
    assert model.evaluate()[at("A2")] == "a"
    assert not model.problems


def test_dates_are_numbers_and_saved_values_are_not_used() -> None:
    cells = {"A1": datetime.datetime(2024, 3, 1, 12), "A2": "=A1+1", "A3": datetime.date(1900, 3, 1), "A4": "=A3"}
    assert evaluate(book(cells)) == {at("A2"): 45353.5, at("A4"): 61}


def test_shared_shapes_keep_texts_and_kinds_apart() -> None:
    cells = {"A1": '="x"&1', "A2": '="y"&1', "A3": "=TRUE&1", "A4": "=1&1", "A5": "=1.0&1", "A6": '="1"&1'}
    assert list(evaluate(book(cells)).values()) == ["x1", "y1", "TRUE1", "11", "11", "11"]


def test_what_a_formula_reads_are_the_cells_of_its_ranges_too() -> None:
    graph = PycelModel(book({"A1": 1, "A2": "=A1+1", "B1": "=SUM(A1:A2)*C1", "C1": 2})).graph()
    (number,) = (number for number, cell in graph.cells.items() if cell == at("B1"))
    assert {graph.cells[source] for source in graph.sources(number)} == {at("A1"), at("A2"), at("C1")}
