"""What a new book holds before any program has computed it: each formula's value, and the numbers of its charts."""

import math
import re
import zipfile
from collections import Counter
from html import unescape
from xml.etree import ElementTree

import numpy as np
import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from workbook.build import build, committed_descriptions
from workbook.functions import publish
from workbook.functions.page import EXAMPLE, declare
from workbook.judging.comparison import TOLERANCE, ExpectedValues, difference
from workbook.judging.matching import Match, is_formula
from workbook.reading.descriptions import read_machine
from workbook.reading.files import open_book
from workbook.templates import TEMPLATES
from workbook.witnesses.registry import WITNESSES
from workbook.writing.archive import Cells, Strings, same_part, value_xml

CHART = "{http://schemas.openxmlformats.org/drawingml/2006/chart}"


@pytest.fixture(
    scope="module", params=[*committed_descriptions(), None], ids=lambda path: path.stem if path else "motion-functions"
)
def made(request, tmp_path_factory):
    """A committed book, made anew, and its declaration."""
    path = tmp_path_factory.mktemp("made") / "book.xlsx"
    if request.param is None:
        publish.write_book(path)
        return path, declare(EXAMPLE)
    machine = read_machine(request.param)
    build(machine, path)
    return path, TEMPLATES[machine.template].declare(machine)


@pytest.mark.sample(3)
def test_each_formula_is_saved_with_the_engines_value_to_the_last_digit(made):
    path, book = made
    sheets = {sheet.title: sheet for sheet in openpyxl.load_workbook(path, data_only=True).worksheets}
    formulas = [cell for cell in book.cells() if is_formula(cell.content) and cell.block.name != TO_BE_FOUND_OUT]
    saved = [sheets[cell.block.sheet.title].cell(cell.row, cell.column).value for cell in formulas]
    assert [(c.block.name, c.expected, s) for c, s in zip(formulas, saved, strict=True) if s != (c.expected or s)] == []
    assert Counter(map(kind, saved)) == Counter(kind(cell.expected) for cell in formulas)
    assert len(formulas) > 900


TO_BE_FOUND_OUT = "fn_works"
"""whether the functions compute: what is saved of that would be shown where they do not"""


def kind(value):
    """The type of a cell that holds a value; openpyxl reads an empty text as nothing."""
    return "number" if isinstance(value, int | float) and not isinstance(value, bool) else str(value or None)


OTHERS = ("libreoffice", "formulon")


def differing(path, book, witness):
    """The formula cells of a new book in which a witness does not compute what is saved."""
    file = open_book(path)
    saved, computed = WITNESSES["saved"]().values(file), WITNESSES[witness]().values(file)
    right = ExpectedValues(Match(file, book), book)
    assert len(saved) > 1000
    return [a for a in saved if not difference(computed[a], saved[a], right.peak(a)) <= TOLERANCE]


@pytest.mark.nightly
@pytest.mark.parametrize("witness", OTHERS)
@pytest.mark.parametrize("description", committed_descriptions(), ids=lambda path: path.stem)
def test_other_programs_compute_what_is_saved_in_each_committed_book(description, witness, tmp_path):
    machine = read_machine(description)
    build(machine, tmp_path / "book.xlsx")
    assert differing(tmp_path / "book.xlsx", TEMPLATES[machine.template].declare(machine), witness) == []


def parts(path, pattern):
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist() if re.fullmatch(pattern, name)}


def columns(book):
    """The values that a book declares, by range: of columns, and of the cells by which a diagram has its labels."""
    found = {}
    for cell in book.cells():
        if cell.block.name.startswith("axis"):
            column = get_column_letter(cell.column)
            found[f"'{cell.block.sheet.title}'!${column}${cell.row}"] = [cell.expected]
    for block in book.blocks.values():
        for quantity in block.quantities:
            name = f"[{block.name}.{quantity.name}]"
            found[book.range(name)] = book.values(name)
    return found


@pytest.mark.sample(6)
def test_each_range_of_a_chart_is_saved_with_its_numbers(made):
    path, book = made
    declared, count = columns(book), 0
    for part in parts(path, r"xl/charts/chart\d+\.xml").values():
        for reference in ElementTree.fromstring(part).iter(f"{CHART}numRef"):
            cache, values = reference.find(f"{CHART}numCache"), declared[unescape(reference.find(f"{CHART}f").text)]
            points = {int(p.get("idx")): float(p.find(f"{CHART}v").text) for p in cache.iter(f"{CHART}pt")}
            assert int(cache.find(f"{CHART}ptCount").get("val")) == len(values)
            assert points == dict(enumerate(values))
            count += 1
    assert count >= 14
    assert max(map(len, declared.values())) > 100


@pytest.mark.parametrize(
    ("value", "saved"),
    [
        (1, ("", "<v>1</v>")),
        (60.0, ("", "<v>60</v>")),
        (-0.0, ("", "<v>0</v>")),
        (0.1 + 0.2, ("", "<v>0.30000000000000004</v>")),
        (np.float64(1e-300), ("", "<v>1e-300</v>")),
        (np.int64(7), ("", "<v>7</v>")),
        (True, (' t="b"', "<v>1</v>")),
        (False, (' t="b"', "<v>0</v>")),
        ("", (' t="str"', "<v></v>")),
        ("OK", (' t="str"', "<v>OK</v>")),
        ("5", (' t="str"', "<v>5</v>")),
        (" <a> & 'b' ", (' t="str"', "<v xml:space=\"preserve\"> &lt;a&gt; &amp; 'b' </v>")),
        ("#DIV/0!", (' t="e"', "<v>#DIV/0!</v>")),
        ("#1 motor", (' t="str"', "<v>#1 motor</v>")),
        (None, ("", "")),
        (math.nan, ("", "")),
        (math.inf, ("", "")),
    ],
)
def test_values_by_type(value, saved):
    assert value_xml(value) == saved


def test_cells_come_in_their_order_whatever_the_order_in_which_they_are_put():
    cells = Cells(Strings())
    cells.put(3, 28, 2, "text")
    cells.put_formula(3, 2, 1, '=IF(A1<2,"&",1)', None)
    cells.put(2, 5, 0, None)
    cells.heights[3] = 44
    assert cells.within(b'<dimension ref="A1"/><sheetData/>').decode() == (
        '<dimension ref="B2:AB3"/>'
        '<sheetData><row r="2"><c r="E2" s="0"/></row><row r="3" ht="44" customHeight="1"><c r="B3" s="1">'
        '<f>IF(A1&lt;2,"&amp;",1)</f></c><c r="AB3" s="2" t="s"><v>0</v></c></row></sheetData>'
    )


@pytest.mark.parametrize("around", [b"<f>A1</f><v>%s</v>", b'<pt idx="3"><v>%s</v></pt>'])
def test_last_digits_of_saved_numbers_may_differ_from_machine_to_machine(around):
    assert same_part(around % b"0.30000000000000004", around % b"0.3")
    assert not same_part(around % b"0.30000001", around % b"0.3")
    assert not same_part(around % b"0.3", around.replace(b"A1", b"A2").replace(b'"3"', b'"4"') % b"0.3")
    assert not same_part(b"<c><v>0.3</v></c>", b"<c><v>0.30000000000000004</v></c>")
