"""Books to test with."""

import pytest

from tests.workbook.judging.hands import Known
from tests.workbook.press import registered
from workbook.build import build


@pytest.fixture
def build_book():
    """Build a machine's workbook at a path, and return the path."""

    def made(machine, path):
        build(machine, path)
        return path

    return made


@pytest.fixture(scope="module")
def press(tmp_path_factory):
    """A small book as built, of a press; its template is known while a module's tests run."""
    path = tmp_path_factory.mktemp("press") / "book.xlsx"
    with registered() as machine:
        build(machine, path)
        yield Known(path)
