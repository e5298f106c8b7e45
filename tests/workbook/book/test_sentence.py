"""Amounts in sentences: four decimals, told from each other by the last of them."""

import pytest

from workbook.book.sentence import Sentence, bound, rounded

SHOWN = [(770.84842, "770.8484"), (12.34567, "12.3457"), (0.0012346, "0.0012"), (-0.70566, "-0.7057"), (25.0, "25"),
         (12345.67, "12345.67"), (1e-9, "0"), (-3e-12, "0"), (9.99996, "10"), (0.0, "0")]  # fmt: skip


@pytest.mark.parametrize(("value", "text"), SHOWN)
def test_an_amount_has_four_decimals(value, text):
    assert rounded(value) == text


@pytest.mark.parametrize("value", [0.0123, 0.5, 3.0, 95.5, 770.8, 12345.6])
def test_amounts_that_differ_by_more_than_the_last_digit_are_told_apart(value):
    step = 2e-4 + 2e-9 * value
    said = Sentence(f"{rounded(value)} Nm too much")
    assert said.says(f"{rounded(value)} Nm too much".replace(".", ","))
    assert not said.says(f"{rounded(value + step)} Nm too much")


@pytest.mark.parametrize(
    ("value", "text"),
    [(215.6571, "215.6"), (99.99, "99.9"), (3.1416, "3.1"), (0.0, "0"), (1e-10, "0"), (2e5, "2e5")],
)
def test_what_holds_up_to_an_amount_is_never_told_above_it(value, text):
    told = float(bound("@highest", value, "", "").said)
    assert told == pytest.approx(float(text), rel=2e-6)
    assert told <= value


@pytest.mark.parametrize("value", [200.0, 0.1, 12.5, 3000.0])
def test_an_amount_of_one_decimal_is_told_whole_on_both_sides_of_its_rounding(value):
    told = {bound("@highest", value * (1 + error), "", "").said for error in (-1e-9, 0.0, 1e-9)}
    assert told == {f"{value:g}"}
