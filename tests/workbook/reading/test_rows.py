"""Rows are taken as they are written, whatever the way of writing them; what is not right is refused."""

import random

import pytest

from workbook.reading.rows import MOST_OUTSIDE, Refusal, Totals
from workbook.reading.scan import Scan

SMALL = (
    '<?xml version="1.0" encoding="UTF-8"?>'
    '<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main">'
    '<sheetFormatPr defaultRowHeight="15"/><sheetData>'
    '<row r="1" spans="1:3"><c r="A1" s="2"><v>1.5</v></c><c r="B1" t="s"><v>0</v></c><c r="C1" s="1"/></row>'
    '<row r="2" ht="33" customHeight="1"><c r="A2"><f>A1&lt;2</f><v>1</v></c><c r="B2" t="str"><f>"a"&amp;"ö"</f>'
    '<v>aö</v></c><c r="D2" t="b"><v>0</v></c><c r="E2"><f>B9</f><v/></c></row><row r="7"/>'
    '</sheetData><mergeCells><mergeCell ref="A9:B9"/></mergeCells></worksheet>'
)


def read(data: bytes) -> Scan:
    """A part as it is read."""
    scan = Scan("xl/worksheets/sheet1.xml", Totals())
    scan.read(data)
    return scan


def test_cells_are_taken_in_order_and_the_rest_of_the_sheet_is_kept() -> None:
    scan = read(SMALL.encode())
    assert scan.rows is not None
    assert [tuple(cell) for cell in scan.rows.written] == [
        (1, 1, 2, "n", "1.5", None, ""), (1, 2, 0, "s", "0", None, ""), (1, 3, 1, "n", None, None, ""),
        (2, 1, 0, "n", "1", {}, "A1<2"), (2, 2, 0, "str", "aö", {}, '"a"&"ö"'), (2, 4, 0, "b", "0", None, ""),
        (2, 5, 0, "n", "", {}, "B9"),
    ]  # fmt: skip
    assert scan.rows.looks == {2: {"r": "2", "ht": "33", "customHeight": "1"}}
    assert scan.rows.size == 10
    assert [[child.tag.rpartition("}")[2] for child in part] for part in scan.root] == [[], [], ["mergeCell"]]


CASES = {
    "as it is": ("", ""),
    "shared": ("<f>B9</f>", '<f t="shared" ref="E2:E3" si="0">B9</f>'),
    "twice": ('r="B2"', 'r="A2"'),
    "elsewhere": ('r="B2"', 'r="B3"'),
    "no number": ("<v>1.5</v>", "<v>1,5</v>"),
    "no cell": ("<v>1.5</v>", "<v>1.5</v><v>2</v>"),
    "comment": ("<v>1.5</v>", "<!-- --><v>1.5</v>"),
    "entity": ("&lt;", "&#60;"),
    "no entity": ("&lt;", "&lt"),
    "no text": ("aö", "]]>"),
    "row twice": ('row r="7"', 'row r="2"'),
    "row beyond": ('row r="7"', 'row r="9999999"'),
    "attribute twice": ('s="2"', 's="2" s="2"'),
    "prefix": ("<v>1.5</v>", "<x:v>1.5</x:v>"),
    "line feed": ("aö", "a\r\nb"),
    "other order": ('r="A1" s="2"', 's="2" r="A1"'),
    "unclosed": ("</sheetData>", "</sheetData"),
    "in a comment": ("<sheetData>", "<!-- <sheetData> --><sheetData>"),
    "twice its data": ("<mergeCells>", "<sheetData></sheetData><mergeCells>"),
    "not UTF-8": ('encoding="UTF-8"', 'encoding="ISO-8859-1"'),
    "long": ("B9", "1+" * 5_000),
    "late fault": ("</worksheet>", "</worksheets>"),
}
REFUSED = {
    "twice", "elsewhere", "no number", "no cell", "comment", "no entity", "no text", "row twice", "attribute twice",
    "prefix", "unclosed", "twice its data", "long", "late fault",
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_what_is_not_right_is_refused(name: str) -> None:
    old, new = CASES[name]
    assert old in SMALL
    if name in REFUSED:
        with pytest.raises(Refusal):
            read(SMALL.replace(old, new).encode())
    else:
        read(SMALL.replace(old, new).encode())


def test_bytes_changed_at_random_are_read_or_refused() -> None:
    drawn, data = random.Random(11), SMALL.encode()
    letters = b'<>/"&;= rcfvsAB129.\x00\n\xc3\xff]'
    refused = 0
    for _ in range(3_000):
        changed = bytearray(data)
        for _ in range(drawn.choice((1, 1, 2))):
            at = drawn.randrange(len(changed))
            how = drawn.randrange(3)
            changed[at : at + (how < 2)] = [drawn.choice(letters)] if how else []
        try:
            read(bytes(changed))
        except Refusal:
            refused += 1
    assert 1_000 < refused < 3_000


def test_a_pivot_cache_counts_once_more_for_each_sheet() -> None:
    """For each it is parsed anew."""
    totals = Totals()
    for _ in range(10):
        totals.element("sheet", 0, False)
    totals.element("r", MOST_OUTSIDE // 12, True)
    with pytest.raises(Refusal, match="XML elements"):
        totals.element("r", MOST_OUTSIDE // 12, True)
