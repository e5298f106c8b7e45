"""The small book that tests of the judge change."""

import pytest

from tests.workbook.judging.hands import Known
from tests.workbook.press import registered
from workbook.build import build


@pytest.fixture(scope="module")
def press(tmp_path_factory):
    """The press as built; its template is known while a module's tests run."""
    path = tmp_path_factory.mktemp("press") / "book.xlsx"
    with registered() as machine:
        build(machine, path)
        yield Known(path)
