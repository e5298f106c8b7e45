"""A formula that an engineer entered counts where two evaluators agree on it, and the saved value with them."""

import re
from pathlib import Path

import openpyxl
import pytest
from openpyxl.worksheet.formula import ArrayFormula

from tests.workbook.reading.fuzz import pack, unpack, without_charts
from workbook.book.address import Address
from workbook.errors import DisputedError, WitnessError
from workbook.reading.files import BookFile, open_book
from workbook.witnesses import agreement as module
from workbook.witnesses.agreement import agreed_values, needs_intersection
from workbook.witnesses.witness import CYCLE

CELL = Address("Timing", 1, 1)
COMMANDS = [["inputs", "book.xlsx"], ["verify", "book.xlsx"], ["regenerate", "book.xlsx", "-o", "new.xlsx"]]


def witness(value, kept=False, version="1"):
    """A witness that says one thing; WitnessError where that is one."""

    class Told:
        asked = 0

        def version(self):
            return version

        def values(self, file):
            Told.asked += 1
            if isinstance(value, WitnessError):
                raise value
            return {CELL: value}

    Told.kept = kept
    return Told


def asked(monkeypatch, *witnesses, saved=None):
    """The value that witnesses and a saved value agree on."""
    named = {f"w{i}": each for i, each in enumerate(witnesses)}
    monkeypatch.setattr(module, "WITNESSES", named)
    return agreed_values(BookFile(Path("book.xlsx"), openpyxl.Workbook(), {}, saved={CELL: saved}), names=named)(CELL)


FAILED = WitnessError("cannot")
AGREED = {
    "two": ([1300, 1300.0], None, 1300),
    "two but for rounding": ([0.3, 0.1 + 0.2], None, 0.3),
    "zero but for rounding": ([0, 5.6e-17], None, 0),
    "two texts": (["MTP", "MTP"], None, "MTP"),
    "two and the saved value": ([1300, 1300], 1300.0, 1300),
    "the third where the first knows no such function": (["#NAME?", 5, 5], None, 5),
    "the third where the second fails": ([5, FAILED, 5], None, 5),
    "the third where the second has no value": ([5, None, 5], None, 5),
    "two on an error": (["#DIV/0!", "#DIV/0!", 5], None, "#DIV/0!"),
    "others where the first two know no such function": (["#NAME?", "#NAME?", 5, 5], None, 5),
}


@pytest.mark.parametrize(("values", "saved", "value"), AGREED.values(), ids=AGREED.keys())
def test_a_value_is_agreed(values, saved, value, monkeypatch):
    assert asked(monkeypatch, *map(witness, values), saved=saved) == value


DISPUTED = {
    "two": ([500, 1300], None, "w0 has 500, w1 has 1300"),
    "the saved value": ([1300, 1300], 500.0, "the file as it was saved has 500"),
    "an error saved": ([1, 1], "#NUM!", "the file as it was saved has '#NUM!'"),
    "a truth value and a number": ([True, 1], None, "w0 has TRUE, w1 has 1"),
    "a text and a number": (["1", 1], None, "w0 has '1', w1 has 1"),
    "only one": ([5], None, "w0 has 5"),
    "only one, and a saved value": ([5, FAILED], 5, "w0 has 5"),
    "one, and errors": ([5, "#NAME?", "#VALUE!"], None, "w1 has '#NAME?'"),
    "a value and an error": ([5, "#NUM!", 5], None, "w1 has '#NUM!'"),
    "an error and a value": (["#DIV/0!", 5, 5], None, "w0 has '#DIV/0!'"),
    "none": ([FAILED, FAILED], None, "cannot be computed"),
    "different errors": (["#NAME?", "#VALUE!"], None, "cannot be computed"),
    "infinite": ([1e308, -1e308], None, "w1 has -1e+308"),
}


