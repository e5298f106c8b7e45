"""A workbook that motionbook did not build, against declarations in Python."""

import ast
import json

import openpyxl
import pytest
from openpyxl.worksheet.datavalidation import DataValidation
from openpyxl.worksheet.formula import ArrayFormula

from workbook.book.address import Address
from workbook.commands.oracle import against
from workbook.errors import ReadError
from workbook.oracle.declarations import load_oracle
from workbook.oracle.draft import draft
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book
from workbook.witnesses.pycel.model import PycelModel
from workbook.witnesses.registry import WITNESSES

PUMP = """
from math import pi
from workbook.oracle import Oracle

pump = Oracle("Pump sizing")
q = pump.input("Sheet!B1", unit="m³/h", low=5, high=80)
h = pump.input("Head", unit="m", low=2, high=60)
eta = pump.input("Efficiency", low=0.4, high=0.9)


@pump.output("B6", unit="kW", tolerance=1e-9, source="ISO 9906")
def power(q, h, eta):
    return 1000 * 9.81 * q / 3600 * h / eta / 1000


def profile(t, q):
    return t * q, 2 * t * q


pump.table("A10:C13", columns=["t", "v", "a"], of=profile)
"""


def build(path, **cells):
    """Write a small workbook of a pump, some cells otherwise."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Sheet"
    rows = {
        "A1": "Flow", "B1": 40, "C1": "m³/h", "A2": "Head:", "B2": 20, "C2": "m", "A3": "Efficiency", "B3": 0.7,
        "A4": "Density", "B4": 1000, "A5": "Hydraulic power", "B5": "=B4*9.81*B1/3600*B2/1000", "C5": "kW",
        "A6": "Shaft power", "B6": "=B5/B3", "C6": "kW", "A7": "Note", "B7": "=B1*0",
    }  # fmt: skip
    for row in range(10, 14):
        rows |= {f"A{row}": (row - 10) / 4, f"B{row}": f"=A{row}*$B$1", f"C{row}": f"=2*B{row}"}
    for cell, value in (rows | cells).items():
        sheet[cell] = value
    book.save(path)
    return path


@pytest.fixture
def judged(tmp_path):
    """Judges the pump's workbook with some cells otherwise."""

    def judge(cases=40, **cells):
        (tmp_path / "pump.py").write_text(PUMP, encoding="utf-8")
        file = open_book(build(tmp_path / "pump.xlsx", **cells))
        return Judge(file, load_oracle(tmp_path / "pump.py")).judge(cases)

    return judge


def kinds(found):
    return {(str(one.cell), one.kind) for one in found.wrong}


def test_a_sound_workbook_has_no_finding_and_each_formula_cell_a_class(judged):
    found = judged()
    assert found.wrong == []
    classes = {str(cell): kind for cell, kind in found.coverage.items()}
    assert classes.pop("Sheet!B5") == "step"
    assert classes.pop("Sheet!B7") == "unaccounted"  # nothing compared follows from it
    assert set(classes.values()) == {"compared"}
    assert (len(classes), found.cases) == (9, 40)


@pytest.mark.parametrize(
    ("cell", "formula"),
    [
        ("B5", "=B4*9.81*B1/3600*B2/1001"), ("B5", "=B4*9.81*B1/3600*B3/1000"), ("B6", "=B5*B3"), ("B6", "=-B5/B3"),
        ("B6", "=IF(B1>79,0,B5/B3)"), ("C12", "=2*B11"), ("B11", "=A11*$B$2"), ("B5", "=B4*9.81*B1/3600*20/1000"),
    ],
)  # fmt: skip
def test_a_wrong_formula_is_found_at_the_inputs_where_it_shows(judged, cell, formula):
    found = judged(**{cell: formula})
    assert "value" in {one.kind for one in found.wrong}
    assert all(one.at for one in found.wrong if one.kind == "value")


def test_other_faults_are_named(judged):
    assert ("Sheet!B3", "unread") in kinds(judged(B6="=B5/0.7"))
    assert ("Sheet!B6", "unit") in kinds(judged(C6="W"))
    assert kinds(judged(C1="m^3/h")) == set()


@pytest.mark.parametrize(
    ("cell", "formula", "says"),
    [
        ("B7", "=B1+B2", "a sum of m^3/s and m"),
        ("B7", "=SIN(B2)", "SIN of m"),
        ("D6", "=B6*B2", "kg·m^3/s^3 where the unit says kg·m^2/s^3"),
    ],
)
def test_units_that_do_not_go_together_are_named(judged, cell, formula, says):
    found = judged(**{cell: formula, "E6": "kW"})
    assert [(str(one.cell), one.found) for one in found.wrong if one.kind == "dimension"] == [(f"Sheet!{cell}", says)]


