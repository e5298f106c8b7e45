"""The LibreOffice add-in, as installed, against the engine; and what is in its file."""

import ast
import itertools
import subprocess
import sys
import zipfile

import openpyxl
import pytest
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula

from engine.laws import law
from tests.functions.case import NUM, VALUE, Case, read, write
from tests.functions.cases import CLASSIC, engine_law, value_cases
from tests.functions.edges import edge_cases
from workbook.functions import publish
from workbook.functions.addin.motion_functions import library
from workbook.functions.addin.motion_functions.cells import parameters
from workbook.functions.addin.motion_functions.law import Refused
from workbook.functions.declarations import CODES, FUNCTIONS
from workbook.laws.registry import FAMILY

OLD_PYTHON = (3, 8)  # the oldest that a LibreOffice which can install the add-in has
ALLOWED = {"__future__", "bisect", "fractions", "functools", "itertools", "math", "struct", "typing", "unohelper",
           "motionbook", "motion_functions", "com.sun.star.lang"} | {  # of the menu:
           "json", "os", "re", "shutil", "subprocess", "tempfile", "threading", "uno", "motionbook_python",
           "motion_functions.findings", "motion_functions.service", "motion_functions.window", "motion_functions.work",
           "com.sun.star.awt", "com.sun.star.beans", "com.sun.star.document", "com.sun.star.frame", "com.sun.star.util",
           "com.sun.star.ui.dialogs.TemplateDescription", "hashlib"}  # fmt: skip


TYPES = {"code": "string", "number": "double", "cells": "any", "table": "any"}
"""UNO types: Calc converts, iterates and intersects the plain ones as for its own functions; ``any`` takes a range."""


def idl():
    """The interface of the component in UNOIDL."""
    methods = "".join(f"    {signature(function)}\n" for function in FUNCTIONS)
    return f"module motionbook {{\n  interface XMotionFunctions {{\n{methods}  }};\n}};\n"


def signature(function):
    arguments = ", ".join(f"[in] {TYPES[argument.kind]} {argument.name.en}" for argument in function.arguments)
    return f"double {function.key}({arguments});"


def cells(path, count):
    """The first rows of the only sheet, as values."""
    rows = openpyxl.load_workbook(path, data_only=True).active.iter_rows(values_only=True)
    return list(itertools.islice(rows, count))


def disagreeing(cases, found):
    return [f"{case.name}: {value!r}, expected {case.expected!r}"
            for case, value in zip(cases, found, strict=True) if not case.agrees(value)]  # fmt: skip


def test_every_case_agrees_with_the_engine(calc, tmp_path):
    cases = [*value_cases(), *edge_cases()]
    assert {case.function for case in cases} == {function.key for function in FUNCTIONS}
    write(cases, tmp_path / "cases.xlsx")
    assert disagreeing(cases, read(calc.computed(tmp_path / "cases.xlsx"))) == []


def test_the_same_as_array_formulas_in_a_book_that_brings_the_excel_names(calc, tmp_path):
    cases = edge_cases()
    write(cases, tmp_path / "excel.xlsx")
    book = openpyxl.load_workbook(tmp_path / "excel.xlsx")
    for (cell,) in book["Cases"].iter_rows(max_col=1):
        book["Cases"][cell.coordinate] = ArrayFormula(cell.coordinate, cell.value)
    for function in FUNCTIONS:
        text = "_xlfn.LAMBDA(_xlpm.law,_xlpm.xi,_xlpm.p,12345)"
        book.defined_names[function.name] = DefinedName(function.name, attr_text=text)
    book.save(tmp_path / "excel.xlsx")
    assert disagreeing(cases, read(calc.computed(tmp_path / "excel.xlsx"))) == []


