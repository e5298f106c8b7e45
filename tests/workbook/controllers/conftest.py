"""A small book of the cutting machine, and one whose design fails, built once."""

import pytest

from workbook.build import build
from workbook.reading.entries import read_machine
from workbook.templates import TEMPLATES


@pytest.fixture(scope="session")
def machine():
    found = read_machine(TEMPLATES["cutting-machine"].description)
    return found.model_copy(update={"sizes": found.sizes.model_copy(update={"cycle": 12, "law": 4, "own_law": 24})})


@pytest.fixture(scope="session")
def book(machine, tmp_path_factory):
    path = tmp_path_factory.mktemp("books") / "machine.xlsx"
    build(machine, path)
    return path


@pytest.fixture(scope="session")
def axes(machine):
    return TEMPLATES["cutting-machine"].axes(machine)
