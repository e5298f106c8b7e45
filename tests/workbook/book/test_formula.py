"""The reader of formulas: what it says of a text, and what it refuses."""

import pytest

from workbook.book.address import Address
from workbook.book.formula import LONGEST, Area, FormulaError, read
from workbook.reading.contents import Contents


def area(name: str, sheet: str) -> Area:
    return Area(name.rstrip("!"), 1, 1, 1, 1, single=True)


def test_a_formula_longer_than_excel_takes_is_refused() -> None:
    with pytest.raises(FormulaError, match="longer than"):
        read(f"={'1' * LONGEST}", "Sheet", area)


@pytest.mark.parametrize(
    ("text", "shape"),
    [("007", "=7"), ("1.5E+3", "=1500"), (".5", "=0.5"), ("1.", "=1"), ("2e-3*A1", "=0.002*A1"), ("1E5", "=100000")],
)
def test_numbers_are_read_as_they_were(text: str, shape: str) -> None:
    assert read(f"={text}", "Sheet", area).shape == shape


@pytest.mark.parametrize("text", ["1a", "1.2.3", "1E", "1e+", "1.5E+x", "1_000"])
def test_what_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(FormulaError):
        read(f"={text}", "Sheet", area)


def test_what_formulas_read_is_told_without_evaluating_them() -> None:
    from openpyxl import Workbook

    workbook = Workbook()
    sheet = workbook.active
    for row in range(2, 6):
        sheet[f"A{row}"], sheet[f"B{row}"] = row, f"=A{row}+SUM(C$2:C{row})+$E$1"
    sheet["F1"] = "=foo("
    asked = [Address.parse(a1, sheet.title) for a1 in ("A2", "A5", "A6", "C2", "C5", "C6", "D2", "E1", "F1")]
    assert {a.a1 for a in Contents(workbook).read(asked)} == {"A2", "A5", "C2", "C5", "E1"}
