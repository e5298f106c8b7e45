"""The menu Motion in a headless Calc: each command once, on the document in memory; a single Calc carries out all."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.scale import of_axes
from tests import cutting
from tests.workbook import press
from workbook.build import build
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import libreoffice_path

HERE = Path(__file__).parents[2]
DRIVER = Path(__file__).with_name("drive_menu.py")
PYTHON = "/usr/bin/python3"  # Debian's, which LibreOffice takes
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="it drives Debian's LibreOffice by its Python")


def driven(calc, folder, *books):
    """Return what the commands of the menu did; Calc runs as who runs the tests."""
    program = folder / "python"  # motionbook, as the menu begins it, knows the press
    program.write_text(
        f'#!/bin/sh\nPYTHONPATH={HERE} exec {sys.executable} {HERE / "tests/functions/run_press.py"} "$@"\n'
    )
    program.chmod(0o755)
    for place in calc.profile.rglob("motionbook_python.py"):  # two, until Calc has started once
        text = place.read_text(encoding="utf-8")
        place.write_text(text.replace(repr(sys.executable), repr(str(program))), encoding="utf-8")
    line = [libreoffice_path(), "--headless", "--norestore", f"--accept=pipe,name=motionbook{os.getpid()};urp"]
    line.append(f"-env:UserInstallation={calc.profile.as_uri()}")
    # LibreOffice's Python takes the library of the first python3 on the path: there it has to be Debian's
    here = os.environ | {"TMPDIR": str(folder / "temporary"), "PATH": os.defpath}
    (folder / "temporary").mkdir()
    with subprocess.Popen(line, start_new_session=True, stdout=subprocess.DEVNULL, env=here) as office:
        try:
            driver = [PYTHON, DRIVER, f"motionbook{os.getpid()}", folder, program, *books]
            done = subprocess.run(driver, capture_output=True, text=True, timeout=900, env=here)
            assert done.returncode == 0, done.stderr
        finally:
            os.killpg(office.pid, signal.SIGKILL)  # it shows a dialog
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def books(tmp_path_factory):
    folder = tmp_path_factory.mktemp("menu")
    machine = TEMPLATES["machine"].model.model_validate(cutting.small(cycle=12, law=4).model_dump())
    build(machine, folder / "small.xlsx")
    with press.registered() as small:
        build(small, folder / "press.xlsx")
    return folder / "press.xlsx", folder / "small.xlsx"


@pytest.fixture(scope="module")
def came(calc, books):
    before = [book.read_bytes() for book in books]
    came = driven(calc, books[0].parent, *books)
    assert [book.read_bytes() for book in books] == before
    return came


def test_a_document_that_is_no_book_is_told_in_a_sentence(came):
    assert any("not a workbook of motionbook" in line for line in came["other"]["no book"])


def test_without_motionbook_the_menu_says_in_a_sentence_what_to_do(came):
    assert "motionbook addin" in came["other"]["absent"][1]


def test_a_damaged_document_is_verified_and_a_click_goes_to_the_cell(came):
    sentence, finding, follows = came["damaged"]["verified"][1:]
    assert sentence.startswith("Disagrees: 1 finding")
    assert "Cycle time: 1; expected " in finding
    assert "Cycles in a cycle: 2.0; expected 1.0" in follows
    sheet, cell = finding.partition("  ")[0].split("!")
    assert came["damaged"]["went"].replace("$", "") == f"{sheet}.{cell}"


def test_marks_come_and_go_and_leave_the_document_as_it_was(came):
    did = came["damaged"]
    description, _ = did["marked"]
    assert description.startswith("is: 1\nshould be: ")
    assert "\nformula: =60/timing_rate" in description
    assert (did["undo"], did["undone"], did["cleared"], did["same"]) == ("Mark findings", [], [], True)
    assert did["redone"] == did["marked"]


def test_a_formula_is_put_back_and_undo_takes_that_back(came):
    assert (came["damaged"]["now"], came["damaged"]["taken back"]) == (came["damaged"]["formula"], 1.0)


def test_it_verifies_as_one_types_until_it_is_turned_off(came):
    did = came["beside"]
    assert did["typed"][1].startswith("Agrees")
    assert did["wrong"][1].startswith("Disagrees: 1 finding")
    assert did["right"][1].startswith("Agrees")
    assert not any("Verifying" in line for line in did["off"])


def test_work_is_cancelled(came):
    assert came["beside"]["cancelled"][1] == "Cancelled."


def test_two_documents_do_not_mix(came):
    assert not came["beside"]["mixed"]


def test_the_axis_under_the_cursor_is_exported_with_its_certificate(came):
    did = came["exported"]
    assert did["book_layout"][0].startswith("No axis is under the cursor")
    assert did["drive1_use_rms"] == [f"Exporting {did['name']}; Motion > Cancel ends it.", False]
    assert "read back and rebuilt: off by at most position " in did["axis1"][0]
    assert did["axis1"][1]


def test_a_document_is_regenerated_with_a_sheet_of_ones_own(came):
    did = came["regenerated"]
    assert (did["url"], did["sheets"], did["own"]) == ("", True, 88.0)
    assert did["formula"] == came["damaged"]["formula"]


def test_insert_opens_the_list_of_functions(came):
    assert any("Function" in title for title in came["inserted"])


def test_nothing_is_left_of_the_work(came, books):
    assert came["left"] == []
    assert {path.suffix for path in books[0].parent.iterdir() if path.is_file()} == {"", ".xlsx", ".ods", ".csv"}


@pytest.mark.nightly
def test_a_machine_of_24_axes_is_verified_in_memory_while_calc_stays_free(calc, tmp_path):
    build(of_axes(24), tmp_path / "large.xlsx")
    came = driven(calc, tmp_path, tmp_path / "large.xlsx")
    assert any(line.startswith("Verifying") for line in came["meanwhile"])
    assert came["clean"][1].startswith("Agrees")
    sentence, finding, *_ = came["damaged"][1:]
    assert sentence.startswith("Disagrees")
    assert "; expected " in finding
