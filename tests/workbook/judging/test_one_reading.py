"""A package of two readings is refused in one line, or read as the spreadsheet programs read it."""

import re

import pytest

from tests.workbook.judging.hands import LINKS, STRINGS, STYLES, TYPES, WORKBOOK, refused, repacked, sub
from workbook.judging.verify import verify
from workbook.reading.files import open_book

SPACE = b"http://schemas.openxmlformats.org/spreadsheetml/2006/main"
KIND = "application/vnd.openxmlformats-officedocument.spreadsheetml."
LINK = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/"


@pytest.fixture(scope="module")
def book(press):
    return press


def override(part, kind):
    return sub(rb"(?=</Types>)", f'<Override PartName="/{part}" ContentType="{KIND}{kind}+xml"/>'.encode())


def link(target, kind, number="other"):
    return sub(
        rb"(?=</Relationships>)", f'<Relationship Id="{number}" Type="{LINK}{kind}" Target="{target}"/>'.encode()
    )


def part(book, name):
    import zipfile

    with zipfile.ZipFile(book.path) as archive:
        return archive.read(name)


# parts


@pytest.mark.parametrize(
    ("name", "kind", "copy"),
    [
        ("xl/workbook2.xml", "sheet.main", WORKBOOK),
        ("xl/other.xml", "sheet.main", WORKBOOK),
        ("xl/sharedStrings2.xml", "sharedStrings", STRINGS),
        ("xl/styles2.xml", "styles", STYLES),
    ],
)
def test_a_second_part_by_content_type_is_refused(name, kind, copy, book, tmp_path):
    path = repacked(book.path, tmp_path / "b.xlsx", {TYPES: override(name, kind)}, [(name, part(book, copy))])
    assert "by relationship or content type" in refused(path)


@pytest.mark.parametrize(
    ("links", "target", "kind"),
    [
        ("_rels/.rels", "xl/workbook.xml", "officeDocument"),
        ("_rels/.rels", "xl/other.xml", "officeDocument"),
        (LINKS, "sharedStrings2.xml", "sharedStrings"),
        (LINKS, "/xl/sharedStrings2.xml", "sharedStrings"),
        (LINKS, "styles2.xml", "styles"),
    ],
)
def test_a_second_part_by_relationship_is_refused(links, target, kind, book, tmp_path):
    extra = [("xl/other.xml", part(book, WORKBOOK)), ("xl/sharedStrings2.xml", part(book, STRINGS)),
             ("xl/styles2.xml", part(book, STYLES))]  # fmt: skip
    said = refused(repacked(book.path, tmp_path / "b.xlsx", {links: link(target, kind)}, extra))
    assert "by relationship or content type" in said or "refers twice" in said


@pytest.mark.parametrize(
    ("links", "old", "new", "copy"),
    [
        ("_rels/.rels", b"xl/workbook.xml", b"xl/workbook2.xml", WORKBOOK),
        (LINKS, b"sharedStrings.xml", b"sharedStrings2.xml", STRINGS),
        (LINKS, b"styles.xml", b"styles2.xml", STYLES),
        (LINKS, b"worksheets/sheet2.xml", b"worksheets/sheet99.xml", "xl/worksheets/sheet2.xml"),
    ],
)
def test_a_relationship_that_leads_past_the_content_types_is_refused(links, old, new, copy, book, tmp_path):
    name = "xl/" + new.decode().removeprefix("xl/")
    changes = {links: lambda data: data.replace(old, new)}
    assert "by relationship" in refused(repacked(book.path, tmp_path / "b.xlsx", changes, [(name, part(book, copy))]))


def test_two_relationships_of_one_name_are_refused(book, tmp_path):
    number = re.search(rb'Id="(\w+)"', part(book, LINKS))[1].decode()
    assert "two relationships" in refused(repacked(book.path, tmp_path / "b.xlsx",
                                                   {LINKS: link("x.xml", "other", number)}))  # fmt: skip


def test_a_content_type_declared_twice_or_in_another_case_is_refused(book, tmp_path):
    twice = {TYPES: override("xl/workbook.xml", "template.main")}
    assert "twice" in refused(repacked(book.path, tmp_path / "a.xlsx", twice))
    case = {TYPES: sub(rb"/xl/styles.xml", b"/xl/Styles.xml")}
    assert "written otherwise" in refused(repacked(book.path, tmp_path / "b.xlsx", case))


def test_two_zips_one_behind_the_other_are_refused(book, tmp_path):
    other = repacked(book.path, tmp_path / "a.xlsx", {WORKBOOK: lambda data: data + b"<!-- -->"})
    (tmp_path / "b.xlsx").write_bytes(other.read_bytes() + book.path.read_bytes())
    assert "before its first part" in refused(tmp_path / "b.xlsx")


