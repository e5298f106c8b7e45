"""Workbooks from anywhere: refused in one line, or read; within bounds of memory and time, with nothing written."""

import os
import re
import struct
import subprocess
import sys
import zipfile
from functools import partial

import pytest

from tests.tiers import nights, seed
from tests.workbook.composed import small
from tests.workbook.judging.hands import refused, sub
from tests.workbook.reading.fuzz import damaged, pack, unpack, without_charts
from workbook.build import build
from workbook.errors import InputError, MotionbookError, ReadError
from workbook.judging.verify import verify
from workbook.reading import guard
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.witnesses.agreement import agreed_values

FILES, CHUNKS = 200, 4  # by day; a night has as many runs of a chunk as it has NIGHTS
NIGHTS = 4
VERIFIED = 40  # every so many files are verified too, not only read
WITH_CHARTS = 20  # every so many files keep their charts
GIB = 2**30
SECONDS = 600  # of one hostile file, on a busy machine; what this finds is a hang


@pytest.fixture(scope="module")
def sound(press):
    """The bytes of the smallest book there is."""
    return press.path.read_bytes()


@pytest.fixture(scope="module")
def slim(sound):
    """The same without charts."""
    return without_charts(sound)


@pytest.fixture
def book(tmp_path, slim):
    """Write a book whose parts were changed, and return its path."""

    def made(changes=None, extra=(), method=zipfile.ZIP_DEFLATED, suffix=".xlsx"):
        changes = changes or {}
        parts = [(name, changes.get(name, lambda data: data)(data)) for name, data in unpack(slim)]
        path = tmp_path / f"book{suffix}"
        path.write_bytes(pack([*parts, *extra], method))
        return path

    return made


SHEET = "xl/worksheets/sheet1.xml"
ROW = rb"(?=</sheetData>)"


# damaged files


@pytest.mark.parametrize("chunk", [*range(CHUNKS), *nights(NIGHTS)])
def test_damaged_files_are_read_or_refused(chunk, sound, slim, tmp_path, request):
    path = tmp_path / "book.xlsx"
    drawn = 0 if request.node.get_closest_marker("nightly") is None else seed("fuzz")
    faults = []
    for number in range(chunk * FILES // CHUNKS, (chunk + 1) * FILES // CHUNKS):
        path.write_bytes(damaged(slim if number % WITH_CHARTS else sound, number, drawn))
        fault = fault_of(path, number)
        if fault:
            faults.append(f"{number}, seed {drawn!r}: {fault}")
    assert faults == []
    assert os.listdir(tmp_path) == ["book.xlsx"]


def fault_of(path, number):
    """What is wrong with how a damaged file is taken; nothing where it is read, or refused as it should be."""
    try:
        Entries(open_book(path), partial(agreed_values, names=("pycel", "formulon"))).machine()
        if number % VERIFIED == 0:
            verify(path)
    except ReadError as error:
        return None if "\n" not in str(error) and str(error).startswith(str(path)) else f"says {error}"
    except MotionbookError as error:
        return None if str(error) else "says nothing"
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return None


# the zip


def test_missing_folder_and_device(tmp_path):
    assert "no such file" in refused(tmp_path / "none.xlsx")
    assert "a folder" in refused(tmp_path)
    if os.name == "posix":
        (tmp_path / "zero.xlsx").symlink_to("/dev/zero")
        assert "a device" in refused(tmp_path / "zero.xlsx")
        os.mkfifo(tmp_path / "pipe.xlsx")
        assert "a pipe" in refused(tmp_path / "pipe.xlsx")


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "empty"),
        (b"PK", "damaged"),
        (b"a;b;c\n1;2;3\n", "CSV"),
        (b"<html><table></table></html>", "HTML"),
        (b"\x00\x01\x02" * 100, "not a workbook"),
        (guard.OLE + bytes(2000), "an old .xls workbook"),
        (guard.OLE + bytes(2000) + "EncryptedPackage".encode("utf-16-le"), "remove the password"),
        (b"PK\x05\x06" + bytes(18), "no [Content_Types].xml"),
    ],
)
def test_other_kinds_of_file_are_named(data, says, tmp_path):
    path = tmp_path / "book.xlsx"
    path.write_bytes(data)
    assert says in refused(path)


