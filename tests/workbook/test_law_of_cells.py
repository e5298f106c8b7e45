"""The law of the cells: each is a quantity, its formula short enough to be read at a glance."""

import re
from functools import cache
from pathlib import Path
from statistics import median, quantiles

import pytest
from openpyxl.utils import range_boundaries

from benchmarks.scale import of_axes
from tests.workbook.cells import opened
from tests.workbook.machines.test_machine_drives import BENT, SHORT, linked, small, some_mechanism
from workbook.build import committed_descriptions
from workbook.judging.matching import is_formula
from workbook.judging.structure import ALLOWED
from workbook.machines.machine.mechanism import LINKED
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

LONGEST, MOST, HALF = 200, 135, 60
"""characters of any formula, of 95 % of a book's formulas and of half of them"""
DEEPEST, WIDEST, STEPS, LONG = 4, 40, 8, 40
"""functions within each other, columns of a sheet, precedents from a result to an entry, rows of a long table"""
LISTS = ("pieces", "checks", "switch_lanes", "stamp")
"""pieces of all laws from their sheets, all checks, corners of switches' lanes from their times, sums of entries"""
CALL = re.compile(r'"[^"]*"|([A-Z][A-Z0-9]*)\(|[()]')
NUMBER = re.compile(r"(?<![\w.$])\d+\.?\d*(?:[eE][+-]?\d+)?(?![\w.$(])")
PLAIN = re.compile(r"\d{1,6}(\.\d{1,6})?|1E[+-]?\d+|10{9}", re.I)
"""numbers as a person writes them, and powers of ten; sentences tell amounts up to 1E9, spelt out for auditors"""
REFERENCE = re.compile(r"(?:('[^']+'|[A-Za-z_]\w*)!)?(\$?[A-Z]{1,3}\$?\d+(?::\$?[A-Z]{1,3}\$?\d+)?)(?![\w(])")
TEXT = re.compile(r'"[^"]*"')
LINKAGES = {kind: some_mechanism(kind).model_dump() for kind in LINKED} | {"table": BENT}
BOOKS = {path.stem: path for path in committed_descriptions()} | {"12 axes": 12} | LINKAGES
"""committed descriptions; machines of so many axes with drives; one with each mechanism of a changing ratio"""


@cache
def machine(name):
    """The machine of one of the books."""
    given = BOOKS[name]
    if isinstance(given, Path):
        return read_machine(given)
    return of_axes(given) if isinstance(given, int) else small(linked(*SHORT, mechanism=given), cycle=360, positions=8)


@cache
def declared(name):
    """The book of a machine."""
    return TEMPLATES[machine(name).template].declare(machine(name))


@cache
def written(name):
    """The book of a machine, as openpyxl reads it."""
    return opened(declared(name), TEMPLATES[machine(name).template].model)


def called(cell):
    """The name of a cell's table and column, without the numbers of axes, drives and rows."""
    return re.sub(r"\d+", "#", f"{cell.block.name}.{cell.quantity.name}")


def formulas(name):
    """The formulas of a book by the names of their columns."""
    found = {}
    for cell in declared(name).cells():
        if is_formula(cell.content):
            found.setdefault(called(cell), []).append(cell.content)
    return found


def depth(formula):
    """How many functions of a formula are within each other, at most."""
    deepest, stack = 0, []
    for found in CALL.finditer(formula):
        if found[0] == ")":
            stack.pop()
        elif found[0].endswith("("):
            stack.append(bool(found[1]))
            deepest = max(deepest, sum(stack))
    return deepest


@pytest.mark.parametrize("name", BOOKS)
@pytest.mark.sample(10)
def test_formulas_are_read_at_a_glance_and_use_functions_that_every_program_has(name):
    found = formulas(name)
    assert {called: len(max(texts, key=len)) for called, texts in found.items() if max(map(len, texts)) > LONGEST} == {}
    assert {called: d for called, texts in found.items() if (d := max(map(depth, texts))) > DEEPEST} == {}
    lengths = [len(text) for texts in found.values() for text in texts]
    assert median(lengths) <= HALF
    assert quantiles(lengths, n=20)[-1] <= MOST
    used = {called: set(CALL.findall(" ".join(texts))) - ALLOWED - {""} for called, texts in found.items()}
    assert {called: others for called, others in used.items() if others} == {}
    bare = {(called, REFERENCE.sub("", TEXT.sub("", text))) for called, texts in found.items() for text in texts}
    numbers = {(called, number) for called, text in bare for number in NUMBER.findall(text)}
    assert [one for one in numbers if not PLAIN.fullmatch(one[1])] == []


