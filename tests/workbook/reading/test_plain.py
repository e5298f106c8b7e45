"""Rows that one pattern takes are those that the parser's rules take, cell by cell, or are left to them."""

import random
import zipfile
from pathlib import Path

import pytest

from workbook.reading import scan
from workbook.reading.count import Count, Refusal
from workbook.reading.plain import OddError, Taken, rows_between
from workbook.reading.rows import Rows
from workbook.reading.scan import Scan

BOOKS = sorted(path for path in Path("templates").glob("*.xlsx"))
SMALL = (
    '<?xml version="1.0" encoding="UTF-8"?>'
    '<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main">'
    '<sheetFormatPr defaultRowHeight="15"/><sheetData>'
    '<row r="1" spans="1:3"><c r="A1" s="2"><v>1.5</v></c><c r="B1" t="s"><v>0</v></c><c r="C1" s="1"/></row>'
    '<row r="2" ht="33" customHeight="1"><c r="A2"><f>A1&lt;2</f><v>1</v></c><c r="B2" t="str"><f>"a"&amp;"ö"</f>'
    '<v>aö</v></c><c r="D2" t="b"><v>0</v></c><c r="E2"><f>B9</f><v/></c></row><row r="7"/>'
    '</sheetData><mergeCells><mergeCell ref="A9:B9"/></mergeCells></worksheet>'
)


@pytest.fixture
def unread(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    """The means to leave all rows to the parser."""
    return monkeypatch


def both(data: bytes, patch: pytest.MonkeyPatch) -> list[object]:
    """What a part is read as: with the pattern, and by the parser's rules alone."""
    found: list[object] = []
    for plain in (True, False):
        with patch.context() as context:
            if not plain:
                context.setattr(scan, "taken", lambda rows, text: False)
            one = Scan("xl/worksheets/sheet1.xml", Count())
            try:
                one.read(data)
            except Refusal as refusal:
                found.append(str(refusal).partition("(")[0])
            else:
                found.append(held(one.rows, one.count))
    return found


def held(rows: Rows | None, count: Count) -> object:
    """What was taken of a part, and how much it counts."""
    if rows is None:
        return vars(count)
    return rows.written, rows.looks, rows.span, rows.size, vars(count)


def parts() -> list[tuple[str, bytes]]:
    found = []
    for book in BOOKS:
        with zipfile.ZipFile(book) as archive:
            found += [(f"{book.stem} {n}", archive.read(n)) for n in archive.namelist() if "/worksheets/sheet" in n]
    return found


@pytest.mark.sample(60)
@pytest.mark.parametrize(("name", "data"), parts(), ids=lambda value: value if isinstance(value, str) else "")
def test_a_sheet_of_ours_is_plain_but_for_arrays_and_taken_as_the_parser_takes_it(
    name: str, data: bytes, unread: pytest.MonkeyPatch
) -> None:
    pattern, parser = both(data, unread)
    assert pattern == parser
    if b't="array"' not in data:
        begin, end = rows_between(data)
        Taken().take(data[begin:end].decode())


def test_what_is_not_plain_or_not_right_is_left_to_the_parser(unread: pytest.MonkeyPatch) -> None:
    cases = {
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
    refused = set()
    for name, (old, new) in cases.items():
        assert old in SMALL
        pattern, parser = both(SMALL.replace(old, new).encode(), unread)
        assert pattern == parser, name
        refused |= {name} if isinstance(pattern, str) else set()
    assert refused == {
        "twice", "elsewhere", "no number", "no cell", "comment", "no entity", "no text", "row twice",
        "attribute twice", "prefix", "unclosed", "twice its data", "long", "late fault",
    }  # fmt: skip


def test_bytes_changed_at_random_are_read_as_the_parser_reads_them(unread: pytest.MonkeyPatch) -> None:
    drawn, data = random.Random(11), SMALL.encode()
    letters = b'<>/"&;= rcfvsAB129.\x00\n\xc3\xff]'
    refused = 0
    for _ in range(3_000):
        changed = bytearray(data)
        for _ in range(drawn.choice((1, 1, 2))):
            at = drawn.randrange(len(changed))
            how = drawn.randrange(3)
            changed[at : at + (how < 2)] = [drawn.choice(letters)] if how else []
        pattern, parser = both(bytes(changed), unread)
        assert pattern == parser, bytes(changed)
        refused += isinstance(parser, str)
    assert 1_000 < refused < 3_000


def test_a_row_that_is_none_is_odd() -> None:
    with pytest.raises(OddError):
        Taken().take("<row r='1'/>")