@pytest.mark.parametrize(
    ("names", "says"),
    [
        (("mimetype", "content.xml"), "an OpenDocument file"),
        (("[Content_Types].xml", "xl/workbook.bin"), ".xlsb"),
        (("[Content_Types].xml", "[content_types].XML"), "2 times"),
        (("[Content_Types].xml", "../../evil.xml"), "leads out of the workbook"),
        (("[Content_Types].xml", "/etc/passwd"), "no spreadsheet program writes"),
        (("[Content_Types].xml", "C:\\evil.xml"), "no spreadsheet program writes"),
        (("[Content_Types].xml", *(f"p{i}.bin" for i in range(guard.MOST_PARTS))), "parts"),
        (("[Content_Types].xml",), "no part could be its workbook"),
    ],
)
def test_odd_tables_of_contents_are_refused(names, says, tmp_path):
    path = tmp_path / "book.xlsx"
    path.write_bytes(pack([(name, b"<x/>") for name in names]))
    assert says in refused(path)


@pytest.mark.parametrize("suffix", [".ods", ".xls", ".xlsb", ".csv", ""])
def test_other_suffixes_are_refused(suffix, book):
    assert "save it as .xlsx" in refused(book(suffix=suffix))


def test_zip_with_a_password(book):
    path = book()
    data = bytearray(path.read_bytes())
    data[data.find(b"PK\x01\x02") + 8] |= 1
    path.write_bytes(data)
    assert "remove the password" in refused(path)


def test_declared_bomb(book):
    assert "zip bomb" in refused(book(extra=[("xl/media/image1.png", bytes(20_000_000))]))


def test_total_size(book, monkeypatch):
    monkeypatch.setattr(guard, "MOST_UNPACKED", 50_000_000)
    noise = os.urandom(1000) * 50  # deflate reaches 32 kB back: packs little
    heaps = [(f"xl/media/image{i}.png", os.urandom(200_000) + noise * 40) for i in range(25)]
    assert "unpacks to more than" in refused(book(extra=heaps))


def test_part_larger_than_declared(book):
    """A table of contents that declares less than a part unpacks to, with the checksum of that little."""
    path = book(extra=[("xl/media/image1.png", bytes(50_000_000))])
    data = bytearray(path.read_bytes())
    entry = data.rfind(b"PK\x01\x02")
    struct.pack_into("<L", data, entry + 24, 100)
    struct.pack_into("<L", data, entry + 16, zipfile.crc32(bytes(100)))
    path.write_bytes(data)
    assert "size that the zip declares" in refused(path)


def test_overlapping_parts(book):
    """Many entries that share one packed part, as in Fifield's bomb."""
    path = book(extra=[("xl/media/image1.png", os.urandom(100_000))])
    with zipfile.ZipFile(path, "a") as archive:
        part = archive.getinfo("xl/media/image1.png")
        for i in range(50):
            again = zipfile.ZipInfo(f"xl/media/again{i}.png")
            again.header_offset, again.CRC = part.header_offset, part.CRC
            again.file_size, again.compress_size = part.file_size, part.compress_size
            again.compress_type = part.compress_type
            archive.filelist.append(again)
        archive._didModify = True
    assert "overlap" in refused(path)


def test_nested_zips_are_not_opened(book):
    inner = bytes(30_000_000)
    for _ in range(3):
        inner = pack([("a.zip", inner)], zipfile.ZIP_DEFLATED)
    assert open_book(book(extra=[("xl/embeddings/a.zip", inner)])).notes == [guard.NOTES["xl/embeddings/"]]


# the XML


