"""The cells that have a printed figure, beside the engine; and the page that shows both."""

import pytest

from docs import validation
from tests.printed.figures import DOCUMENTS

FIGURES = [figure for figures, _ in DOCUMENTS.values() for figure in figures() if figure.cell]


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: f"{figure.section}, {figure.quantity}")
def test_the_cell_of_a_printed_figure_has_what_the_engine_has(figure) -> None:
    assert validation.cell_value(figure) == pytest.approx(figure.ours, rel=1e-7)


def test_docs_validation_is_up_to_date() -> None:
    assert validation.PAGE.read_text(encoding="utf-8") == validation.page(), "run python -m docs.validation"