@pytest.mark.parametrize("name", BOOKS)
def test_no_sheet_is_wide_and_a_column_of_a_long_table_has_one_formula(name):
    """Rows of samples, points and pairs differ by their references alone; lists gather what stands elsewhere."""
    used = {}
    for cell in declared(name).cells():
        used.setdefault(cell.block.sheet.title, set()).add(cell.column)
    assert {title: len(columns) for title, columns in used.items() if len(columns) > WIDEST} == {}
    long = [b for b in declared(name).blocks.values() if b.size >= LONG and b.name not in LISTS]
    columns = {(b.name, column[0].quantity.name): column for b in long for column in b.by_column()}
    forms = {
        at: {re.sub(r"\d+", "#", c.content) for c in cells if is_formula(c.content)} for at, cells in columns.items()
    }
    assert {at: sorted(found) for at, found in forms.items() if len(found) > 1} == {}


@cache
def cells_of(name):
    """The declared cells of a book by their places."""
    return {(c.block.sheet.title, c.row, c.column): c for c in declared(name).cells()}


@cache
def named(name):
    """The defined names of a book as a pattern, and what each stands for."""
    names = {one: defined.attr_text for one, defined in written(name).defined_names.items()}
    either = "|".join(re.escape(one) for one in sorted(names, key=len, reverse=True))
    return re.compile(rf"(?<![\w!'])(?:{either})(?![\w(!])"), names


@cache
def precedents(name, at):
    """The cells that a formula refers to, of a range the first; names are the places that they stand for."""
    title, row, column = at
    pattern, names = named(name)
    text = TEXT.sub("", str(written(name)[title].cell(row, column).value))
    text = pattern.sub(lambda found: names[found[0]], text)
    return [
        ((found[1] or title).strip("'"), *reversed(range_boundaries(found[2].replace("$", ""))[:2]))
        for found in REFERENCE.finditer(text)
    ]


def way(name, start):
    """The shortest way from a place to an entry, as cells; the place alone where its formula refers to nothing."""
    held, ways, seen = cells_of(name), [[start]], {start}
    while ways:
        one = ways.pop(0)
        before = [at for at in precedents(name, one[-1]) if at in held]
        if held[one[-1]].quantity.role == "input" or (one == [start] and not before):
            return [held[at] for at in one]
        ways += [[*one, at] for at in dict.fromkeys(before) if at not in seen]
        seen.update(before)
    raise AssertionError(f"{start} leads to no entry")


@pytest.mark.parametrize("name", ["machine", "cutting-machine", "machine-linkages"])
def test_from_the_rms_torque_to_an_entry_it_is_not_far(name):
    first = next(iter(declared(name).blocks["drive1_rms"].cells()))
    steps = way(name, (first.block.sheet.title, first.row, first.column))
    print("\n  ← ".join([name, *(f"{c.block.sheet.title}: {c.quantity.label}" for c in steps)]))
    assert steps[-1].quantity.role == "input"
    assert all(c.quantity.label for c in steps)
    assert len(steps) - 1 <= STEPS


@pytest.mark.parametrize(
    "name", ["machine", "cutting-machine", "flying-cutter", "indexing-overlap", "machine-linkages"]
)
def test_from_any_result_on_the_summary_to_an_entry_it_is_not_far(name):
    summary = declared(name).sheets[0].title
    starts = [at for at, cell in cells_of(name).items() if at[0] == summary and is_formula(cell.content)]
    ways = {at: way(name, at) for at in starts}
    assert {at: len(steps) - 1 for at, steps in ways.items() if len(steps) - 1 > STEPS} == {}
    assert [at for at, steps in ways.items() if not all(cell.quantity.label for cell in steps)] == []
