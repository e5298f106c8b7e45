"""Bad input through the command: exit code 2, a line that names the place and what is expected, nothing written."""

import subprocess
import sys
from pathlib import Path

import openpyxl
import pytest

from tests import cutting
from tests.workbook import composed
from workbook.build import build
from workbook.reading import files
from workbook.reading.descriptions import read_machine, write_machine

TEXT = cutting.DESCRIPTION.read_text(encoding="utf-8")
MTP = "[laws.MTP]\ndurations = {}\n\n[selection]"


@pytest.fixture
def refused(motionbook, monkeypatch, tmp_path):
    """Run a command that must fail; return what it says, after the checks that hold for every failure."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        before = contents(tmp_path)
        code, *said = motionbook(*arguments)
        assert code == 2, said
        assert "".join(said).strip()
        assert contents(tmp_path) == before
        return "".join(said)

    return run


def contents(folder):
    """Every file below a folder with its bytes."""
    return {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@pytest.fixture(scope="module")
def layout():
    return composed.small()


@pytest.fixture(scope="module")
def declared(layout):
    return cutting.TEMPLATE.declare(layout)


@pytest.fixture(scope="module")
def book(layout, tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(layout, path)
    return path


@pytest.fixture(scope="module")
def opened(book):
    """The book in openpyxl, without its charts, which take half the time to save; each test leaves it as it was."""
    workbook = openpyxl.load_workbook(book)
    for sheet in workbook.worksheets:
        sheet._charts = []
    return workbook


@pytest.fixture
def small(layout, tmp_path):
    """A description whose book is quickly built."""
    path = tmp_path / "small.toml"
    path.write_text(write_machine(layout), encoding="utf-8")
    return path


DESCRIPTIONS = {
    "TOML syntax": ("rate = 100.0", "rate = = 100", ["not valid TOML", "line"]),
    "unknown entry": ("rate = 100.0", "rate = 100.0\nspeed = 3", ["master.speed", "unknown", "expected one of rate"]),
    "missing table": ("[master]", "[shaft]", ["master", "expected the entries rate"]),
    "unknown template": ('"machine"', '"saw"', ["template", "'saw'", "machine"]),
    "no template": ('template = "machine"', "", ["template", "empty", "machine"]),
    "unknown law": ('law = "ACS" },', 'law = "MPT" },', ["axes[1].phases[1].law", "'MPT'", "MTP"]),
    "text for a number": ("rate = 100.0", 'rate = "fast"', ["master.rate", "'fast'", "expected a number"]),
    "logical value for a number": ("rate = 100.0", "rate = true", ["master.rate", "TRUE", "expected a number"]),
    "date for a number": ("rate = 100.0", "rate = 2020-01-02", ["master.rate", "2020-01-02", "expected a number"]),
    "not a number": ("rate = 100.0", "rate = nan", ["master.rate", "nan", "expected a number"]),
    "infinite": ("rate = 100.0", "rate = inf", ["master.rate", "inf", "expected a number"]),
    "two axes of one name": ('name = "MC02"', 'name = "MC01"', ["axes[2].name", "'MC01'", "a name of its own"]),
    "drive of no kind": ('kind = "feed rollers"', 'kind = "feed roller"', ["axes[1].mechanism.kind", "'feed roller'"]),
    "drive without a kind": (
        'kind = "feed rollers"',
        "",
        ["axes[1].mechanism.kind", "empty; expected lead screw, conv"],
    ),
    "size of another kind": (
        "roller_radius = 134.0",
        "pulley_diameter = 134.0",
        ["axes[1].mechanism.pulley_diameter", "unknown entry; expected one of kind, efficiency, roller_radius"],
    ),
    "decimal comma": (
        "roller_radius = 134.0",
        "roller_radius = 134,5",
        ["134,5 has a decimal comma", "a point, 134.5"],
    ),
    "decimal comma in a row": ("lift = 300.0", "lift = 300,5", ["300,5 has a decimal comma; expected a point, 300.5"]),
    "six durations": (
        "[selection]",
        MTP.format([0.2, 0.2, 0.2, 0.2, 0.1, 0.1]),
        ["laws.MTP.durations", "expected 7 entries"],
    ),
    "more phases than rows": ("phases = 6 ", "phases = 2 ", ["axes[2].phases", "5 rows", "raise sizes.phases"]),
    "formula for a name": ('name = "MC02"', 'name = "=1+1"', ["axes[2].name", "'=1+1'", "does not begin with ="]),
    "control character": ('title = "Cutting machine"', 'title = "Cutting\\u0007"', ["title", "expected a text"]),
}


@pytest.mark.parametrize(("old", "new", "parts"), DESCRIPTIONS.values(), ids=DESCRIPTIONS.keys())
def test_description_is_refused(old, new, parts, refused, tmp_path):
    assert old in TEXT
    (tmp_path / "machine.toml").write_text(TEXT.replace(old, new, 1), encoding="utf-8")
    said = refused("build", "machine.toml", "-o", "book.xlsx")
    assert said.startswith("machine.toml: ")
    assert [part for part in parts if part not in said] == []


def test_every_fault_has_its_line(refused, tmp_path):
    (tmp_path / "machine.toml").write_text(
        TEXT.replace("= 200.0", '= "x"').replace("= 0.95", '= "7"'), encoding="utf-8"
    )
    assert len(refused("build", "machine.toml").splitlines()) == 2


def test_whole_numbers_are_numbers(tmp_path):
    path = tmp_path / "machine.toml"
    path.write_text("\ufeff" + TEXT.replace("200.0", "200"), encoding="utf-8")  # Windows' Notepad puts a mark first
    assert read_machine(path) == cutting.described()


CELLS = {
    "text for a number": ("timing_cycle", "timing_cycle", 0, "fast", ["'fast'", "expected a number greater than 0"]),
    "logical value": ("timing_cycle", "timing_cycle", 0, True, ["TRUE", "expected a number"]),
    "unknown law": ("axis1", "law", 1, "MPT", ["'MPT'", "MTP"]),
    "logical value for a name": ("axes", "name", 0, True, ["TRUE", "expected a text"]),
    "error value": ("timing_cycle", "timing_cycle", 0, "#DIV/0!", ["#DIV/0!", "expected a number"]),
}  # fmt: skip
TRIED = [(name, "inputs") for name in CELLS] + [("unknown law", "verify"), ("unknown law", "regenerate")]


@pytest.mark.parametrize(("name", "command"), TRIED)
def test_cell_is_refused(name, command, refused, opened, declared, tmp_path):
    block, quantity, row, value, parts = CELLS[name]
    cell = cell_of(opened, declared, block, quantity, row)
    right, cell.value = cell.value, value
    opened.save(tmp_path / "edited.xlsx")
    cell.value = right
    said = refused(command, "edited.xlsx", *(["-o", "new.xlsx"] if command == "regenerate" else []))
    told = cell_of(opened, declared, block, quantity, row)
    assert f"edited.xlsx: {told.parent.title}!{told.coordinate}" in " ".join(said.split())
    assert [part for part in parts if part not in said] == []


def cell_of(workbook, declared, block, quantity, row):
    place = declared.blocks[block]
    return workbook[place.sheet.title].cell(place.row + row, place.columns[quantity])


@pytest.mark.parametrize(
    ("name", "part"), [("missing.toml", "no such file"), ("folder", "folder"), ("book.xlsx", "TOML|toml")]
)
def test_description_of_another_kind_is_refused(name, part, refused, book, tmp_path):
    (tmp_path / "folder").mkdir()
    (tmp_path / "book.xlsx").write_bytes(book.read_bytes())
    said = refused("build", name, "-o", "new.xlsx")
    assert any(word in said for word in part.split("|"))


def test_output_open_elsewhere_is_refused(refused, monkeypatch, small, tmp_path):
    (tmp_path / "book.xlsx").write_bytes(b"open in Excel")

    def locked(self, target):
        raise PermissionError(13, "The process cannot access the file", str(target))

    monkeypatch.setattr(Path, "replace", locked)
    assert "close it in the other program" in refused("build", small, "-o", "book.xlsx", "--force")


def test_book_open_elsewhere_is_refused(refused, monkeypatch, book, tmp_path):
    (tmp_path / "book.xlsx").write_bytes(book.read_bytes())

    def locked(*_, **__):
        raise PermissionError(13, "The process cannot access the file")

    monkeypatch.setattr(files, "ExcelReader", locked)
    assert "close it in the other program" in refused("inputs", "book.xlsx")


def test_the_program_ends_with_2(tmp_path):
    command = [sys.executable, "-m", "workbook", "verify", "missing.xlsx"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == "missing.xlsx: there is no such file\n"
    assert not list(tmp_path.iterdir())