def test_a_number_stands_in_for_a_macro_and_some_sheets_are_counted(tmp_path):
    path = build(tmp_path / "p.xlsx", B3="=OfTheMaker(B1)")
    book = openpyxl.load_workbook(path)
    book.create_sheet("Other")["A1"] = "=Sheet!B1*Nowhere(1)"
    book.save(path)
    text = PUMP.replace("low=0.4, high=0.9", "low=0.4, high=0.9, macro=True").replace('"Pump sizing"', '"", ["Sheet"]')
    (tmp_path / "p.py").write_text(text.replace('"Efficiency"', '"Sheet!B3"'), encoding="utf-8")
    found = Judge(open_book(path), load_oracle(tmp_path / "p.py")).judge(20, witnesses=("pycel", "formulon"))
    assert found.wrong == []
    assert (len(found.coverage), found.notes) == (12, ["12 formulas: 12 pycel"])


def test_an_array_formula_of_one_cell_is_evaluated_as_libreoffice_writes_it(tmp_path):
    path = build(tmp_path / "p.xlsx", B7=ArrayFormula("B7:B7", "=SUM(B1:B2*B1:B2)"))
    file = open_book(path)
    assert PycelModel(file.contents).evaluate()[Address("Sheet", 7, 2)] == 40**2 + 20**2


def test_an_input_that_a_function_cannot_take_is_named(judged):
    (line,) = {line for line in judged(B1="none given").unusable if "power" in line}
    assert "power at q = none given, h = 20, eta = 0.7: line 13: TypeError" in line


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", WITNESSES)
def test_every_witness_is_asked_at_other_inputs(tmp_path, name):
    witness = WITNESSES[name]()
    if witness.kept or witness.version() is None:
        pytest.skip(f"{name} does not evaluate here")
    file = open_book(build(tmp_path / "p.xlsx"))
    flow, power = Address("Sheet", 1, 2), Address("Sheet", 6, 2)
    said = [values[power] for _, values in witness.varied(file, [{flow: 20}, {flow: 40}])]
    assert said == pytest.approx([1000 * 9.81 * q / 3600 * 20 / 0.7 / 1000 for q in (20, 40)], rel=1e-12)


def test_the_command_tells_coverage_and_marks_a_copy(tmp_path, capsys):
    book, declared, copy = build(tmp_path / "p.xlsx"), tmp_path / "p.py", tmp_path / "marked.xlsx"
    declared.write_text(PUMP, encoding="utf-8")
    assert against(book, declared, 20, None, copy, False, False) == 0
    assert "1 unaccounted; 90.9 % covered" in " ".join(capsys.readouterr().out.split())
    assert against(book, declared, 20, 95.0, None, True, False) == 1
    assert json.loads(capsys.readouterr().out)["findings"] == []
    fills = {cell: openpyxl.load_workbook(copy)["Sheet"][cell].fill.fgColor.rgb for cell in ("B5", "B6", "B7")}
    assert len(set(fills.values())) == 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = 1", "0 oracles"),
        (PUMP.replace("def power(q, h, eta)", "def power(q, h, mu)"), "no input is called so"),
        ("raise ValueError('oops')", "oops"),
        ("from workbook.oracle import Oracle\na = Oracle('a')\nb = a.input('B1')", "no output"),
    ],
)
def test_declarations_that_are_incomplete_are_refused(tmp_path, text, message):
    (tmp_path / "d.py").write_text(text, encoding="utf-8")
    with pytest.raises(ReadError, match=message):
        load_oracle(tmp_path / "d.py")


@pytest.mark.parametrize("cell", ["Nowhere", "Other!B1", "Note:"])
def test_a_cell_that_cannot_be_found_is_refused(judged, tmp_path, cell):
    (tmp_path / "d.py").write_text(PUMP.replace("Sheet!B1", cell), encoding="utf-8")
    with pytest.raises(ReadError, match=r"expected|no sheet|formula"):
        Judge(open_book(build(tmp_path / "p.xlsx")), load_oracle(tmp_path / "d.py"))


