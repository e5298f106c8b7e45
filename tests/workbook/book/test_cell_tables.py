"""Cells declared by tables in Markdown: what a row gives, what is refused, and that every table is used."""

import re
from pathlib import Path

import pytest

from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Book

PLACED = """
## points

> Points of {what}
> Where they lie.

`{what}_points`: Points of {what}

| kind | cell | label | symbol | unit | formula | scale |
|---|---|---|---|---|---|---|
| number | `k` | point | k | | | |
| calc | `x` | place | x | m | `=[k]*{step}` | size |
| calc | `y` | height | y | m | `=[x]+{more}` | 2 |

## by case

| case | low |
|---|---|
| short | `={from}` |
| long | `=2*{from}` |
"""
ROOT = Path(__file__).parents[3]
TABLE = """
# Cells

## results

| kind | cell | label | symbol | unit | formula | source | format |
|---|---|---|---|---|---|---|---|
| result | `@force` | Force at {place} | F | N | `={mass}*@a` | \\|F\\| of the load | |
| check | `@ok` | It holds | | | `@force<={most}` | F ≤ F_max | |
| constant | `k` | row | k | | | | `0` |
| entry | `rate` | Rate | N | 1/min | `master.rate` | | |
| calc | `braces` | Sum | | | `=SUM({{1,2}})` | | |
"""


@pytest.fixture
def cell(tmp_path):
    """The table of a module of its own."""
    (tmp_path / "module.md").write_text(TABLE, encoding="utf-8")
    return cell_tables(str(tmp_path / "module.py"))["results"]


def test_a_row_gives_a_cell_its_words_and_python_its_value(cell):
    made = cell("@force", 3.0, place="the cam", mass="@m", scale=5.0)
    assert made[:5] == ("@force", "Force at the cam", "F", "N", "result")
    assert (made.formula, made.value, made.source, made.scale) == ("=@m*@a", 3.0, "|F| of the load", 5.0)


def test_a_check_says_ok_or_fail(cell):
    made = cell("@ok", False, most="@most", says='"too much"')
    assert (made.formula, made.value, made.says) == ('=IF(@force<=@most,"OK","FAIL")', "FAIL", '"too much"')


def test_braces_of_a_formula_are_written_twice(cell):
    assert cell("braces", 3.0).formula == "=SUM({1,2})"


def test_an_entry_has_the_value_of_the_description_and_its_place(cell):
    class Master:
        rate = 30.0

    class Machine:
        master = Master

    made = cell.entries(Machine, "machine")("rate")
    assert (made.role, made.value, made.key, made.format) == ("input", 30.0, "machine.master.rate", "0.0##")


@pytest.mark.parametrize("parts", [{"place": "x"}, {"place": "x", "mass": "m", "mas": "m"}, {}])
def test_a_missing_part_and_one_that_no_text_has_are_named(cell, parts):
    with pytest.raises(TypeError, match=r"@force: given .*; expected \['mass', 'place'\]"):
        cell("@force", 1.0, **parts)


def test_a_cell_that_no_row_has_is_refused(cell):
    with pytest.raises(KeyError, match="@weight"):
        cell("@weight", 1.0)


@pytest.fixture
def placed(tmp_path):
    """The module of a table that is placed, and of formulas by row."""
    (tmp_path / "placed.md").write_text(PLACED, encoding="utf-8")
    return str(tmp_path / "placed.py")


def test_a_table_is_placed_under_its_name_as_long_as_its_columns_and_counts_its_rows(placed):
    book = Book("any", "Any")
    sheet = book.sheet("Sheet", "")
    cell = cell_tables(placed)["points"].sharing(what="cam", step="0.5", size=3.0)
    cell.begin(sheet)
    block = cell.place(sheet, cell("x", [0.5, 1.0]), cell("y", 1.0, more="1"))
    assert (block.name, block.title, block.size) == ("cam_points", "Points of cam", 2)
    assert [(q.name, q.value, q.scale) for q in block.quantities] == [
        ("k", [1, 2], 0.0), ("x", [0.5, 1.0], 3.0), ("y", 1.0, 2.0),
    ]  # fmt: skip
    assert [text.text for text in sheet.texts[:2]] == ["Points of cam", "Where they lie."]


def test_what_rows_share_gives_way_to_what_one_is_given(placed):
    cell = cell_tables(placed)["points"].sharing(step="0.5", size=3.0)
    assert cell("x", 1.0, step="2").formula == "=[k]*2"
    with pytest.raises(TypeError, match=r"y: given \[\]; expected \['more'\]"):
        cell("y", 1.0)


def test_formulas_by_row_are_the_columns_of_their_table(placed):
    formulas = formulas_by_row(placed, "by case", **{"from": "@low"})
    assert formulas == {"case": ["short", "long"], "low": ["=@low", "=2*@low"]}
    assert list(cell_tables(placed)) == ["points"]


MODULES = sorted(
    path for path in (ROOT / "workbook").rglob("*.py") if "CELLS = cell_tables(__file__)" in path.read_text("utf-8")
)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.relative_to(ROOT / "workbook").as_posix())
def test_every_table_is_used_by_its_module(path):
    used = re.findall(r'CELLS\[f?"([^"]+)"\]', path.read_text("utf-8"))
    titles = "|".join(re.sub(r"\{.*?\}", ".+", name) for name in used)
    assert [title for title in cell_tables(str(path)) if not re.fullmatch(titles, title)] == []
