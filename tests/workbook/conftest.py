"""Books to test with."""

import pytest

from workbook.build import build


@pytest.fixture
def build_book():
    """Build a machine's workbook at a path, and return the path."""

    def made(machine, path):
        build(machine, path)
        return path

    return made
