"""What a workbook asks a witness for beyond its cells, such as a linked picture, no witness fetches."""

import re
import threading
import zipfile
from contextlib import suppress
from socketserver import StreamRequestHandler, ThreadingTCPServer

import openpyxl
import pytest

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.judging.verify import verify
from workbook.reading.files import open_book
from workbook.witnesses.registry import WITNESSES

KINDS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
RELATIONS = '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">{}</Relationships>'
RELATION = f'<Relationship Id="rIdB" Type="{KINDS}/{{}}" Target="{{}}"{{}}/>'
DRAWING = f"""<xdr:wsDr xmlns:xdr="http://schemas.openxmlformats.org/drawingml/2006/spreadsheetDrawing"
 xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" xmlns:r="{KINDS}"><xdr:oneCellAnchor>
<xdr:from><xdr:col>30</xdr:col><xdr:colOff>0</xdr:colOff><xdr:row>80</xdr:row><xdr:rowOff>0</xdr:rowOff></xdr:from>
<xdr:ext cx="100000" cy="100000"/><xdr:pic><xdr:nvPicPr><xdr:cNvPr id="2" name="P"/><xdr:cNvPicPr/></xdr:nvPicPr>
<xdr:blipFill><a:blip r:link="rIdB"/><a:stretch><a:fillRect/></a:stretch></xdr:blipFill><xdr:spPr>
<a:prstGeom prst="rect"/></xdr:spPr></xdr:pic><xdr:clientData/></xdr:oneCellAnchor></xdr:wsDr>"""
FORMULAS = (
    '=WEBSERVICE("{0}/a")', '=_xlfn.WEBSERVICE("{0}/b")', "='{0}/[c.xlsx]Sheet1'!A1", "='{0}/d.ods'#$Sheet1.A1",
    '=INDIRECT("\'{0}/e.ods\'#$Sheet1.A1")', '=DDE("soffice","{0}/f.ods","A1")', '=IMAGE("{0}/g")',
)  # fmt: skip


@pytest.fixture
def port():
    """The address of a server on this machine, and what it was asked for."""
    asked: list[str] = []

    class Noted(StreamRequestHandler):
        def handle(self):
            asked.append(self.rfile.readline(200).decode())

    with ThreadingTCPServer(("127.0.0.1", 0), Noted) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}", asked
        server.shutdown()


def with_picture(book, path, address):
    """A copy of a book with a picture on a sheet that is linked to an address."""
    with zipfile.ZipFile(book) as archive:
        parts = {name: archive.read(name).decode() for name in archive.namelist()}
    sheets = [name for name in parts if re.fullmatch(r"xl/worksheets/sheet\d+\.xml", name)]
    sheet = next(name for name in sheets if "<drawing" not in parts[name])
    drawing = f'<drawing xmlns:r="{KINDS}" r:id="rIdB"/></worksheet>'
    parts[sheet] = parts[sheet].replace("</worksheet>", drawing)
    folder, _, name = sheet.rpartition("/")
    related = f"{folder}/_rels/{name}.rels"
    one = RELATION.format("drawing", "../drawings/drawing99.xml", "")
    held = parts.get(related, RELATIONS.format(""))
    parts[related] = held.replace("</Relationships>", f"{one}</Relationships>")
    parts["xl/drawings/drawing99.xml"] = DRAWING
    linked = RELATION.format("image", f"{address}/x.png", ' TargetMode="External"')
    parts["xl/drawings/_rels/drawing99.xml.rels"] = RELATIONS.format(linked)
    kind = '<Override PartName="/xl/drawings/drawing99.xml" ContentType="application/vnd.openxmlformats-'
    listed = parts["[Content_Types].xml"]
    parts["[Content_Types].xml"] = listed.replace("</Types>", f'{kind}officedocument.drawing+xml"/></Types>')
    with zipfile.ZipFile(path, "w") as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
    return path


@pytest.mark.parametrize("name", [name for name in WITNESSES if WITNESSES[name]().version()])
def test_no_witness_fetches_what_a_book_links_to(name, port, press, tmp_path):
    address, asked = port
    assert verify(with_picture(press.path, tmp_path / "b.xlsx", address), [name]).findings == []
    assert asked == []


@pytest.mark.parametrize("name", [name for name in WITNESSES if WITNESSES[name]().version() and name != "saved"])
def test_no_witness_fetches_what_a_formula_asks_for(name, port, tmp_path):
    address, asked = port
    book = openpyxl.Workbook()
    book.worksheets[0]["A1"] = "=1+1"
    for row, formula in enumerate(FORMULAS, 2):
        book.worksheets[0].cell(row, 1, formula.format(address))
    book.save(tmp_path / "b.xlsx")
    file = open_book(tmp_path / "b.xlsx")
    with suppress(WitnessError):  # an evaluator may refuse a file with such formulas
        assert WITNESSES[name]().values(file)[Address(file.workbook.sheetnames[0], 1, 1)] == 2.0
    assert asked == []
