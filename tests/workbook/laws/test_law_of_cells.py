"""The law of the cells on the sheets of laws: short formulas, few functions deep, few columns."""

import re
from pathlib import Path

import pytest

from tests.workbook.cells import opened
from workbook.machines.laws.template import TEMPLATE
from workbook.reading.descriptions import read_machine

LONGEST, DEEPEST, WIDEST = 200, 4, 40
"""characters of a formula, functions within each other, columns of a sheet"""
ENTRIES = re.compile(r"(_entries|_says|\.entries)$")
"""checks of entries, the columns that mark them, sentences of checks: workbook/book/limits.py and sentence.py"""
FUNCTION = re.compile(r'"[^"]*"|[A-Z][A-Z0-9]*\(|\(|\)')


@pytest.fixture(scope="module")
def book():
    return TEMPLATE.declare(read_machine(Path("templates/motion-laws.toml")))


@pytest.fixture(scope="module")
def cells(book):
    """The formulas of the sheets of laws as the file has them, by their quantities' names."""
    written = opened(book, TEMPLATE.model)
    found = {}
    for cell in book.cells():
        text = written[cell.block.sheet.title].cell(cell.row, cell.column).value
        if isinstance(text, str) and text.startswith("="):
            name = f"{cell.block.name}.{cell.quantity.name}"
            found.setdefault(name, []).append(text)
    return found


def depth(formula):
    """How many functions of a formula are within each other, at most."""
    deepest, open_ = 0, []
    for part in FUNCTION.findall(formula):
        if part == ")":
            open_.pop()
        elif part.endswith("("):
            open_.append(part != "(")
            deepest = max(deepest, sum(open_))
    return deepest


def ruled(cells):
    return {name: texts for name, texts in cells.items() if not ENTRIES.search(name)}


def test_formulas_are_short(cells):
    long = {name: max(map(len, texts)) for name, texts in ruled(cells).items() if max(map(len, texts)) > LONGEST}
    assert long == {}


def test_formulas_nest_few_functions(cells):
    deep = {name: max(map(depth, texts)) for name, texts in ruled(cells).items() if max(map(depth, texts)) > DEEPEST}
    assert deep == {}


def test_most_formulas_are_very_short(cells):
    lengths = sorted(len(text) for texts in ruled(cells).values() for text in texts)
    assert lengths[len(lengths) // 2] <= 60
    assert lengths[int(0.95 * len(lengths))] <= 130


def test_sheets_are_narrow(book):
    written = opened(book, TEMPLATE.model)
    wide = {sheet.title: sheet.max_column for sheet in written if sheet.max_column > WIDEST}
    assert wide == {}


def test_depth_counts_functions_and_no_brackets_of_sums():
    assert depth('=IF(([a]+(1))>0,MAX(0,"IF(("),SUM(ABS(1)))') == 3
