"""Each printed figure agrees with the engine's to its digits, or docs/validation.md tells why it does not."""

import pytest

from tests.printed.figures import DOCUMENTS, Figure, half_digit

FIGURES = [figure for figures, _ in DOCUMENTS.values() for figure in figures()]


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: f"{figure.section}, {figure.quantity}")
def test_ours_rounds_to_the_printed_digits_or_the_reason_is_given(figure: Figure) -> None:
    assert figure.agrees != bool(figure.reason)
    assert not figure.exact or abs(figure.ours - float(figure.exact)) <= half_digit(figure.exact) * (1 + 1e-6)
