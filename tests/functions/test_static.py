"""What Excel asks of the names beyond what IronCalc, more lenient, checks."""

import re

import pytest
from xlsxwriter import Workbook

from workbook.book.formula import words
from workbook.functions.declarations import FUNCTIONS
from workbook.functions.names import FUTURE, definitions

EXCEL_2007 = {
    "ABS", "AND", "COLUMNS", "COUNT", "COS", "IF", "INDEX", "INT", "ISERROR", "ISTEXT", "MAX", "MIN", "OR", "PI",
    "ROWS", "SIN", "SQRT", "SUM", "TRIM", "UPPER",
}  # fmt: skip
LENGTH, NESTING, ARGUMENTS, NOTE = 8192, 64, 254, 255
LOOKS_LIKE_A_CELL = re.compile(r"[A-Za-z]{1,3}\d+|[rR]\d*([cC]\d*)?|[cC]\d*")
by_name = {d.name: d for d in definitions()}
names = pytest.mark.parametrize("name", by_name)


def tokens(formula):
    """The words of a formula with their kinds; the bracket of a call stands by itself."""
    split = (
        [(kind, part[:-1]), ("sign", "(")] if kind == "function" else [(kind, part)] for kind, part in words(formula)
    )
    return [token for pair in split for token in pair]


def declared_variables(formula):
    """The parameters of every LAMBDA and the variables of every LET, in the order of the formula."""
    parts = [("", ""), *tokens(formula), ("", "")]
    found = []
    around = []  # the calls that a part stands in, and in which argument
    for (_, before), (kind, part), (_, after) in zip(parts, parts[1:], parts[2:], strict=False):
        if part in ("(", "{"):
            around.append((before, 0))
        elif part in (")", "}"):
            around.pop()
        elif part == ",":
            call, argument = around.pop()
            around.append((call, argument + 1))
        elif kind == "name" and (before, after) == ("[", "]"):
            found.append(part)
        elif kind == "name" and before in ("(", ",") and after == ",":
            call, argument = around[-1]
            if call == "LAMBDA" or (call == "LET" and argument % 2 == 0):
                found.append(part)
    return found


def plain(name):
    return tokens(by_name[name].formula)


def test_every_declared_function_is_a_name_with_the_declared_arguments():
    for function in FUNCTIONS:
        formula = by_name[function.name].formula
        taken = [argument.shown for argument in function.arguments]
        assert formula.startswith(f"LAMBDA({', '.join(taken)},"), function.name


@names
def test_every_function_called_exists(name):
    called = {part for kind, part in plain(name) if kind == "function"}
    assert called <= EXCEL_2007 | set(FUTURE) | set(by_name)


@names
def test_every_word_is_a_variable_of_the_formula(name):
    variables = {part for kind, part in plain(name) if kind == "name"}
    assert variables - {"TRUE", "FALSE"} == set(declared_variables(by_name[name].formula))


@names
def test_variables_look_like_neither_cells_nor_names_nor_functions(name):
    for variable in declared_variables(by_name[name].formula):
        assert re.fullmatch(r"[A-Za-z]+", variable)
        assert not LOOKS_LIKE_A_CELL.fullmatch(variable), variable
        assert variable.upper() not in EXCEL_2007 | set(FUTURE), variable


@names
def test_newer_functions_and_variables_are_marked_in_the_file(name):
    stored = tokens(by_name[name].stored)
    variables = {f"_xlpm.{variable}" for variable in declared_variables(by_name[name].formula)}
    assert {part for kind, part in stored if kind == "function"} <= EXCEL_2007 | set(FUTURE.values()) | set(by_name)
    marked = {part for kind, part in stored if kind == "name"}
    assert {part.replace("_xlop.", "_xlpm.") for part in marked} - {"TRUE", "FALSE"} == variables


def test_an_optional_parameter_is_marked_where_it_is_declared_and_nowhere_else():
    """As Excel saves LAMBDA(law, [parameters], … ISOMITTED(parameters) …)."""
    for function in FUNCTIONS:
        stored = by_name[function.name].stored
        optional = [f"_xlop.{argument.name.en}" for argument in function.arguments if argument.optional]
        assert re.findall(r"_xlop\.\w+", stored) == optional, function.name
        assert all(f",{mark}," in stored.partition("(_MOTION")[0] for mark in optional)
        left_out = re.findall(r"_xlfn\.ISOMITTED\(_xlpm\.(\w+)\)", stored)
        assert [f"_xlop.{name}" for name in left_out] == optional
        assert "[" not in stored


@names
def test_brackets_close_within_the_limits_of_excel(name):
    open_brackets, deepest, commas = [], 0, [0]
    for _, part in plain(name):
        if part in "({":
            open_brackets.append(part)
            commas.append(0)
        elif part in ")}":
            assert open_brackets.pop() + part in ("()", "{}")
            assert commas.pop() < ARGUMENTS
        commas[-1] += part == ","
        deepest = max(deepest, len(open_brackets))
    assert not open_brackets
    assert deepest <= NESTING
    assert len(by_name[name].stored) <= LENGTH
    assert len(name) <= 255
    assert 0 < len(by_name[name].note) <= NOTE


@names
def test_numbers_keep_within_the_fifteen_digits_that_excel_reads(name):
    assert all(len(part.replace(".", "")) <= 15 for kind, part in plain(name) if kind == "number")


@names
def test_no_minus_stands_in_front_of_a_power(name):
    parts = [part for _, part in plain(name)]
    for before, sign, after in zip(parts, parts[1:], [*parts[3:], ""], strict=False):
        assert not (sign == "-" and after == "^" and before in "(,+-*/=<>"), "Excel takes the minus first"


def test_no_name_calls_itself_in_a_circle():
    calls = {name: {part for kind, part in plain(name) if kind == "function"} & set(by_name) for name in by_name}
    while free := [name for name, called in calls.items() if not called]:
        for name in free:
            del calls[name]
        for called in calls.values():
            called.difference_update(free)
    assert not calls


def test_every_helper_is_called():
    called = {part for name in by_name for kind, part in plain(name) if kind == "function"}
    assert {name for name in by_name if name.startswith("_")} <= called


@pytest.mark.parametrize("function", FUTURE)
def test_the_mark_of_a_newer_function_is_the_one_that_xlsxwriter_knows(tmp_path, function):
    with Workbook(tmp_path / "book.xlsx", {"use_future_functions": True}) as book:
        sheet = book.add_worksheet()
        assert sheet._prepare_formula(f"={function}(1)", True) == f"{FUTURE[function]}(1)"