def test_a_sheet_typed_by_hand_is_saved_with_the_names_of_excel(calc):
    path = calc.written(
        [
            'sheet.getCellByPosition(0, 0).FormulaLocal = "=motion.s(""CIC"";0.3;0)"',
            'sheet.getCellByPosition(1, 0).FormulaLocal = "=10*MOTION.CV(""MTP"";A2:G2)"',
            *(f"sheet.getCellByPosition({i}, 1).Value = {d}" for i, d in enumerate(CLASSIC)),
        ]
    )
    asked, found = (openpyxl.load_workbook(path, data_only=values).active[1] for values in (False, True))
    assert [cell.value for cell in asked[:2]] == ['=MOTION.S("CIC",0.3,0)', '=10*MOTION.CV("MTP",A2:G2)']
    assert found[0].value == pytest.approx(law("CIC").s(0.3), rel=1e-14)
    assert found[1].value == pytest.approx(20.0, rel=1e-14)


def test_a_saved_book_gets_no_second_name_for_a_function(calc, tmp_path):
    write(edge_cases()[:3], tmp_path / "named.xlsx")
    book = openpyxl.load_workbook(tmp_path / "named.xlsx")
    book.defined_names["MOTION.S"] = DefinedName("MOTION.S", attr_text="Data!$A$1")
    book.save(tmp_path / "named.xlsx")
    with zipfile.ZipFile(calc.computed(tmp_path / "named.xlsx")) as archive:
        assert archive.read("xl/workbook.xml").count(b'name="MOTION.S"') == 1  # Excel refuses two of one name


def load(path, data_only):
    return openpyxl.load_workbook(path, data_only=data_only).active


def test_a_column_goes_in_as_into_built_in_functions(calc, tmp_path):
    book = openpyxl.Workbook()
    sheet = book.active
    for row in range(1, 6):
        sheet.cell(row, 1, row / 10)
    sheet["B1"] = ArrayFormula("B1:B5", '=MOTION.S("CUB",A1:A5,0)')
    sheet["C2"] = '=MOTION.S("CUB",A1:A5,0)'  # meets the column in its own row
    book.save(tmp_path / "column.xlsx")
    rows = cells(calc.computed(tmp_path / "column.xlsx"), 5)
    assert [row[1] for row in rows] == pytest.approx([law("CUB").s(row / 10) for row in range(1, 6)], rel=1e-14)
    assert rows[1][2] == pytest.approx(law("CUB").s(0.2), rel=1e-14)


def test_only_the_parameters_of_a_law_can_be_left_out(calc, tmp_path):
    short = [Case("S", ("ACS",), VALUE), Case("JRED", (1.0,), VALUE), Case("POS", (1.0,), VALUE),
             Case("RMS", (1.0,), VALUE), Case("CV", ("ACS",), 2.0), Case("S", ("ACS", 0.5), 0.5)]  # fmt: skip
    write(short, tmp_path / "short.xlsx")
    assert disagreeing(short, read(calc.computed(tmp_path / "short.xlsx"))) == []


def texts(function, language):
    """What the function wizard says about a function, in its order."""
    words = (function.help, *(text for argument in function.arguments for text in (argument.name, argument.help)))
    return tuple(getattr(text, language) for text in words)


def test_a_sine_of_hundreds_of_turns_is_refused_where_every_turn_would_be_searched(calc, tmp_path):
    def turning(omega):
        return ((1.0, 0.0, 60.0, -180.0, 120.0, 1.0, omega, 0.0),)

    cases = [Case("CV", ("OWN", turning(1001.0)), NUM), Case("XI", ("OWN", 0.5, turning(-1001.0)), NUM)]
    slower, wanted = turning(999.0), engine_law("OWN", turning(999.0)).coefficients
    cases += [Case("CV", ("OWN", slower), wanted.cv), Case("CARMS", ("OWN", slower), wanted.ca_rms)]
    write(cases, tmp_path / "turns.xlsx")
    assert disagreeing(cases, read(calc.computed(tmp_path / "turns.xlsx"))) == []


