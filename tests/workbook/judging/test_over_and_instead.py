"""What lies over a verdict, stands instead of a number, or bears another's name: found, and named."""

import copy
import re
import zipfile

import pytest
from openpyxl.chart import ScatterChart
from openpyxl.drawing.spreadsheet_drawing import AnchorMarker, TwoCellAnchor

from tests.workbook.judging.hands import WORKBOOK, Known, repacked
from tests.workbook.press import too_weak
from workbook.build import build
from workbook.errors import ReadError
from workbook.reading.files import open_book

DRAWING = "http://schemas.openxmlformats.org/drawingml/2006/spreadsheetDrawing"
MAIN = "http://schemas.openxmlformats.org/drawingml/2006/main"


@pytest.fixture(scope="module")
def failing(press, tmp_path_factory):
    """A book of a press whose motors are too weak."""
    path = tmp_path_factory.mktemp("failing") / "book.xlsx"
    build(too_weak(press.machine), path)
    return Known(path)


@pytest.fixture
def edited(failing, tmp_path):
    """A workbook to be changed, and what verify says of it when it is saved."""

    def found(change):
        workbook = failing.opened()
        change(workbook)
        workbook.save(tmp_path / "edited.xlsx")
        return said(failing, tmp_path / "edited.xlsx")

    return found


def said(known, path):
    report = known.seen(path)
    return ({(f.kind, f.sheet, f.cell) for f in report.findings},
            {(n.sheet, n.computed) for n in report.notices})  # fmt: skip


def verdict(known, value):
    return known.place(next(q.name for _, q in known.declared.checks if q.value == value))


# drawings


def test_a_chart_over_a_verdict_is_found_and_beside_it_is_taste(failing, edited):
    for at in (verdict(failing, "FAIL"), failing.place("overall")):

        def over(workbook, right=0, at=at):
            chart = ScatterChart()
            ends = [AnchorMarker(col=column + right, row=row)
                    for column, row in ((at.column - 1, at.row - 1), (at.column, at.row))]  # fmt: skip
            chart.anchor = TwoCellAnchor(_from=ends[0], to=ends[1])
            workbook[at.sheet].add_chart(chart, chart.anchor)

        assert edited(over)[0] == {("shown", at.sheet, at.a1)}
        assert edited(lambda workbook: over(workbook, right=1)) == (set(), set())


def shape(at, size, fill):
    """A shape on a cell, by its corner and its size in EMU."""
    return (
        f'<x:oneCellAnchor xmlns:x="{DRAWING}" xmlns:a="{MAIN}"><x:from><x:col>{at.column - 1}</x:col><x:colOff>0'
        f"</x:colOff><x:row>{at.row - 1}</x:row><x:rowOff>0</x:rowOff></x:from><x:ext cx='{size}' cy='{size}'/>"
        f"<x:sp><x:nvSpPr><x:cNvPr id='77' name='T'/><x:cNvSpPr/></x:nvSpPr><x:spPr>{fill}</x:spPr></x:sp>"
        "<x:clientData/></x:oneCellAnchor>"
    ).encode()


@pytest.mark.parametrize(
    ("size", "fill", "hides"),
    [(900_000, "<a:solidFill/>", True), (900_000, "", True), (900_000, "<a:noFill/>", False), (9_000, "", False)],
)
def test_a_shape_over_a_verdict_is_found_if_it_hides_it(size, fill, hides, failing, tmp_path):
    at = verdict(failing, "FAIL")
    with zipfile.ZipFile(failing.path) as archive:
        folder, _, name = failing.part(at.sheet).rpartition("/")
        drawing = "xl/" + re.search(r"drawings/\w+\.xml", archive.read(f"{folder}/_rels/{name}.rels").decode())[0]
    change = {drawing: lambda data: re.sub(rb"(?=</(?:\w+:)?wsDr>)", shape(at, size, fill), data)}
    findings, _ = said(failing, repacked(failing.path, tmp_path / "a.xlsx", change))
    assert (("shown", at.sheet, at.a1) in findings) is hides


def test_a_shape_within_an_alternative_is_found_and_a_drawing_that_is_none_is_refused(failing, tmp_path):
    at = verdict(failing, "FAIL")
    with zipfile.ZipFile(failing.path) as archive:
        folder, _, name = failing.part(at.sheet).rpartition("/")
        links = f"{folder}/_rels/{name}.rels"
        drawing = "xl/" + re.search(r"drawings/\w+\.xml", archive.read(links).decode())[0]
    space = b'xmlns:mc="http://schemas.openxmlformats.org/markup-compatibility/2006"'
    within = b'<mc:AlternateContent %s><mc:Choice Requires="x">%s</mc:Choice></mc:AlternateContent>' % (
        space, shape(at, 900_000, "<a:solidFill/>"))  # fmt: skip
    change = {drawing: lambda data: re.sub(rb"(?=</(?:\w+:)?wsDr>)", within, data)}
    assert ("shown", at.sheet, at.a1) in said(failing, repacked(failing.path, tmp_path / "a.xlsx", change))[0]
    change = {links: lambda data: re.sub(rb"drawings/\w+\.xml", b"drawings/a.bin", data)}
    none = repacked(failing.path, tmp_path / "b.xlsx", change, extra=[("xl/drawings/a.bin", b"no drawing")])
    with pytest.raises(ReadError, match="damaged"):
        open_book(none)


# bars and icons instead of numbers


# names of sheets


def renamed(known, path, names):
    """A copy whose sheets have other names, which formulas and charts follow, as where a program renames them."""

    def change(data):
        for old in names:
            data = data.replace(f"'{old}'!".encode(), f"'@{old}'!".encode())
            data = data.replace(f'name="{old}" sheetId'.encode(), f'name="@{old}" sheetId'.encode())
        for old, new in names.items():
            data = data.replace(f"@{old}".encode(), new.encode())
        return data

    with zipfile.ZipFile(known.path) as archive:
        parts = {n: archive.read(n) for n in archive.namelist() if n.endswith(".xml")}
    return repacked(known.path, path, {n: change for n, data in parts.items() if n == WORKBOOK or change(data) != data})


def test_names_of_two_sheets_exchanged_are_found(failing, tmp_path):
    findings, _ = said(failing, renamed(failing, tmp_path / "a.xlsx", {"Motors": "Timing", "Timing": "Motors"}))
    assert findings == {("shown", "Timing", "A1"), ("shown", "Motors", "A1")}


def test_another_name_of_a_sheet_is_a_notice(failing, tmp_path):
    assert said(failing, renamed(failing, tmp_path / "a.xlsx", {"Motors": "Other"})) == (set(), {("Other", "Other")})


# lines of charts


def test_another_line_under_a_declared_name_is_found_and_one_of_its_own_is_taste(edited):
    def second(workbook, name):
        chart = workbook["Drive MC01"]._charts[1]
        line = copy.deepcopy(chart.series[0])
        line.yVal.numRef.f = "Timing!$A$1:$A$3"
        if name:
            line.tx.strRef, line.tx.v = None, name
        chart.series.append(line)

    assert {kind for kind, *_ in edited(lambda workbook: second(workbook, ""))[0]} == {"shown"}
    assert edited(lambda workbook: second(workbook, "measured"))[0] == set()
