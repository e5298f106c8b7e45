"""LibreOffice with the add-in, started once."""

import pytest

from tests.functions.calc import Calc
from workbook.functions import publish


@pytest.fixture(scope="session")
def add_in(tmp_path_factory):
    path = tmp_path_factory.mktemp("oxt") / "motion.oxt"
    publish.write_add_in(path)
    return path


@pytest.fixture(scope="session")
def calc(add_in):
    made = Calc()
    made.install(add_in)
    yield made
    made.close()
