"""One unit for one kind of quantity over the whole of a book."""

import pytest

from workbook.book.rows import as_rows
from workbook.build import committed_descriptions
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

POWERS = {"W", "kW", "MW"}


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_power_has_one_unit_and_no_more_than_three_digits_before_the_point(path):
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    powers = [(block, q) for block in book.blocks.values() for q in block.quantities if q.unit in POWERS]
    assert len({q.unit for _, q in powers}) <= 1
    values = (value for block, q in powers for value in as_rows(q.value, block.size, q.name) if value is not None)
    largest = max(map(abs, values), default=0.0)
    assert largest < 1000
