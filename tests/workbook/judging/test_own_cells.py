"""An engineer's own cells, beside the tables and on sheets of their own: whatever they hold, they are no finding."""

import re
from datetime import UTC, datetime

import openpyxl
import pytest

from tests.workbook import own
from tests.workbook.judging.hands import Known, repacked, sub
from tests.workbook.judging.test_real_edits import numbers
from workbook.build import read_inputs
from workbook.errors import InputError, ReadError
from workbook.judging.batch import Outcome
from workbook.judging.report import Report
from workbook.judging.verify import verify
from workbook.reading import files
from workbook.reports.console import report_data
from workbook.reports.page import junit, page
from workbook.witnesses.engines import convert, libreoffice_path
from workbook.witnesses.registry import WITNESSES

QUICK_WITNESSES = ("pycel", "formulon", "ironcalc")
needs_office = pytest.mark.skipif(libreoffice_path() is None, reason="LibreOffice is not on this machine")


def present(*names):
    return [name for name in names if WITNESSES[name]().version() is not None]


class Filled:
    """A book with a bag of own cells in it."""

    def __init__(self, path, folder):
        self.built, self.path = path, folder / f"{path.stem}-own.xlsx"
        known = Known(path)
        tables = [p for p in known.match.pairs if p.declared_formula and p.cell.block.is_table and p.cell.block.size > 3
                  and isinstance(p.cell.expected, float)]  # fmt: skip
        block, column = tables[0].cell.block, tables[0].cell.quantity.name
        cell = tables[0].address
        self.count = own.fill(
            path, self.path, (known.declared.range(f"[{block.name}.{column}]"), f"'{cell.sheet}'!{cell.a1}")
        )


@pytest.fixture(scope="module")
def filled(press, tmp_path_factory):
    return Filled(press.path, tmp_path_factory.mktemp("press"))


def silent(path, count, witnesses):
    """Verify a book with own cells: nothing is said of them but how many there are."""
    report = verify(path, witnesses)
    assert [f"{f.sheet}!{f.cell} {f.kind} {f.computed}" for f in report.findings] == []
    assert [f"{f.sheet}!{f.cell} {f.what}" for f in report.notices] == []
    assert {w.name: w.compared for w in report.witnesses if w.answered and w.name != "saved"} == dict.fromkeys(
        witnesses, report.declared
    )
    assert (len(report.own), report.not_evaluated) == (count, count)
    assert not [note for note in report.notes if "own" in note]
    return report


def test_own_cells_are_no_finding(filled):
    report = silent(filled.path, filled.count, present(*QUICK_WITNESSES))
    assert report.declared > 200
    assert numbers(read_inputs(filled.path)[0]) == numbers(read_inputs(filled.built)[0])


