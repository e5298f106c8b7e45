"""A small book of two axes, built once, the cutting machine's axes, and the command in a folder of its own."""

import pytest

from tests import cutting
from tests.workbook.controllers.examples import TEXT, build_described
from workbook import build as making
from workbook.judging.batch import file_digest


@pytest.fixture(scope="session")
def machine():
    return cutting.described()


@pytest.fixture(scope="session")
def axes(machine):
    return cutting.TEMPLATE.axes(machine)


@pytest.fixture(scope="session")
def book(tmp_path_factory):
    build_described(TEXT, path := tmp_path_factory.mktemp("books") / "two.xlsx")
    return path


@pytest.fixture(scope="session")
def read_once():
    """What reads the entries of a book, and the same bytes but once."""
    known, read = {}, making.read_inputs

    def inputs(path):
        found = file_digest(path)
        if found not in known:
            known[found] = read(path)
        return known[found]

    return inputs


@pytest.fixture
def run(motionbook, monkeypatch, tmp_path):
    """Run a command within an empty folder; return its exit code and what it says."""
    monkeypatch.chdir(tmp_path)
    return motionbook
