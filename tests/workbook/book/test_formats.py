"""How numbers are shown: four digits that count, and what is rounding as nothing."""

import pytest

from workbook.book.declare import calc
from workbook.book.quantity import number_format


@pytest.mark.parametrize(
    ("value", "look"),
    [
        (-1.1e-16, "0.0000"),
        (0.0, "0.0000"),
        (2e-9, "0.000E+00"),
        (0.0345, "0.0000"),
        (9.5, "0.000"),
        (12345.6, "0"),
        (0.9999999999999999, "0.000"),
        (1.0000000000000002, "0.000"),
        (999999.9999999999, "0.000E+00"),
    ],
)
def test_a_number_has_the_decimals_of_its_size_and_rounding_has_none(value, look):
    assert number_format(calc("s", "position", "", "", "=0", value), value) == look
