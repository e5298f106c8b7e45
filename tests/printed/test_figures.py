"""Each printed figure agrees with ours to its digits, or docs/validation.md tells why it does not."""

import pytest

from docs import validation
from tests.printed.figures import DOCUMENTS, Figure

FIGURES = [figure for figures, _ in DOCUMENTS.values() for figure in figures()]


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: f"{figure.section}, {figure.quantity}")
def test_ours_rounds_to_the_printed_digits_or_the_reason_is_given(figure: Figure) -> None:
    assert figure.agrees != bool(figure.reason)


def test_docs_validation_is_up_to_date() -> None:
    assert validation.PAGE.read_text(encoding="utf-8") == validation.page(), "run python -m docs.validation"