def test_ranges_of_a_draft_are_those_that_may_be_entered(tmp_path):
    path = build(tmp_path / "p.xlsx", E1=0.5, E2=0.9)
    book = openpyxl.load_workbook(path)
    rules = {
        "B1": DataValidation("decimal", operator="between", formula1="5", formula2="80"),
        "B2": DataValidation("list", formula1='"10,20,40"'),
        "B3": DataValidation("decimal", operator="lessThanOrEqual", formula1="$E$2"),
        "B4": DataValidation("list", formula1="$E$1:$E$2"),
        "A10": DataValidation("custom", formula1="=A10>0"),
    }
    for cell, rule in rules.items():
        rule.add(cell)
        book.active.add_data_validation(rule)
    book.save(path)
    text = draft(open_book(path))
    assert "'Sheet!B1', unit='m³/h', low=5.0, high=80.0)" in text
    assert "choices=[10.0, 20.0, 40.0])" in text
    assert "low=0.7, high=0.9)" in text
    assert "choices=[0.5, 0.9])" in text
    assert "'Sheet!A10', unit='', low=0, high=0)" in text


TRANSLATED = {
    "D1": "=IF(B1^-2%>SUM(B1:B3,A1),MAX(B1:B2),-B6^2)", "D2": "=ATAN2(B1,B2)+MOD(-B1,B2)+LOG(B1)*LOG(B1,3)",
    "D3": '=IF(NOT(AND(B2<30,B3>0)),"too large",AVERAGE(A10:C13))', "D4": "=IF(B1<>B2,B1-B2-B3)",
    "E1": "=2^3^2-ROUND(B1,1)", "E2": '=IF(A1="flow",B1,0)', "E3": "=B1&B2", "E4": "=E3+1",
}  # fmt: skip


def test_proposals_give_what_the_formulas_give_and_count_as_steps(tmp_path):
    path = build(tmp_path / "p.xlsx", **TRANSLATED, A20="Book", A21="Max", B21="=B3*2")
    (tmp_path / "d.py").write_text(text := draft(open_book(path), proposed=True), encoding="utf-8")
    assert "    shaft_power = hydraulic_power / efficiency\n" in text
    oracle = load_oracle(tmp_path / "d.py")
    for entry in oracle.inputs:
        entry.low, entry.high = 0.9 * entry.low, 1.1 * entry.high
    found = Judge(open_book(path), oracle).judge(20)
    assert (found.wrong, len(found.unusable)) == ([fault for fault in found.wrong if fault.kind == "dimension"], 3)
    assert {cell.a1 for cell, state in found.states.items() if state == "agrees"} >= {"D1", "D2", "D3", "D4", "B21"}
    assert found.count("compared") == 0
    assert found.count("step") >= 16
    assert any("are proposed" in note for note in found.notes)


def test_a_sheet_declares_what_a_file_would(tmp_path, motionbook):
    path, copy = build(tmp_path / "p.xlsx"), tmp_path / "c.xlsx"
    assert motionbook("oracle", path, "-o", copy)[0] == 0
    code, _, err = motionbook("verify", path, "--against", copy)
    assert (code, "Oracle has no formula in Python" in " ".join(err.split())) == (2, True)
    book = openpyxl.load_workbook(copy)
    rows = {row[0].value: row for row in book["Oracle"].iter_rows(min_row=2)}
    assert [cell.value for cell in rows["Sheet!B1"]] == ["Sheet!B1", "m³/h", 40, 40, None, None]
    rows["Sheet!B1"][2].value = 5
    for text, code, says in [
        ("=B4 * 9.81 * flow / 3600 * B2 / 1000 / efficiency", 0, "1 compared"),
        ("math.sqrt(flow)", 1, "Sheet!B6"),
        ("1 / (flow - 40)", 2, "Oracle, row 10 at B1 = 40: ZeroDivisionError"),
        ("().__class__", 2, "'.__class__' is not known; expected functions of math"),
        ("open('x')", 2, "'open' is not known; expected functions of math"),
        ("1 +", 2, "is no expression of Python"),
    ]:
        rows["Sheet!B6"][5].value = text
        book.save(copy)
        for judged in (path, copy):
            ended, out, err = motionbook("verify", judged, "--against", copy)
            assert ended == code, out + err
            assert says in " ".join((out + err).split())


def test_a_draft_declares_inputs_outputs_labels_and_units(tmp_path):
    text = draft(open_book(build(tmp_path / "p.xlsx")))
    ast.parse(text)
    assert "head = book.input('Sheet!B2', unit='m', low=20, high=20)" in text
    assert "@book.output('Sheet!B6', unit='kW', source='')\ndef shaft_power(flow, head, efficiency, density):" in text
    assert "hydraulic_power" not in text  # a step