@pytest.mark.parametrize(
    "declaration",
    [
        b"<!DOCTYPE x>",
        b'<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;&a;">]>',
        b'<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]>',
        b'<!DOCTYPE x SYSTEM "http://localhost:9/x.dtd">',
    ],
)
@pytest.mark.parametrize("part", [SHEET, "xl/workbook.xml", "[Content_Types].xml", "xl/styles.xml"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_document_types_and_entities_are_refused(declaration, part, encoding, book):
    def change(data):
        text = re.sub(r"^<\?xml[^>]*\?>", "", data.decode())
        return f"{declaration.decode()}{text}".encode(encoding)

    assert "declares a document type or entities" in refused(book({part: change}))


def test_entities_in_a_part_of_another_name(book):
    hidden = b"\n <!DOCTYPE x [<!ENTITY a 'b'>]><x>&a;</x>"
    assert "entities" in refused(book(extra=[("xl/media/image1.png", hidden)]))


def test_deep_nesting(book):
    deep = b"<a>" * 100_000 + b"</a>" * 100_000
    assert "nested" in refused(book({SHEET: sub(ROW, deep)}))


@pytest.mark.parametrize(
    ("new", "says"),
    [
        (b'<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>', "places"),
        (b'<row r="2000000000"><c><v>1</v></c></row>', "beyond the last cell"),
        (b'<row r="1048577"><c r="A1048577"><v>1</v></c></row>', "last cell of a sheet"),
        (b'<row r="999"><c r="XFE999"><v>1</v></c></row>', "last cell of a sheet"),
        (b'<row r="999"><c r="Total"><v>1</v></c></row>', "where a cell is expected"),
        (b'<row r="x"/>', "row numbered"),
        (b"<row>" + b"<c/>" * 20_000 + b"</row>", "beyond the last cell"),
        ((b"<row>" + b"<c/>" * 10_000 + b"</row>") * 160, "places"),
        (b'<row r="999"><c r="A999" t="str"><v>%s</v></c></row>' % (b"x" * 40_000), "more than 32,767 characters"),
        (b'<row r="999"><c r="A999"><f>1%s</f></c></row>' % (b"+1" * 5_000), "more than 8,192 characters"),
        (b'<row r="999"><c r="A999"><f t="shared" si="0">1%s</f></c></row>' % (b"+1" * 4_000)
         + b'<row><c><f t="shared" si="0"/></c></row>' * 60_000, "characters together"),
        (b"<a/>" * 1_100_000, "XML elements"),
        (b"<a b='%s'/>" % (b" " * 110_000), "characters of attributes"),
    ],
)  # fmt: skip
@pytest.mark.sample(6)
def test_absurd_sheets_are_refused(new, says, book):
    assert says in refused(book({SHEET: sub(ROW, new)}, method=zipfile.ZIP_STORED))


@pytest.mark.parametrize("element", ["mergeCell", "hyperlink"])
def test_ranges_that_would_be_filled_are_refused(element, book):
    new = f'<{element}s><{element} ref="A1:XFD1048576"/></{element}s>'.encode()
    assert "places" in refused(book({SHEET: sub(rb"(?<=</sheetData>)", new)}))


def test_a_dimension_that_claims_too_much_is_harmless(book):
    claim = sub(rb'<dimension ref="[^"]*"', b'<dimension ref="A1:XFD1048576"')
    assert open_book(book({SHEET: claim})).places


def test_a_million_names(book):
    names = b"".join(b'<definedName name="n%d">Summary!$A$1</definedName>' % i for i in range(1_000_000))
    assert "20,000 elements <definedName>" in refused(
        book({"xl/workbook.xml": sub(rb"(?=</definedNames>)", names)}, method=zipfile.ZIP_STORED)
    )


def test_millions_of_shared_strings(book):
    strings = sub(rb"(?=</sst>)", b"<si><t>x</t></si>" * 300_000)
    assert "200,000 elements <si>" in refused(book({"xl/sharedStrings.xml": strings}, method=zipfile.ZIP_STORED))


def test_a_part_parsed_again_and_again(book):
    """Each reference to a sheet makes openpyxl parse it once more."""
    sheets = b"".join(b'<sheet name="s%d" sheetId="%d" r:id="rId1"/>' % (i, 100 + i) for i in range(200))
    found = re.compile(rb"(?=</sheets>)")
    change = lambda data: found.sub(sheets.replace(b"rId1", re.findall(rb':id="(\w+)"', data)[0]), data)  # noqa: E731
    assert "refers twice" in refused(book({"xl/workbook.xml": change}))


STRICT = b"http://purl.oclc.org/ooxml/spreadsheetml/"


def test_a_strict_workbook_is_named_as_such_with_the_way_out(book, slim):
    """As Excel writes it: the namespaces of ISO/IEC 29500-1."""
    names = [name for name, data in unpack(slim) if b"spreadsheetml/2006/main" in data]
    change = sub(rb"http://schemas.openxmlformats.org/spreadsheetml/2006/", STRICT)
    assert re.search("a Strict Open XML .* save it as .xlsx", refused(book(dict.fromkeys(names, change))))


# what is read, but odd


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"xl/workbook.xml": lambda data: b""}, "not well-formed"),
        ({"xl/styles.xml": lambda data: b"<x/>"}, "cannot be read"),
        ({"[Content_Types].xml": sub(rb"sheet\.main\+xml", b"sheet.none+xml")}, "could be its workbook"),
        ({SHEET: sub(rb'<c r="(\w+)"[^>]*>.*?</c>', b'<c r="B1" t="s"><v>99999</v></c>')}, "beyond the table"),
        ({SHEET: sub(rb'<c r="(\w+)"[^>]*>.*?</c>', b'<c r="B1"><v>many</v></c>')}, "'many' as the value"),
        ({SHEET: sub(rb'<c r="(\w+)"[^>]*>.*?</c>', b'<c r="B1" s="9999"><v>1</v></c>')}, "beyond the table"),
    ],
)
def test_what_the_parser_cannot_read_is_one_line(changes, says, book):
    assert says in refused(book(changes))


