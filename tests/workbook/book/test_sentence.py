"""Amounts in sentences: four decimals, told from each other by the last of them."""

import pytest

from workbook.book.sentence import Sentence, as_shown

SHOWN = [(770.84842, "770.8484"), (12.34567, "12.3457"), (0.0012346, "0.0012"), (-0.70566, "-0.7057"), (25.0, "25"),
         (12345.67, "12345.67"), (1e-9, "0"), (-3e-12, "0"), (9.99996, "10"), (0.0, "0")]  # fmt: skip


@pytest.mark.parametrize(("value", "text"), SHOWN)
def test_an_amount_has_four_decimals(value, text):
    assert as_shown(value) == text


@pytest.mark.parametrize("value", [0.0123, 0.5, 3.0, 95.5, 770.8, 12345.6])
def test_amounts_that_differ_by_more_than_the_last_digit_are_told_apart(value):
    step = 2e-4 + 2e-9 * value
    said = Sentence(f"{as_shown(value)} Nm too much")
    assert said.says(f"{as_shown(value)} Nm too much".replace(".", ","))
    assert not said.says(f"{as_shown(value + step)} Nm too much")
