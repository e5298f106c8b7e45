"""The functions by which a rate and a lift get into their cells and back, as docs/architecture.md counts them."""

import re
import sys
from itertools import chain
from pathlib import Path
from traceback import walk_stack

import pytest
import tomli_w

from tests import cutting
from workbook.build import read_entered, write_book
from workbook.entries.design import as_entered
from workbook.reading.descriptions import read_machine

PAGE = Path(__file__).parents[2] / "docs/architecture.md"
FUNCTION = re.compile(r"`([\w.]+)`")
ENTRIES = {"rate": ("timing_rate", ("master", "rate")), "lift": ("lift", ("axes", "0", "phases", "0", "lift"))}
PLACES = {
    "machine_or_faults": lambda at, _: True,
    "by_rate_or_length": lambda at, entry: entry[0] == "timing_rate",
    "CellTable.__call__": lambda at, entry: (at["name"], at["self"][at["name"]].kind) == (entry[0], "given"),
    "Cells.put": lambda at, entry: at["content"] == entry[2],
    "Entries._entered": lambda at, entry: at["q"].name == entry[0],
    "put": lambda at, entry: at["path"] == entry[1],
}
"""functions in which an entry takes another form, each with whether it does: by its arguments and the entry"""
ASIDE = {("read_entered", "_declare_empty"), ("read_entered", "declare")}
"""what declares a book while one is read: of its layout, and of what should stand in it"""


def rows_of_the_way(column):
    """Return the functions of the rate (1) or the lift (2), there and back, as the page names and counts them."""
    way = PAGE.read_text(encoding="utf-8").split("## The way of an entry")[1].split("\n## ")[0]
    rows = [row.split("|")[1:-1] for row in re.findall(r"^\|.*\|$", way, re.MULTILINE)][2:]
    names = [[n for n in FUNCTION.findall(cells[1] + cells[1 + column]) if not n.endswith(".py")] for cells in rows]
    back = next(k for k, row in enumerate(names) if "read_entered" in row)
    counts = [int(number) for number in re.findall(r"\*\*(\d+)\*\*", way)]
    return [*chain(*names[:back])], [*chain(*names[back:])], [counts[column - 1], counts[column + 1]]


def functions_on_the_way(run, entry):
    """Return the functions of the product that are at work where the entry takes another form, in their order."""
    ours, way = str(PAGE.parents[1] / "workbook"), {}

    def look(frame, event, _):
        takes = PLACES.get(frame.f_code.co_qualname) if event == "call" else None
        if takes and takes(frame.f_locals, entry):
            codes = [caller.f_code for caller, _ in walk_stack(frame)][::-1]
            own = [code for code in codes if code.co_filename.startswith(ours) and not code.co_name.startswith("<")]
            if ASIDE.isdisjoint((own[0].co_name, code.co_name) for code in own):
                way.update(dict.fromkeys(own))

    sys.setprofile(look)
    try:
        run()
    finally:
        sys.setprofile(None)
    return [code.co_name for code in way]


@pytest.mark.parametrize("column", [1, 2], ids=ENTRIES)
def test_the_way_of_an_entry_goes_through_these_functions_and_they_are_so_many(column, tmp_path):
    there, back, counts = rows_of_the_way(column)
    description, book, data = tmp_path / "machine.toml", tmp_path / "book.xlsx", as_entered(cutting.small())
    entry = [*ENTRIES.values()][column - 1]
    entry = (*entry, data["master"]["rate"] if column == 1 else data["axes"][0]["phases"][0]["lift"])
    description.write_text(tomli_w.dumps(data), encoding="utf-8")
    for run, named in (
        (lambda: write_book(read_machine(description), book), there),
        (lambda: read_entered(book), back),
    ):
        assert functions_on_the_way(run, entry) == [n.split(".")[-1] for n in named if n != "AxisPhase"]
    assert [len(there), len(back)] == counts
