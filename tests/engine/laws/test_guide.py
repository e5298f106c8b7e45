"""docs/laws.md lists every family with its names, parameters and figures, as the engine has them."""

from docs.laws import PAGE, page


def test_the_tables_of_the_guide_are_those_of_the_catalogue() -> None:
    assert PAGE.read_text(encoding="utf-8") == page(), "run python -m docs.laws"
