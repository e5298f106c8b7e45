"""What ``inputs`` and ``regenerate`` carry over, and what they name that stays behind."""

import zipfile

import openpyxl
import pytest
from openpyxl.chart import Reference, ScatterChart, Series
from openpyxl.comments import Comment
from openpyxl.formatting.rule import CellIsRule
from openpyxl.styles import PatternFill
from openpyxl.workbook.defined_name import DefinedName

from workbook import build as making
from workbook import file_cache
from workbook.build import build, read_inputs
from workbook.commands import make
from workbook.reading.descriptions import read_machine, write_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing.archive import same_book

DESCRIPTION = FOLDER / "motion-composer.toml"


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(read_machine(DESCRIPTION), path)
    return path


def own_text(book):
    book["Timing"]["T5"] = "ask Anna about this"


def own_number(book):
    book["Timing"]["T6"] = 42


def note(book):
    book["Timing"]["D9"].comment = Comment("checked on 3 May", "Anna")


def chart(book):
    drawn, sheet = ScatterChart(), book["Timing"]
    drawn.series.append(Series(Reference(sheet, range_string="Timing!$C$80:$C$90"), title="mine"))
    drawn.title = "mine"
    sheet.add_chart(drawn, "Z99")


def name(book):
    book.defined_names["my_own"] = DefinedName("my_own", attr_text="Timing!$A$1")


def rule(book):
    fill = PatternFill(bgColor="FFFF00", fill_type="solid")
    book["Timing"].conditional_formatting.add("D9:D12", CellIsRule(operator="greaterThan", formula=["5"], fill=fill))


def sheet(book):
    book.create_sheet("Mine")["A1"] = "mine"


OWN = {
    "a text": (own_text, "texts and numbers on the sheet 'Timing' are not carried over: T5"),
    "a number": (own_number, "texts and numbers on the sheet 'Timing' are not carried over: T6"),
    "a note": (note, "notes on the sheet 'Timing' are not carried over: D9"),
    "a chart": (chart, "charts on the sheet 'Timing' are not carried over: Z99"),
    "a name": (name, "names of your own are not carried over: my_own"),
    "a rule": (rule, "conditional formats on the sheet 'Timing' are not carried over: D9:D12"),
    "a sheet": (sheet, "the sheet 'Mine' is not carried over: it is none of the generated ones"),
}


@pytest.mark.parametrize("what", OWN)
@pytest.mark.sample(2)
def test_what_is_left_behind_is_named(what, built, tmp_path):
    put, line = OWN[what]
    book = openpyxl.load_workbook(built)
    put(book)
    book.save(tmp_path / "edited.xlsx")
    machine, notes = read_inputs(tmp_path / "edited.xlsx")
    assert notes == [line]
    assert machine == read_machine(DESCRIPTION)


def test_pictures_and_text_boxes_are_counted(built, tmp_path):
    path = tmp_path / "drawn.xlsx"
    box = b'<xdr:oneCellAnchor><xdr:sp macro=""><xdr:txBody/></xdr:sp></xdr:oneCellAnchor></xdr:wsDr>'
    with zipfile.ZipFile(built) as old, zipfile.ZipFile(path, "w") as new:
        for part in old.namelist():
            data = old.read(part)
            new.writestr(part, data.replace(b"</xdr:wsDr>", box) if "drawing1" in part else data)
    assert read_inputs(path)[1] == ["shapes and text boxes are not carried over: 1 in all"]


def test_the_committed_catalogues_are_referred_to(tmp_path):
    """Also where other ones lie beside the description; one that was changed is told in full."""
    machine = read_machine(TEMPLATES["flying-cutter"].description)
    text = write_machine(machine)
    assert text.count("[[selection.motors]]") == text.count("[[selection.reducers]]") == 0
    assert text.count('"committed"') == 2
    (tmp_path / "machine.toml").write_text(text, encoding="utf-8")
    head = "name,inertia_kgcm2,rated_torque_Nm,peak_torque_Nm,max_speed_rpm"
    (tmp_path / "motors.csv").write_text(f"{head}\nX,0.01,2,3,3000\n", encoding="utf-8")
    again = read_machine(tmp_path / "machine.toml")
    assert again == machine
    build(machine, tmp_path / "one.xlsx")
    build(again, tmp_path / "other.xlsx")
    assert same_book(tmp_path / "one.xlsx", tmp_path / "other.xlsx")
    data = machine.model_dump()
    data["selection"]["motors"][0]["mass"] = 3.21
    assert "mass = 3.21" in write_machine(type(machine).model_validate(data))


def test_what_was_read_of_the_same_bytes_is_remembered_with_its_notes(built, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(file_cache, "folder", lambda: tmp_path / "remembered")
    book = openpyxl.load_workbook(built)
    own_number(book)
    book.save(tmp_path / "edited.xlsx")
    make.inputs(tmp_path / "edited.xlsx", tmp_path / "first.toml", force=False)
    first = capsys.readouterr()
    assert OWN["a number"][1] in " ".join((first.out + first.err).split())
    monkeypatch.setattr(making, "read_inputs", lambda path: pytest.fail("read again"))
    make.inputs(tmp_path / "edited.xlsx", tmp_path / "again.toml", force=False)
    assert capsys.readouterr().err == first.err
    assert (tmp_path / "again.toml").read_text("utf-8") == (tmp_path / "first.toml").read_text("utf-8")
    own_text(book)
    book.save(tmp_path / "edited.xlsx")
    with pytest.raises(pytest.fail.Exception):
        make.inputs(tmp_path / "edited.xlsx", None, force=False)
