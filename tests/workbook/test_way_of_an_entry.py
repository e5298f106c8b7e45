"""The functions by which a rate and a lift get into their cells and back, as docs/architecture.md counts them."""

import re
import sys
from pathlib import Path

import tomli_w

from tests import cutting
from workbook.build import read_description, read_entered, write_book
from workbook.entries.design import as_entered

PAGE = Path(__file__).parents[2] / "docs/architecture.md"
FUNCTION = re.compile(r"`([\w.]+)`")


def rows_of_the_way():
    """Return of each row the names of functions of all entries, of the rate and of the lift; files are left out."""
    way = PAGE.read_text(encoding="utf-8").split("## The way of an entry")[1].split("\n## ")[0]
    rows = [row.split("|")[1:-1] for row in re.findall(r"^\|.*\|$", way, re.MULTILINE)][2:]
    return way, [[[n for n in FUNCTION.findall(c) if not n.endswith(".py")] for c in cells[1:]] for cells in rows]


def test_each_function_of_the_way_is_called_and_they_are_so_many(tmp_path):
    way, rows = rows_of_the_way()
    description, book, called = tmp_path / "machine.toml", tmp_path / "book.xlsx", set()
    description.write_text(tomli_w.dumps(as_entered(cutting.small())), encoding="utf-8")
    sys.setprofile(lambda frame, event, _: called.add(frame.f_code.co_name) if event == "call" else None)
    try:
        write_book(read_description(description), book)
        read_entered(book)
    finally:
        sys.setprofile(None)
    named = {name.split(".")[-1] for row in rows for cell in row for name in cell}
    assert named - called == {"AxisPhase"}  # pydantic makes it
    back = next(k for k, row in enumerate(rows) if "read_entered" in row[0])
    counts = [sum(len(row[0]) + len(row[of]) for row in part) for part in (rows[:back], rows[back:]) for of in (1, 2)]
    assert counts == [int(number) for number in re.findall(r"\*\*(\d+)\*\*", way)]
