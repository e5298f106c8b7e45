"""Titles of sheets that are named by an entry: Excel takes them, and no two of a book are alike."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.fields.texts import LONGEST, RESERVED, sheet_title
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TITLES = {
    "MTP soft": "MTP soft",
    "a/b\\c[d]:e*?": "a-b-c-d--e--",
    "'quoted'": "quoted",
    "x" * 40: "x" * 31,
    "x" * 30 + "'s": "x" * 30,
    "Timing": "Timing (2)",
    "checks": "checks (2)",
    "history": "history (2)",
    "''": "Law",
    "\U0001f529" * 16: "\U0001f529" * 15,
    "stra\u00dfe": "stra\u00dfe (2)",
}


@pytest.mark.parametrize("name", TITLES)
def test_a_sheet_has_a_title_that_excel_takes_and_no_other_has(name):
    assert sheet_title(name, ["About", "Timing", "STRASSE"]) == TITLES[name]


@given(st.lists(st.text(st.characters(blacklist_categories=["Cs", "Cc"]), max_size=50), max_size=6))
def test_whatever_the_names_titles_are_such_as_excel_takes(names):
    """At most 31 units of UTF-16, no : \\ / ? * [ ], no apostrophe at an end, unique but for case (ECMA-376, Excel)."""
    titles = []
    for name in names:
        titles.append(sheet_title(name, titles))
    assert len({title.casefold() for title in (*titles, *RESERVED)}) == len(titles) + len(RESERVED)
    for title in titles:
        assert 0 < len(title.encode("utf-16-le")) <= 2 * LONGEST
        assert not set(title) & set(":\\/?*[]")
        assert title == title.strip("' ")


@pytest.mark.parametrize("template", TEMPLATES)
def test_laws_that_are_called_as_sheets_get_titles_of_their_own(template):
    """Also as those that come later: a law named Cycle made a second sheet of that title."""
    given_ = read_machine(TEMPLATES[template].description)
    own = [sheet.title for sheet in TEMPLATES[template].declare(given_).sheets]
    data = given_.model_dump()
    known = {name.casefold() for name in given_.laws.names}
    data["laws"] |= {title: {"family": "CUB"} for title in own if title.casefold() not in known}
    data["sizes"] |= {"cycle": 12, "law": 4, "motion_pieces": None}
    book = TEMPLATES[template].declare(TEMPLATES[template].model.model_validate(data))
    titles = [sheet.title.casefold() for sheet in book.sheets]
    assert len(titles) > len(own)
    assert len(set(titles)) == len(titles)