@pytest.mark.parametrize(
    "missing", ["[Content_Types].xml", "xl/workbook.xml", "xl/_rels/workbook.xml.rels", "xl/styles.xml"]
)
def test_missing_parts(missing, slim, tmp_path):
    path = tmp_path / "book.xlsx"
    path.write_bytes(pack([(name, data) for name, data in unpack(slim) if name != missing]))
    with pytest.raises(ReadError, match=re.escape(str(path))):
        verify(path)


@pytest.mark.parametrize("part", ["xl/externalLinks/externalLink1.xml", "xl/vbaProject.bin", "xl/connections.xml"])
def test_macros_links_and_connections_are_noted(part, book):
    content = b"\xd0\xcf\x11\xe0" if part.endswith("bin") else b"<x/>"
    path = book(extra=[(part, content)], suffix=".xlsm")
    (note,) = open_book(path).notes
    assert note in verify(path).notes


NOWHERE = (
    "#REF!", "#REF!$A$1", "Gone!$A$1", "", "'", "1", "Summary!$A$1:$XFD$1048576", "Summary!$A:$A", "{1,2",
    "Summary!$A$0", "Summary!$A$9999999", "[1]Summary!$A$1", "OFFSET(Summary!$A$1,1,1)", "&quot;",
    "Summary!", "!", "Summary!$B$2:$A$1",
)  # fmt: skip


def test_names_that_lead_nowhere(book):
    names = "".join(f'<definedName name="odd{i}">{text}</definedName>' for i, text in enumerate(NOWHERE)).encode()
    path = book({"xl/workbook.xml": sub(rb"(?=</definedNames>)", names)})
    assert not [name for name in open_book(path).places if name.startswith("odd")]


def test_a_block_said_to_reach_over_a_million_rows(book):
    change = sub(rb'(?<=name="timing_rate">)[^<]*', b"Timing!$D$7:$D$1048576")
    with pytest.raises(InputError, match="timing_rate"):
        verify(book({"xl/workbook.xml": change}))


def entry(path, name):
    """Sheet part and cell of a name."""
    place = open_book(path).places[name]
    sheets = open_book(path).workbook.sheetnames
    return f"xl/worksheets/sheet{sheets.index(place.sheet) + 1}.xml", place.cell(0, 0).a1


@pytest.mark.parametrize(
    "cell",
    [
        't="d"><v>2026-01-31T12:00:00</v>', 't="e"><v>#DIV/0!</v>', 't="b"><v>1</v>', "><v>1e308</v>",
        "><v>-1e-320</v>", "><v>1e999</v>", "><v>NaN</v>", 't="str"><v>NaN</v>',
        't="inlineStr"><is><t>%s</t></is>' % ("x" * 30_000),
        't="str"><v>\u202e\U0001f600</v>', "><v>123456789012345678901234567890</v>", "><f>1/0</f>", "><f>NOW()</f>",
        "><f>#REF!</f>", "><f>REPT(&quot;x&quot;,9)</f>", ">",
    ],
)  # fmt: skip
def test_odd_inputs_are_named_by_their_cell(cell, book):
    sheet, at = entry(book(), "timing_rate")
    path = book({sheet: sub(rf'<c r="{at}"[^>]*>.*?</c>'.encode(), f'<c r="{at}" {cell}</c>'.encode())})
    assert named(path, at)