def test_running_sums_of_ones_own_are_not_counted_as_work(press, tmp_path, monkeypatch):
    """Of 60,000 rows they read 1,800,000,000 cells; nobody evaluates them. Where an entry reads them they count."""
    monkeypatch.setattr(files, "MOST_READ", 10 * press.file.contents.cells_read)
    opened = press.opened()
    mine = opened.create_sheet("Mine")
    for row in range(1, 1_001):
        mine.append([row, f"=SUM($A$1:A{row})"])
    assert files.MOST_READ < 1_000**2 / 2
    opened.save(tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx")
    assert (report.findings, report.not_evaluated) == ([], 1_000)
    entry = press.place("timing_rate")
    opened[entry.sheet][entry.a1].value = "=SUM(Mine!B1:B1000)/1E8"
    opened.save(tmp_path / "c.xlsx")
    with pytest.raises(ReadError, match=r"its formulas read \d{3},\d{3} cells"):
        verify(tmp_path / "c.xlsx")


def test_own_cells_are_no_finding_by_any_witness(filled):
    silent(filled.path, filled.count, present("libreoffice", "formulon"))


@needs_office
def test_own_cells_are_no_finding_after_libreoffice(filled, tmp_path):
    saved = convert(filled.path, "xlsx", tmp_path)
    report = verify(saved, present(*QUICK_WITNESSES))
    own = "conditionalFormattings"  # as it writes the bars in own cells: a notice says so
    told = report.findings + [f for f in report.notices if not f.what.startswith(own)]
    assert [f"{f.sheet}!{f.cell} {f.kind} {f.computed}" for f in told] == []
    assert report.not_evaluated == len(report.own) > 500
    assert all(w.compared == report.declared for w in report.witnesses if w.answered)
    assert "saved" in [w.name for w in report.witnesses if w.answered]


def test_one_line_says_how_many_are_not_checked(filled, capsys):
    from rich.console import Console

    from workbook.reports.console import show_report

    report = verify(filled.path)
    data = report_data(report)
    assert (data["own_cells"]["formulas"], data["own_cells"]["not_evaluated"]) == (filled.count, filled.count)
    show_report(report, Console(width=500))
    (line,) = [text for text in capsys.readouterr().out.splitlines() if "not checked" in text]
    assert line.startswith(f"{filled.count:,} formulas of your own, not checked")
    outcome = Outcome(filled.path, "agrees", report)
    when = datetime(2026, 1, 1, tzinfo=UTC)
    assert report.own_words in page([outcome], when)
    assert report.own_words in junit([outcome], when)
    assert Report(filled.path, "x").own_words == ""


# what feeds an input


def fed(press, folder, formula, cells, name="timing_rate"):
    """A book whose input of a name holds a formula, and cells of the engineer's own on a sheet Mine."""
    workbook, place = press.opened(), press.place(name)
    mine = workbook.create_sheet("Mine")
    for at, value in cells.items():
        mine[at] = value
    workbook[place.sheet][place.a1] = formula
    path = folder / "fed.xlsx"
    workbook.save(path)
    return path


@pytest.mark.parametrize(
    ("formula", "cells", "value"),
    [
        ("=Mine!A1", {"A1": "=VLOOKUP(2,C1:D2,2,FALSE)", "C1": 1, "D1": 80, "C2": 2, "D2": 90}, 90),
        ("=Mine!A1*2", {"A1": '=IFERROR(1/0,45)'}, 90),
        ("=Mine!A1", {"A1": "=_xlfn.XLOOKUP(2,C1:C2,D1:D2)", "C1": 1, "D1": 80, "C2": 2, "D2": 90}, 90),
        ("=SUM(Mine!A:A)", {"A1": 40, "A2": 50}, 90),
        ("=Mine!B1", {"B1": "=SUM(Mine!A:A)*1", "A1": 40, "A2": 50}, 90),
        ("=SUMIF(Mine!A1:A2,\">45\")+40", {"A1": 40, "A2": 50}, 90),
    ],
)  # fmt: skip
@pytest.mark.sample(2)
def test_own_cells_that_feed_an_input_count_as_agreed(formula, cells, value, press, tmp_path):
    path = fed(press, tmp_path, formula, cells)
    report = verify(path, present("pycel", "formulon"))
    assert report.findings == []
    assert read_inputs(path)[0].master.rate == value
    assert report.not_evaluated == 0


def test_what_no_input_needs_keeps_no_evaluator_from_one_that_is_needed(press, tmp_path):
    cells = {
        "A1": "=90",
        "A2": '=REPT("x",40000)',
        "A3": "=_xlfn.LET(_xlpm.x,1,_xlpm.x)",
        "A4": "=SUM('Summary:Drive MC01'!A1)",
    }
    path = fed(press, tmp_path, "=Mine!A1", cells)
    report = verify(path, present("pycel", "formulon", "ironcalc"))
    assert (report.findings, len(report.own), report.not_evaluated) == ([], 4, 3)


@pytest.mark.parametrize("name", ["my_list", "Figures"])
def test_an_input_that_needs_a_name_or_a_table_is_agreed_or_refused_in_one_line(name, filled, press, tmp_path):
    workbook, place = openpyxl.load_workbook(filled.path), press.place("timing_rate")
    workbook[place.sheet][place.a1] = "=SUM(Figures[size])" if name == "Figures" else "=SUM(my_list)"
    path = tmp_path / "book.xlsx"
    workbook.save(path)
    try:
        assert read_inputs(path)[0].master.rate == 6
    except InputError as error:
        (line,) = error.lines
        assert "in doubt" in line


@pytest.mark.parametrize("formula", ["=RAND()*90", "=Mine!A1", "=Mine!A1+Mine!B1", "=Mine!A2", "=IFERROR(Mine!A1,1)"])
@pytest.mark.sample(2)
def test_own_cells_on_which_no_two_agree_are_refused_in_one_line(formula, press, tmp_path):
    path = fed(press, tmp_path, formula, {"A1": "=RAND()*90", "A2": "=NOSUCHFUNCTION(90)"})
    with pytest.raises(InputError) as caught:
        verify(path)
    (line,) = caught.value.lines
    assert line.startswith(f"fed.xlsx: {press.place('timing_rate')}")


def test_a_declared_formula_that_reads_own_cells_is_still_a_finding(press, tmp_path):
    pair = press.a_number()
    workbook = press.opened()
    workbook.create_sheet("Mine")["A1"] = "=1+1"
    cell = workbook[pair.address.sheet][pair.address.a1]
    cell.value += "+Mine!A1"
    workbook.save(tmp_path / "book.xlsx")
    report = verify(tmp_path / "book.xlsx")
    assert (report.findings[0].kind, report.findings[0].cell) == ("formula", pair.address.a1)
    kinds = {f.kind for f in report.findings if f.cell == pair.address.a1}
    assert "formula" in kinds
    assert kinds & {"value", "follows"}
    assert (len(report.own), report.not_evaluated) == (1, 0)


@pytest.mark.parametrize("function", ["IFERROR", "TODAY"])
def test_a_declared_formula_with_a_foreign_or_volatile_function_is_still_a_finding(function, press, tmp_path):
    pair = press.a_number()
    workbook = press.opened()
    cell = workbook[pair.address.sheet][pair.address.a1]
    cell.value = f"=IFERROR({cell.value[1:]},0)" if function == "IFERROR" else f"{cell.value}+0*TODAY()"
    workbook.save(tmp_path / "book.xlsx")
    found = {(f.kind, f.cell, f.computed) for f in verify(tmp_path / "book.xlsx").findings}
    assert ("function", pair.address.a1, function) in found


# as Excel writes what openpyxl does not know

EXTRAS = b"""<extLst><ext uri="{05C60535-1F16-4fd2-B633-F4F36F0B64E0}"
xmlns:x14="http://schemas.microsoft.com/office/spreadsheetml/2009/9/main">
<x14:sparklineGroups xmlns:xm="http://schemas.microsoft.com/office/excel/2006/main"><x14:sparklineGroup><x14:sparklines>
<x14:sparkline><xm:f>Summary!A1:A4</xm:f><xm:sqref>AZ9</xm:sqref></x14:sparkline></x14:sparklines></x14:sparklineGroup>
</x14:sparklineGroups></ext></extLst>"""
METADATA = b"""<metadata xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"
 xmlns:xda="http://schemas.microsoft.com/office/spreadsheetml/2017/dynamicarray"><metadataTypes count="1">
<metadataType name="XLDAPR" minSupportedVersion="120000" cellMeta="1"/></metadataTypes>
<futureMetadata name="XLDAPR" count="1">
<bk><extLst><ext uri="{bdbb8cdc-fa1e-496e-a857-3c3f30c029c3}"><xda:dynamicArrayProperties fDynamic="1" fCollapsed="0"/>
</ext></extLst></bk></futureMetadata><cellMetadata count="1"><bk><rc t="1" v="0"/></bk></cellMetadata></metadata>"""
CELLS = b"""<row r="9000"><c r="A9000" cm="1"><f t="array" aca="1" ref="A9000:A9002" ca="1">_xlfn.SEQUENCE(3)</f>
<v>1</v></c>
<c r="C9000"><f t="dataTable" ref="C9000:C9002" dt2D="0" dtr="0" r1="B9000"/><v>2</v></c>
<c r="D9000" t="e" vm="1"><f>_xlfn.XLOOKUP(1,A9000:A9002,A9000:A9002)</f><v>#VALUE!</v></c>
<c r="E9000" t="str"><f t="shared" ref="E9000:E9002" si="900">TEXT(A9000,"0")</f><v>1</v></c></row>
<row r="9001"><c r="A9001"><v>2</v></c><c r="C9001"><v>2</v></c>
<c r="E9001" t="str"><f t="shared" si="900"/><v>2</v></c></row>"""


def test_what_excel_writes_of_own_cells(press, tmp_path):
    part = press.part("Timing")
    kind = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/sheetMetadata"
    changes = {
        part: lambda data: sub(rb"(?=</worksheet>)", EXTRAS)(sub(rb"(?=</sheetData>)", CELLS)(data)),
        "[Content_Types].xml": sub(rb"(?=</Types>)", b'<Override PartName="/xl/metadata.xml" ContentType="application/'
                                   b'vnd.openxmlformats-officedocument.spreadsheetml.sheetMetadata+xml"/>'),
        "xl/_rels/workbook.xml.rels": sub(rb"(?=</Relationships>)", b'<Relationship Id="rId900" Type="%s" '
                                          b'Target="metadata.xml"/>' % kind.encode()),
    }  # fmt: skip
    path = repacked(press.path, tmp_path / "book.xlsx", changes, [("xl/metadata.xml", METADATA)])
    report = verify(path, present("pycel", "formulon", "ironcalc", "libreoffice"))
    told = [f"{f.kind} {f.what} {f.computed}" for f in report.findings + report.notices]
    assert told == ["notice sparklineGroups of Timing added"]
    assert {re.sub(r".*!", "", cell) for cell in report.own} == {"A9000", "C9000", "D9000", "E9000", "E9001"}
