"""What every template promises: its check by the engine stands before a book, and its variations pass it."""

import pytest

from workbook.build import build
from workbook.errors import InputError
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

BACKWARDS = [{"duration": 0.5, "c0": -4.0}, {"duration": 0.5, "c0": 12.0}]  # s(1) = 1
OWN = {
    "flying-cutter": ("cutter", "law"),
    "indexing-overlap": ("overlap", "transfer", "law"),
}
"""where each machine that must invert its laws takes the own law"""


def backwards(name):
    """The committed description with an own law that moves backwards, where it may not."""
    data = read_machine(TEMPLATES[name].description).model_dump()
    data["laws"]["OWN"]["pieces"] = BACKWARDS
    *path, last = OWN[name]
    entry = data
    for part in path:
        entry = entry[part]
    entry[last] = "OWN"
    return data


@pytest.mark.parametrize("name", OWN)
def test_what_only_the_engine_can_refuse_gets_no_book(name, tmp_path):
    """The model alone takes it: a machine made in Python is checked when it is built."""
    machine = TEMPLATES[name].model.model_validate(backwards(name))
    with pytest.raises(InputError, match=r"law.*: (a law moves backwards|.*the law OWN does not)"):
        build(machine, tmp_path / "book.xlsx")
    assert list(tmp_path.iterdir()) == []