@pytest.mark.parametrize(("values", "saved", "says"), DISPUTED.values(), ids=DISPUTED.keys())
def test_a_value_is_disputed(values, saved, says, monkeypatch):
    with pytest.raises(DisputedError, match=re.escape(says)):
        asked(monkeypatch, *map(witness, values), saved=saved)


@pytest.mark.parametrize("first", [CYCLE, None, 5])
def test_a_cell_that_computes_from_itself_is_in_doubt_and_no_one_else_is_asked(first, monkeypatch):
    told = [witness(first), witness(CYCLE), witness(5)]
    with pytest.raises(DisputedError, match="computes from itself"):
        asked(monkeypatch, *told, saved=5)
    assert told[2].asked == 0
    assert told[1].asked == (first != CYCLE)


def test_witnesses_that_keep_values_or_are_absent_are_not_asked(monkeypatch):
    kept, absent, third = witness(7, kept=True), witness(8, version=None), witness(9)
    assert asked(monkeypatch, kept, witness(5), absent, witness(5), third) == 5
    assert kept.asked == absent.asked == third.asked == 0


def entered(own, formula="=A1+4", count=39):
    """A file of formulas entered in a sheet, beside an own formula in another; and the cells of the former."""
    workbook = openpyxl.Workbook()
    page = workbook.active
    page["A1"] = "=1"
    workbook.create_sheet("Own")["A1"] = own
    cells = [Address(page.title, row, 2) for row in range(1, count + 1)]
    for cell in cells:
        page[cell.a1] = formula
    return BookFile(Path("book.xlsx"), workbook, {}), cells


def picky(refused):
    """A witness that cannot open a file in which a formula cell is refused."""

    class Picky(witness(5)):
        def values(self, file):
            formulas = file.contents.formula_cells
            super().values(file)
            if refused(formulas):
                raise FAILED
            return dict.fromkeys(formulas, 5)

    return Picky


OWN = Address("Own", 1, 1)
OPENED = {
    "what was entered": (lambda cells: OWN in cells, "=A1+4", 1),
    "what was entered, and then each by itself": (lambda cells: len(cells) > 2, "=A1+4", 4),
}


@pytest.mark.parametrize(("refused", "formula", "files"), OPENED.values(), ids=OPENED.keys())
def test_a_witness_is_given_few_files_of_what_was_entered(refused, formula, files, monkeypatch):
    file, cells = entered("=LET(x,1,x)", formula, 3)
    named = {"picky": picky(refused), "other": picky(refused)}
    monkeypatch.setattr(module, "WITNESSES", named)
    value = agreed_values(file, cells, names=named)
    assert [value(cell) for cell in cells] == [5] * len(cells)
    assert [one.__mro__[1].asked for one in named.values()] == [files, files]


@pytest.mark.parametrize("formula", ['INDIRECT("Own!A1")', "OFFSET(Own!B2,-1,-1)", "OFFSET(Own!A2,-1,0)+0*SHEET()"])
@pytest.mark.sample(1)
def test_cells_that_a_formula_does_not_name_are_there_when_it_is_computed(formula, tmp_path):
    file, cells = entered("=3+4", f"={formula}", 1)
    for path in (tmp_path / "book.xlsx", tmp_path / "gone.xlsx"):
        said = agreed_values(BookFile(path, file.workbook, {}, saved={cells[0]: 8.0}), cells)
        if path.stem == "book":
            file.workbook.save(path)
        with pytest.raises(DisputedError) as doubt:
            said(cells[0])
        assert "has 0" not in str(doubt.value)


RANGES = {
    "Mine!C1:C3": True, "-A1:A3": True, "(A1:A3)": True, "$A:$A": True, "A1:A3*2": True, "SUM(A1:A3*B1:B3)": True,
    "SUM((A1:A3)>1)": True, "MAX(IF(A1:A3>1,2,3))": True, "SUM(-Mine!A1:A3)": True, "IF(TRUE,A1:A3^2)": True,
    "A1": False, "A1:A1*2": False, "SUM(A1:A3)": False, "SUM(A1:A3)*2": False, "SUM(A:A)": False,
    "SUMPRODUCT(A1:A3*B1:B3)": False, "SUMPRODUCT((A1:A3>1)*(B1:B3))": False, "INDEX(A1:B3,2,1)^2": False,
    'IF(A1>1,SUM(A1:A3),"A1:A3")': False, "SUM({1,2}*{3,4})": False, "COUNTIF(A1:A3,\">1\")": False,
    "MATCH(1,A1:A3,0)+ROW(A1:A1)": False,
}  # fmt: skip


