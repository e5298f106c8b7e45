"""The menu Motion in a headless Calc: the document in memory verified, its findings marked, unmarked, put back."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests import cutting
from workbook.build import build
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import libreoffice_path

DRIVER = Path(__file__).with_name("drive_menu.py")
PYTHON = "/usr/bin/python3"  # Debian's, which LibreOffice takes
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="it drives Debian's LibreOffice by its Python")


def driven(calc, folder, beginning, *books):
    """Return what the commands of the menu did; Calc runs as who runs the tests."""
    line = [libreoffice_path(), "--headless", "--norestore", f"--accept=pipe,name=motionbook{os.getpid()};urp"]
    line.append(f"-env:UserInstallation={calc.profile.as_uri()}")
    with subprocess.Popen(line, start_new_session=True, stdout=subprocess.DEVNULL) as office:
        try:
            driver = [PYTHON, DRIVER, f"motionbook{os.getpid()}", folder, beginning, *books]
            done = subprocess.run(driver, capture_output=True, text=True, timeout=900)
            assert done.returncode == 0, done.stderr
            office.wait(60)
        finally:
            if office.poll() is None:
                os.killpg(office.pid, signal.SIGKILL)
    return json.loads(done.stdout)


def test_the_commands_of_the_menu_on_a_damaged_book_and_on_another_document(calc, tmp_path):
    machine = TEMPLATES["machine"].model.model_validate(cutting.small(cycle=12, law=4).model_dump())
    build(machine, tmp_path / "small.xlsx")
    before = (tmp_path / "small.xlsx").read_bytes()
    came = driven(calc, tmp_path, "This document", tmp_path / "small.xlsx")
    assert any("not a workbook of motionbook" in line for line in came["other"])
    (book,) = came["books"]
    sentence, finding = book["verified"][1:]
    assert sentence.startswith("FAIL: 1 findings in ")
    assert "Fingerprint of today's entries: 1; expected " in finding
    (description,) = book["marked"]
    assert description.startswith("is: 1\nshould be: ")
    assert "\nformula: =SUMPRODUCT(" in description
    assert (book["undo"], book["undone"], book["cleared"], book["same"]) == ("Mark findings", [], [], True)
    assert book["redone"] == book["marked"]
    assert (book["now"], book["taken back"]) == (book["formula"], 1.0)
    assert (tmp_path / "small.xlsx").read_bytes() == before
    assert {path.name for path in tmp_path.iterdir()} == {"small.xlsx", "before.ods", "after.ods"}


def test_without_motionbook_the_menu_says_in_a_sentence_what_to_do(calc, tmp_path):
    places = list(calc.profile.rglob("motionbook_python.py"))  # two, until Calc has started once
    text = places[0].read_text(encoding="utf-8")
    for place in places:
        place.write_text("PYTHON = '/nowhere/python'\n", encoding="utf-8")
    try:
        came = driven(calc, tmp_path, "motionbook does not answer")
    finally:
        for place in places:
            if place.exists():
                place.write_text(text, encoding="utf-8")
    assert "motionbook addin" in came["other"][1]
