"""What an edit leaves as it is comes from the latest book; every cell is then as in a book that is declared anew."""

import pytest

from tests import cutting
from workbook.machines.machine import template
from workbook.memo import enable_memo
from workbook.reading.descriptions import write_machine
from workbook.serve.live import design
from workbook.serve.tables import edited

TEXT = write_machine(cutting.small(cycle=12, law=4))
DRIVE = ("axes", "0", "motor", "inertia")
EDITS = [
    [(("axes", "1", "phases", "0", "stop"), 130.0)],
    [(("axes", "0", "phases", "0", "law"), "CIC")],
    [(DRIVE, 3.5)],
    [(("axes", "2", "shift"), 20.0)],
    [(("master", "rate"), 150.0)],
    [(("axes", "0", "name"), "Feed")],
    [(("title",), "Another")],
    [(("laws", "TVP"), {"rise_end": 0.2, "fall_start": 0.7})],
    [(("switches",), [{"name": "Valve", "on": [{"start": 5.0, "stop": 90.0}]}])],
    [(("axes", "2"), None)],
    [(("sizes", "cycle"), 18)],
]


def cells(text):
    """All that a book shows: texts, contents, the engine's values, names, checks, charts."""
    design.cache_clear()
    book = design("a.toml", text).book
    named = [(cell.block.name, cell.block.sheet.title, cell.row, cell.column, cell.content, str(cell.expected))
             for cell in book.cells()]  # fmt: skip
    sheets = [(one.title, one.texts, one.charts, one.print_rows, one.print_columns, one.widths) for one in book.sheets]
    return named, sheets, [(sheet.title, q.name) for sheet, q in book.checks], book.column_names, list(book.names())


@pytest.fixture
def remembering():
    enable_memo(48)
    yield
    enable_memo(0)
    design.cache_clear()


def test_a_book_after_an_edit_is_the_one_that_is_declared_anew(remembering):
    cells(TEXT)
    for changes in [*EDITS, []]:
        text = edited(TEXT, changes)
        enable_memo(48)
        once, again = cells(text), cells(text)
        enable_memo(0)
        anew = cells(text)
        assert once == anew, changes
        assert again == anew, changes


def test_what_an_edit_leaves_is_not_worked_out_again(remembering, monkeypatch):
    worked_out = []

    def spy(kind, number):
        made = kind.__init__

        def spied(self, *given):
            worked_out.append((kind.__name__, number(*given)))
            made(self, *given)

        monkeypatch.setattr(kind, "__init__", spied)

    spy(template.BookLaws, lambda *_: 0)
    spy(template.AxisTables, lambda machine, axis, stack: axis.number)
    spy(template.DriveView, lambda tables, driven: driven.number)
    design("a.toml", TEXT)
    for changes, found in ((EDITS[0], [("AxisTables", 2)]), (EDITS[2], [("AxisTables", 1), ("DriveView", 1)])):
        worked_out.clear()
        design("a.toml", edited(TEXT, changes))
        assert worked_out == found
