"""The law of the cells on the sheets of overlap and flying cutter: short formulas, few columns, one a column."""

import re

import pytest

from workbook.judging.matching import is_formula
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

LONGEST, DEEPEST, WIDEST = 200, 4, 40
BOOKS = {
    "indexing-overlap": ("indexing-overlap", r"Overlap|Picture|Cycle|Inverse"),
    "indexing-overlap-stations": ("indexing-overlap", r"Overlap|Tool \d|Picture|Cycle \d|Inverse"),
    "flying-cutter": ("flying-cutter", r"Cutter|Lengths|Cycle|Drive|Ratios"),
    "flying-cutter-saw": ("flying-cutter", r"Cutter|Lengths|Cycle|Drive|Ratios"),
}
ELSEWHERE = re.compile(r"\w+_(entries|says)|jump")
"""limits of entries, and sentences: they belong to workbook/book, and to workbook/motion"""


def blocks_of(book):
    """The blocks of the book's own sheets, and their quantities' cells."""
    template, sheets = BOOKS[book]
    found = TEMPLATES[template].declare(read_machine(FOLDER / f"{book}.toml")).blocks.values()
    return [block for block in found if re.fullmatch(sheets, block.sheet.title)]


def formulas_of(book):
    cells = (cell for block in blocks_of(book) for cell in block.cells())
    return [cell for cell in cells if is_formula(cell.content) and not ELSEWHERE.fullmatch(cell.quantity.name)]


def depth(formula):
    """How deep its functions stand within each other; brackets without a function's name count for nothing."""
    deepest, stack = 0, []
    for i, sign in enumerate(formula):
        if sign == "(":
            stack.append(bool(re.match(r"[A-Z0-9]", formula[i - 1])))
            deepest = max(deepest, sum(stack))
        elif sign == ")":
            stack.pop()
    return deepest


@pytest.fixture(scope="module", params=BOOKS)
def book(request):
    return request.param


def test_no_formula_is_longer_than_a_line_or_two(book):
    found = formulas_of(book)
    assert [(c.block.name, c.quantity.name, len(c.content)) for c in found if len(c.content) > LONGEST] == []
    lengths = sorted(len(cell.content) for cell in found)
    assert lengths[len(lengths) // 2] <= 60
    assert lengths[len(lengths) * 19 // 20] <= 130


def test_no_formula_nests_deeper_than_four_functions(book):
    assert {c.quantity.name for c in formulas_of(book) if depth(c.content) > DEEPEST} == set()


def test_no_table_is_wider_than_forty_columns(book):
    widths = {block.name: max(block.columns.values()) for block in blocks_of(book)}
    assert {name: width for name, width in widths.items() if width > WIDEST} == {}


def test_numbers_are_as_a_person_writes_them(book):
    odd = re.compile(r"\d{9,}|\d[eE]-?\d|\d\.0(?!\d)")
    assert {c.quantity.name for c in formulas_of(book) if odd.search(c.content)} == set()


def test_the_measure_of_depth():
    assert depth("=IF(A1>0,MAX(B1,ABS(C1)),(1+(2+(3+4))))") == 3