def test_parts_whose_names_differ_in_case_are_refused(book, tmp_path):
    extra = [("XL/Workbook.xml", part(book, WORKBOOK))]
    assert "2 times" in refused(repacked(book.path, tmp_path / "b.xlsx", {}, extra))


def test_a_sheet_of_another_namespace_or_root_is_refused(book, tmp_path):
    sheet = "xl/worksheets/sheet2.xml"
    other = {sheet: lambda data: data.replace(SPACE, b"urn:another")}
    assert "no worksheet" in refused(repacked(book.path, tmp_path / "a.xlsx", other))
    root = {sheet: lambda data: data.replace(b"<worksheet ", b"<sheet ").replace(b"</worksheet>", b"</sheet>")}
    assert "no worksheet" in refused(repacked(book.path, tmp_path / "b.xlsx", root))


# names


def test_names_that_differ_in_case_are_refused(book, tmp_path):
    name = b'<definedName name="Book_Template">Summary!$A$1</definedName>'
    change = {WORKBOOK: sub(rb"(?=</definedNames>)", name)}
    assert "'book_template'" in refused(repacked(book.path, tmp_path / "a.xlsx", change))
    change = {WORKBOOK: lambda data: data.replace(b'name="Checks"', b'name="summary"')}
    assert "two sheets named 'summary'" in refused(repacked(book.path, tmp_path / "b.xlsx", change))


def test_a_name_twice_is_refused_and_one_of_a_sheet_of_its_own_is_not(book, tmp_path):
    name = b'<definedName name="book_template"%s>Summary!$A$1</definedName>'
    change = {WORKBOOK: sub(rb"(?=</definedNames>)", name % b"")}
    assert "defines the name" in refused(repacked(book.path, tmp_path / "a.xlsx", change))
    local = {WORKBOOK: sub(rb"(?=</definedNames>)", name % b' localSheetId="1"')}
    path = repacked(book.path, tmp_path / "b.xlsx", local)
    assert open_book(path).places["book_template"].sheet == "Summary"
    assert [(f.kind, f.sheet, f.cell) for f in verify(path).findings] == [("name", "Timing", "book_template")]


def test_a_second_list_of_sheets_is_refused(book, tmp_path):
    change = {WORKBOOK: sub(rb"(<sheets>.*?</sheets>)", rb"\1\1")}
    assert "once" in refused(repacked(book.path, tmp_path / "b.xlsx", change))


# cells


def cell_with(book, tmp_path, pattern, new, name="b.xlsx"):
    return book.changed(tmp_path / name, book.a_number().address, pattern, new)


@pytest.mark.parametrize(
    ("pattern", "new", "says"),
    [
        (rb"(<f>.*?</f>)", rb"<f>1</f>\1", "<f> twice"),
        (rb"(<f>.*?</f>)", rb"\1<f>1</f>", "<f> twice"),
        (rb"(<v ?>.*?</v>)", rb"\1<v>1</v>", "<v> twice"),
        (rb"</f>", b"<x/>+1</f>", "inside of <f>"),
        (rb"</f>", b"<f>+1</f></f>", "inside of <f>"),
        (rb"</f>", b"<!-- -->+1</f>", "comment"),
        (rb"</f>", b"<?x y?>+1</f>", "comment"),
        (rb"(<v ?>)", rb"\1<!-- -->", "comment"),
        (rb"</v>", b"<t>1</t></v>", "inside of <v>"),
        (rb"<f>", b'<f xmlns="urn:other">', "within a row"),
        (rb"<f>", b'<f xmlns:x="urn:other">', "within a row"),
        (rb"<f>(.*?)</f>", rb"<g>\1</g>", "<g> in a cell"),
        (rb"<f>", b'<f t="strange">', "unknown kind"),
        (rb"<c ", b'<c t="strange" ', "unknown kind"),
        (rb"(<v ?>).*?(</v>)", rb"\g<1>1_000\2", "as the value"),
        (rb"(<v ?>).*?(</v>)", rb"\g<1>0x10\2", "as the value"),
        (rb"(<v ?>).*?(</v>)", "\\g<1>\u0661\u0662\\2".encode(), "as the value"),
        (rb"(<v ?>).*?(</v>)", rb"\g<1>nan\2", "as the value"),
        (rb'(<c r="\w+")', rb'\1 t="b"', "as the value"),
        (rb'(<c r="\w+")', rb'\1 t="s"', "as the value"),
        (rb'<c r="(\w+)"', rb'<c r="$\1"', "where a cell is expected"),
        (rb's="\d+"', b's="-1"', "unknown kind"),
    ],
)
def test_a_cell_of_two_readings_is_refused(pattern, new, says, book, tmp_path):
    assert says in refused(cell_with(book, tmp_path, pattern, new))


