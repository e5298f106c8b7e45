"""What a function of the declarations does wrong is told as its own, in a line: where, what, and at which inputs."""

import openpyxl
import pytest

from workbook.errors import ReadError
from workbook.oracle import calls
from workbook.oracle.declarations import load_oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book

HEAD = """import time, sys
import numpy as np
from workbook.oracle import Oracle
b = Oracle("x")
a = b.input("A1", low=1, high=3)
"""
OUTPUT = """
@b.output("B1")
def o(a):
    {}
"""
TABLE = """
def f(t, a):
    {}
b.table("D1:F4", columns=["t", "v", "w"], of=f)
"""


@pytest.fixture
def judged(tmp_path):
    """Judge a small book against a text of declarations."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet["A1"], sheet["B1"], sheet["B2"] = 2, "=3*A1", "=4*A1"
    for row in range(1, 5):
        sheet.cell(row, 4, row), sheet.cell(row, 5, f"=A$1*D{row}"), sheet.cell(row, 6, f"=2*E{row}")
    book.save(tmp_path / "b.xlsx")

    def judge(text):
        (tmp_path / "d.py").write_text(HEAD + text, encoding="utf-8")
        return Judge(open_book(tmp_path / "b.xlsx"), load_oracle(tmp_path / "d.py")).judge(8)

    return judge


@pytest.mark.parametrize(
    ("body", "says"),
    [
        ("return {1: 2}[a]", "o at a = 2: line 9: KeyError: 2"),
        ("raise ValueError('odd')", "line 9: ValueError: odd"),
        ("sys.exit(3)", "line 9: SystemExit: 3"),
        ("return None", "returned None; expected a number"),
        ("return float('nan')", "returned nan; expected a finite number"),
        ("return np.array([a, a])", "returned an array of shape (2,); expected a single number"),
        ("return [a]", "returned a list"),
        ("return a * 1j", "returned a complex"),
        ("time.sleep(9)", "did not end within 1 s"),
    ],
)
def test_a_function_of_an_output_that_cannot_be_used(body, says, judged, monkeypatch):
    monkeypatch.setattr(calls, "SECONDS", 1.0)
    found = judged(OUTPUT.format(body) + "@b.output('B2')\ndef p(a):\n    return 4 * a\n")
    (line,) = found.unusable
    assert "d.py: o at a = 2: " in line
    assert says in line
    assert found.wrong == []
    assert [str(cell) for cell, state in found.states.items() if state == "agrees"] == ["Sheet!B2"]


def test_a_text_for_a_number_is_a_finding_in_a_line(judged):
    (fault,) = judged(OUTPUT.format("return 'a text'")).wrong
    assert (fault.found, fault.expected) == (6, "a text")


@pytest.mark.parametrize(
    ("body", "says"),
    [
        ("return None", "returned None; expected 2 columns: v, w"),
        ("return a * t", "returned an array of shape (4,); expected 2 columns"),
        ("return a * t, 'no'", "returned 'no' for the column w; expected a number for each of 4 rows"),
        ("return a * t, t[:2]", "returned an array of shape (2,) for the column w"),
        ("return a * t, t / 0", "returned inf in row 1 of the column w"),
        ("return 'ab'", "returned 'ab'; expected 2 columns"),
        ("return t.nothing", "AttributeError"),
    ],
)
@pytest.mark.filterwarnings("ignore:divide by zero")
def test_a_function_of_a_table_that_cannot_be_used(body, says, judged):
    (line,) = judged(TABLE.format(body)).unusable
    assert says in line


def test_a_sound_table_and_an_output_over_a_range(judged):
    range_ = '@b.output("E1:E4")\ndef e(a):\n    return [a, 2 * a, 3 * a, 4 * a]\n'
    found = judged(TABLE.format("return a * t, 2 * a * t") + range_)
    assert (found.wrong, found.unusable, {*found.states.values()}) == ([], [], {"agrees"})


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("b.table('D1:F4', columns=['t', 'v'], of=lambda t: t)", "2 columns are named, the range has 3"),
        ("def broken(:\n    pass", "line 6: SyntaxError"),
        ("import nowhere", "line 6: ModuleNotFoundError"),
        ("time.sleep(9)", "did not end within 1 s"),
    ],
)
def test_a_file_that_cannot_be_used(text, says, judged, monkeypatch):
    monkeypatch.setattr(calls, "SECONDS", 1.0)
    with pytest.raises(ReadError, match=r"d\.py") as raised:
        judged(text)
    assert says in str(raised.value)
