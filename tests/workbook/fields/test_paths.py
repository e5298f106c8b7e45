"""Paths to entries: what is split is joined again, what is put is got, and all else stays as it was."""

import copy

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.fields.paths import get, has_key, join, leaves, put, replaced, spell, split, spread

NAMES = st.text(st.characters(exclude_characters='"', exclude_categories=["C"]), min_size=1, max_size=8)
TABLES = st.recursive(
    st.floats(-1e3, 1e3), lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from("abc"), inner)
)


@given(NAMES, st.lists(st.sampled_from(["durations", "0", "12", "share"]), max_size=3))
def test_the_key_of_a_path_is_split_into_it(name, below):
    path = ("laws", name, *below)
    assert split(join(path)) == path


@pytest.mark.parametrize("name", ['a"b', "a.b", "MTP[2]", "a'b", "2 x"])
def test_a_laws_name_may_have_the_signs_of_a_path(name):
    assert split(join(("laws", name, "durations", "1"))) == ("laws", name, "durations", "1")
    assert spell(join(("laws", name, "durations", "1"))).endswith("durations[2]")


@given(st.dictionaries(st.sampled_from("abc"), TABLES, min_size=1), st.data())
def test_one_entry_is_put_and_the_others_stay(data, draw):
    before = dict(leaves(copy.deepcopy(data)))
    path = draw.draw(st.sampled_from([("d", "1", "e"), *before]))
    put(data, path, 7.0)
    assert get(data, path) == 7.0
    assert has_key(data, join(path))
    assert {place: get(data, place) for place in before if place != path} == {
        place: value for place, value in before.items() if place != path
    }


@given(st.dictionaries(st.sampled_from("abc"), TABLES, min_size=1))
def test_a_copy_with_another_entry_leaves_the_first_as_it_was(data):
    before = copy.deepcopy(data)
    for path, value in leaves(before):
        assert get(replaced(data, path, 9.0), path) == 9.0
        assert get(data, path) == value
    assert data == before


def test_a_pattern_names_every_row_and_of_an_empty_list_the_first():
    data = {"axes": [{"phases": [{"lift": 1.0}, {"lift": 2.0}]}, {"phases": []}]}
    assert dict(spread(data, ("axes", "*", "phases", "*", "lift"))) == {
        ("axes", "0", "phases", "0", "lift"): 1.0,
        ("axes", "0", "phases", "1", "lift"): 2.0,
    }
    assert [place for place, _ in spread(data, ("switches", "*"))] == [("switches", "0")]