@pytest.mark.parametrize("value", ["1e999", "-1e999", "9" * 400, "1e308", "0.5", "-1"])
def test_odd_numbers_of_rows_are_no_fault_of_ours(value, book):
    """In a column that numbers the rows of a table, by which rows that were put in are found."""
    sheet, at = entry(book(), "axis1")
    place = open_book(book()).places["axis1"]
    numbers = next(c for c in range(place.columns) if open_book(book()).value(place.cell(1, c)) == 2)
    cell = place.cell(1, numbers).a1
    path = book({sheet: sub(rf'<c r="{cell}"[^>]*>.*?</c>'.encode(), f'<c r="{cell}"><v>{value}</v></c>'.encode())})
    assert named(path, cell)
    assert at


def named(path, at):
    """Whether a book is verified, or refused with the cell or the file named."""
    try:
        verify(path)
    except InputError as error:
        return any(at in line for line in error.lines)
    except ReadError as error:
        return str(path) in str(error)
    return True


@pytest.mark.parametrize(
    "formula",
    [
        "{at}", "{at}+1", "SUM(A1:XFD1048576)", "SUM(A:A)", "1" + "+1" * 4000, "(" * 300 + "1" + ")" * 300,
        "IF(1," * 60 + "1" + ")" * 60, "-" * 4000 + "1", "1E999", "NOSUCH(1)", "[1]Other!A1",
        "__import__(&quot;os&quot;).system(&quot;exit&quot;)", "#REF!",
    ],
)  # fmt: skip
def test_odd_formulas_are_findings(formula, book):
    sheet, at = entry(book(), "omega")
    new = f'<c r="{at}"><f>{formula.format(at=at)}</f></c>'.encode()
    report = verify(book({sheet: sub(rf'<c r="{at}"[^>]*>.*?</c>'.encode(), new)}))
    assert at in [finding.cell for finding in report.findings]


# as a program


LIMITED = """
import resource, sys
resource.setrlimit(resource.RLIMIT_AS, ({limit}, {limit}))
from workbook.cli import main
main()
"""


def limited(path, limit):
    """Verify by the command as a program with so many bytes of memory."""
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}  # each of its threads reserves memory
    return subprocess.run(
        [sys.executable, "-c", LIMITED.format(limit=limit), "verify", path], capture_output=True, text=True,
        timeout=SECONDS, check=False, env=environment,
    )  # fmt: skip


def bomb(parts):
    return [*parts, ("xl/media/image1.png", bytes(300_000_000))]


def wide(parts, rows=21_000):
    """As many cells as are let through, nearly, if there are so many rows; formulas in all of them."""
    row = (
        b'<row r="%d">'
        + b"".join(b'<c r="%s%%d"><f>A%%d*%d</f><v>1</v></c>' % (c, i) for i, c in enumerate(LETTERS))
        + b"</row>"
    )
    more = b"".join(row % ((n,) * (1 + 2 * len(LETTERS))) for n in range(1000, 1000 + rows))
    return [(name, sub(ROW, more)(data) if name == SHEET else data) for name, data in parts]


LETTERS = [bytes([c]) for c in b"BCDEFGHIJKLMNOPQRSTUVWXYZ"]


@pytest.mark.skipif(sys.platform != "linux", reason="RLIMIT_AS bounds the memory of a program on Linux only")
@pytest.mark.parametrize(
    ("make", "limit"),
    [(bomb, GIB), (partial(wide, rows=4_000), GIB // 2), pytest.param(wide, GIB, marks=pytest.mark.nightly)],
    ids=["bomb", "a fifth of the cells in half of it", "wide"],
)
def test_memory_stays_below_one_gibibyte(make, limit, tmp_path):
    build(small(), tmp_path / "sound.xlsx")  # a program of its own knows no press
    parts = unpack(without_charts((tmp_path / "sound.xlsx").read_bytes()))
    (tmp_path / "book.xlsx").write_bytes(pack(make(parts), zipfile.ZIP_DEFLATED))
    run = limited(tmp_path / "book.xlsx", limit)
    assert run.returncode in (0, 2), run.stderr[-2000:]
    assert "Traceback" not in run.stderr
    assert "memory of this machine" not in run.stderr