@pytest.mark.parametrize(("locale", "language"), [("it-IT", "it"), ("de-AT", "de"), ("en-GB", "en"), ("fr-FR", "en")])
@pytest.mark.sample(2)
def test_the_texts_come_in_the_users_language(calc, locale, language):
    path = calc.written(
        [
            'provider = createUnoService("com.sun.star.configuration.ConfigurationProvider")',
            'place = argument("nodepath", "/org.openoffice.Office.CalcAddIns/AddInInfo/MOTION/AddInFunctions")',
            f'wanted = Array(place, argument("Locale", "{locale}"))',
            'kind = "com.sun.star.configuration.ConfigurationAccess"',
            "all = provider.createInstanceWithArguments(kind, wanted)",
            "keys = all.getElementNames()",
            "For row = 0 To UBound(keys)",
            "  sheet.getCellByPosition(0, row).String = keys(row)",
            '  sheet.getCellByPosition(1, row).String = all.getByName(keys(row)).getByName("Description")',
            '  taken = all.getByName(keys(row)).getByName("Parameters")',
            "  column = 2",
            "  inner = taken.getElementNames()",
            "  For Each key In inner",
            '    sheet.getCellByPosition(column, row).String = taken.getByName(key).getByName("DisplayName")',
            '    sheet.getCellByPosition(column + 1, row).String = taken.getByName(key).getByName("Description")',
            "    column = column + 2",
            "  Next",
            "Next",
        ]
    )
    found = {row[0]: {text for text in row[1:] if text} for row in cells(path, len(FUNCTIONS))}
    assert found == {function.key: set(texts(function, language)) for function in FUNCTIONS}


def test_the_types_were_made_from_what_is_declared():
    assert (publish.PACKAGE / "motion.idl").read_text(encoding="utf-8") == idl()


def refuses(make, error):
    """Whether a call raises this error."""
    try:
        make()
    except error:
        return True
    return False


@pytest.mark.parametrize("value", [-0.1, 0.0, 0.5, 1.0, 1.1])
@pytest.mark.parametrize("code", [code for code in CODES if code != "OWN" and FAMILY[code].parameters])
def test_the_add_in_refuses_the_parameters_that_the_law_refuses(code, value):
    page, entered = FAMILY[code], FAMILY[code].entries()
    numbers = page.numbers(entered)
    for k, (parameter, one) in enumerate(zip(page.parameters, numbers, strict=True)):
        row = [*numbers[:k], value, *numbers[k + 1 :]]
        if isinstance(one, str) or not any(row):  # zeros alone: as delivered
            continue
        field, _, index = parameter.key.partition(".")
        changed = {field: [*row] if index else value}
        by_law = refuses(lambda changed=changed: page.make_law(entered.model_copy(update=changed)), ValueError)
        by_add_in = refuses(lambda row=row: library.law(code, parameters(code, (tuple(row),))), Refused)
        assert by_add_in == by_law, f"{code}, {parameter.key} of {value}: see laws.md"


def test_the_same_bytes_each_time(add_in, tmp_path):
    publish.write_add_in(tmp_path / "again.oxt")
    assert (tmp_path / "again.oxt").read_bytes() == add_in.read_bytes()


def test_the_components_python_is_old_enough_and_needs_nothing_else(add_in):
    with zipfile.ZipFile(add_in) as archive:
        sources = {name: archive.read(name) for name in archive.namelist() if name.endswith(".py")}
    assert len(sources) == 11
    for name, source in sources.items():
        tree = ast.parse(source, name, feature_version=OLD_PYTHON)
        absolute = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and not n.level]
        plain = [alias.name for n in ast.walk(tree) if isinstance(n, ast.Import) for alias in n.names]
        assert {*plain, *(str(n.module).split(".cells")[0] for n in absolute)} - ALLOWED <= {
            f"motion_functions.{module}" for module in ("cells", "law")
        }


def test_the_command_writes_the_add_in_and_overwrites_nothing_unasked(add_in, tmp_path):
    def run(*arguments):
        line = [sys.executable, "-m", "workbook", "addin", *arguments]
        return subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, encoding="utf-8")

    target = tmp_path / "motion.oxt"
    assert run().returncode == 0
    assert target.read_bytes() == add_in.read_bytes()
    target.write_text("mine")
    refused = run("-o", "motion.oxt")
    assert (refused.returncode, target.read_text()) == (2, "mine")
    assert "the file exists" in refused.stderr
    assert run("--force").returncode == 0
    assert target.read_bytes() == add_in.read_bytes()
    misnamed = run("-o", "motion.zip")
    assert (misnamed.returncode, (tmp_path / "motion.zip").exists()) == (2, False)