def test_a_cell_twice_is_refused_wherever_it_stands(book, tmp_path):
    at = book.a_number().address
    again = b'<c r="%s"><v>1</v></c>' % at.a1.encode()
    assert "twice" in refused(cell_with(book, tmp_path, rb"(.+)", rb"\1" + again, "a.xlsx"))
    assert "twice" in refused(cell_with(book, tmp_path, rb"(.+)", again + rb"\1", "b.xlsx"))
    row = b'<row r="%d">%s</row>' % (at.row, again)
    for name, where in (("c.xlsx", rb"(?=</sheetData>)"), ("d.xlsx", rb"(?<=<sheetData>)")):
        path = repacked(book.path, tmp_path / name, {book.part(at.sheet): sub(where, row)})
        assert f"the row {at.row} twice" in refused(path)


@pytest.mark.parametrize(
    ("pattern", "new"),
    [
        (rb"(?=</worksheet>)", b'<row r="9999"><c r="A9999"><v>1</v></c></row>'),
        (rb"(?=</worksheet>)", b'<extLst><ext uri="u"><row r="9999"><c r="A9999"/></row></ext></extLst>'),
        (rb"(?=<sheetData>)", b"<sheetData/>"),
        (rb"(?=</worksheet>)", b'<sheetData><row r="9999"/></sheetData>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><row r="9998"/></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9998"><v>1</v></c></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><x><c r="A9999"><v>1</v></c></x></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><extLst><ext><c r="A9999"><v>1</v></c></ext></extLst></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999"><extLst><row r="3"/></extLst></c></row>'),
        (rb"(?=</worksheet>)", b'<y:row xmlns:y="%s" r="9999"/>' % SPACE),
        (rb"(?=</worksheet>)", b'<e xmlns="u"><row xmlns="%s" r="9999"/></e>' % SPACE),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999"><f t="shared" si="7">1</f></c>'
                               b'<c r="B9999"><f t="shared" si="7">2</f></c></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999" t="inlineStr"><is><t>OK</t><r><t>FAIL</t></r></is></c>'
                               b"</row>"),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999" t="inlineStr"><is><t>OK</t><t>FAIL</t></is></c></row>'),
    ],
)  # fmt: skip
def test_rows_and_cells_out_of_their_place_are_refused(pattern, new, book, tmp_path):
    assert "damaged" in refused(repacked(book.path, tmp_path / "b.xlsx", {book.part("Timing"): sub(pattern, new)}))


@pytest.mark.parametrize("text", [b"<t>OK</t><t>FAIL</t>", b"<t>OK</t><r><t>FAIL</t></r>", b"<r><t>A</t></r><t>B</t>"])
def test_a_shared_text_written_twice_is_refused(text, book, tmp_path):
    path = repacked(book.path, tmp_path / "b.xlsx", {STRINGS: sub(rb"(?<=<si>).*?(?=</si>)", text)})
    assert "beside another" in refused(path)


# what programs write all the same


@pytest.mark.parametrize(
    ("pattern", "new"),
    [
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999" t="inlineStr"><is><r><rPr><b/></rPr><t>a</t></r>'
                               b"<r><t>b</t></r></is></c></row>"),
        (rb"(?=</sheetData>)", b'<row r="9999"><c r="A9999"><v>1</v><extLst><ext uri="u"/></extLst></c></row>'),
        (rb"(?=</sheetData>)", b'<row r="9999"><c><v>1.5E-3</v></c><c t="b"><v>1</v></c><c t="e"><v>#N/A</v></c>'
                               b"</row>"),
        (rb"(?=</worksheet>)", b'<e xmlns:xdr="urn:x"><xdr:row>5</xdr:row><xdr:c/></e>'),
        (rb"(?=</worksheet>)", b"<!-- outside of the cells -->"),
    ],
)  # fmt: skip
def test_what_programs_write_is_read(pattern, new, book, tmp_path):
    path = repacked(book.path, tmp_path / "b.xlsx", {book.part("Timing"): sub(pattern, new)})
    assert verify(path).findings == []


def test_a_part_with_a_prefix_for_its_namespace_is_read_alike(book, tmp_path):
    def prefixed(data):
        data = re.sub(rb"<(/?)(?=[a-zA-Z])(?![a-zA-Z]+:)", rb"<\1x:", data)
        return data.replace(b'xmlns="%s"' % SPACE, b'xmlns:x="%s"' % SPACE)

    path = repacked(book.path, tmp_path / "b.xlsx", {book.part("Timing"): prefixed})
    report = verify(path)
    assert report.findings == []
    assert report.compared == report.declared