@pytest.mark.parametrize(("formula", "spread"), RANGES.items())
def test_ranges_of_which_excel_takes_one_cell(formula, spread):
    assert needs_intersection(f"={formula}") is spread


@pytest.mark.parametrize("formula", ["A1:A3", "SUM(A1:A3*A1:A3)", "B1+1"])
def test_such_a_range_is_a_doubt_unless_the_file_was_saved_with_its_value(formula):
    workbook = openpyxl.Workbook()
    page = workbook.active
    for row in (1, 2, 3):
        page.cell(row, 1).value = row
    page["B1"], page["C9"] = "=SUM(A1:A3*A1:A3)", f"={formula}"
    at = Address(page.title, 9, 3)
    with pytest.raises(DisputedError, match="takes one cell of it"):
        agreed_values(BookFile(Path("book.xlsx"), workbook, {}))(at)
    page["B1"], page["C9"] = None, ArrayFormula("C9", "=SUM(A1:A3*A1:A3)")
    said = agreed_values(BookFile(Path("book.xlsx"), workbook, {}), names=("pycel",))
    with pytest.raises(DisputedError, match="pycel has 14"):
        said(at)


# as a command


@pytest.fixture(scope="module")
def slim(press):
    """The bytes of a small book without charts."""
    return without_charts(press.path.read_bytes())


@pytest.fixture
def book(tmp_path, slim, monkeypatch):
    """Enter a formula as the rate, with a saved value or without."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "book.xlsx"

    def entered(formula, saved=""):
        path.write_bytes(slim)
        place = open_book(path).places["timing_rate"]
        number = openpyxl.load_workbook(path, read_only=True).sheetnames.index(place.sheet) + 1
        sheet, cell = f"xl/worksheets/sheet{number}.xml", place.cell(0, 0)
        rule = rf'(<c r="{cell.a1}"[^>]*>).*?</c>'.encode()
        new = rb"\1<f>%s</f>%s</c>" % (formula.encode(), saved.encode())
        parts = [(name, re.sub(rule, new, data) if name == sheet else data) for name, data in unpack(slim)]
        path.write_bytes(pack(parts))
        return str(cell)

    return entered


@pytest.mark.parametrize("saved", ["", "<v>120</v>"])
@pytest.mark.parametrize("command", COMMANDS, ids=lambda c: c[0])
def test_a_formula_beyond_doubt_is_taken_alike(command, saved, book, motionbook):
    book("-20^2-280", saved)
    code, said, errors = motionbook(*command)
    assert code == 0, errors
    assert "rate = 120.0" in said or command[0] != "inputs"


@pytest.mark.parametrize(
    ("formula", "saved", "says"),
    [
        ("-20^2-200", "<v>-600</v>", "the file as it was saved has -600"),
        ("200+0*NOSUCH(1)", "<v>200</v>", "the file as it was saved has 200"),
        ("RAND()+200", "", "formulon has 200."),
    ],
)
@pytest.mark.parametrize("command", COMMANDS, ids=lambda c: c[0])
@pytest.mark.sample(2)
def test_a_formula_in_doubt_is_refused_alike(command, formula, saved, says, book, motionbook, tmp_path):
    cell = book(formula, saved)
    code, out, said = motionbook(*command)
    assert (code, out) == (2, "")
    (line,) = said.splitlines()
    assert line.startswith(f"book.xlsx: {cell} (")
    assert says in line
    assert [path.name for path in tmp_path.iterdir()] == ["book.xlsx"]
