"""The form beside a description's text: all entries of a table, messages at them, and what a field changes."""

import json
import re
import tomllib
from xml.etree.ElementTree import fromstring

import pytest

from workbook.errors import InputError
from workbook.serve.fields import entered, form
from workbook.serve.live import design
from workbook.serve.tables import tables_of, written
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEXT = (FOLDER / "machine.toml").read_text(encoding="utf-8")


def parts(text):
    """The parts of a description's form by their places."""
    return [
        json.loads(one.get("value"))
        for one in read(form("a.toml", text, "[]")).iter("option")
        if "[" in one.get("value")
    ]


def read(html):
    """The elements of a form."""
    closed = re.sub("<(input|wbr)([^>]*)>", r"<\1\2/>", html)
    return fromstring(f"<div>{closed}</div>")


def values(text, part):
    """The values of the fields of a part, by place."""
    found = read(form("a.toml", text, written(tuple(part)))).iter("input")
    return {tuple(json.loads(one.get("data-path"))): one.get("value", "") for one in found}


def entries(data, place=()):
    """Every number, text and choice of a description, by place."""
    if isinstance(data, dict):
        return {path: value for key, one in data.items() for path, value in entries(one, (*place, key)).items()}
    if isinstance(data, list) and data and (isinstance(data[0], dict | list) or place[-1].isdigit()):
        return {path: value for k, one in enumerate(data) for path, value in entries(one, (*place, str(k))).items()}
    return {place: data}


@pytest.mark.parametrize("template", TEMPLATES)
def test_the_form_has_a_field_with_its_value_for_every_entry_of_a_description(template):
    text = (FOLDER / f"{template}.toml").read_text(encoding="utf-8")
    shown = {}
    for part in parts(text):
        shown |= values(text, part)
    for place, value in entries(tomllib.loads(text)).items():
        if value and place[0] != "laws":
            told = shown[place]
            assert (told if isinstance(value, str) else tomllib.loads(f"x = {told}")["x"]) == value


def test_a_field_sets_its_entry_and_no_other():
    before = design("a.toml", TEXT).machine.model_dump()
    text = entered("a.toml", TEXT, '["axes", "1", "phases", "0", "stop"]', "Set", "140")
    after = design("a.toml", text).machine.model_dump()
    before["axes"][1]["phases"][0]["stop"] = 140.0
    assert after == before


def test_an_emptied_field_takes_the_entry_away():
    text = entered("a.toml", TEXT, '["axes", "3", "shift"]', "Set", " ")
    assert "shift" not in tomllib.loads(text)["axes"][3]
    assert entered("a.toml", text, '["axes", "3", "shift"]', "Set", "") == text


def test_what_a_field_does_not_take_is_told_at_it():
    text = entered("a.toml", TEXT, '["axes", "1", "mechanism", "lead"]', "Set", "5,5")
    field = next(one for one in read(form("a.toml", text, '["axes", "1"]')).iter("input") if one.get("value") == "5,5")
    assert (field.get("aria-invalid"), json.loads(field.get("data-path"))[-1]) == ("true", "lead")
    row = next(row for row in read(form("a.toml", text, '["axes", "1"]')).iter("tr") if field.get("data-path") in
               [one.get("data-path") for one in row.iter("input")])  # fmt: skip
    assert "expected a number greater than 0" in "".join(row.itertext())


def test_phases_that_overlap_are_told_at_their_table():
    text = entered("a.toml", TEXT, '["axes", "1", "phases", "0", "stop"]', "Set", "310")
    said = design("a.toml", text).machine.design.faults[0].message
    shown = read(form("a.toml", text, '["axes", "1"]'))
    assert said in [one.text for one in shown.iter() if one.get("class") == "disagrees"]


def test_rows_and_tables_are_added_copied_and_removed():
    data = tomllib.loads(entered("a.toml", TEXT, '["axes", "1", "phases", "0"]', "Copy", ""))
    assert data["axes"][1]["phases"][2] == data["axes"][1]["phases"][0]
    data = tomllib.loads(entered("a.toml", TEXT, '["axes", "0"]', "Remove", ""))
    assert [axis["name"] for axis in data["axes"]] == ["MC02", "MC03", "MC04"]
    for place in (("axes", "2", "mechanism"), ("axes", "2", "load"), ("export",), ("laws", "PO7")):
        text = entered("a.toml", TEXT, json.dumps(place), "Add", "")
        assert next(one.entries for one in tables_of("machine", tomllib.loads(text)) if one.place == place) is not None
        assert "Not yet" not in form("a.toml", text, json.dumps(place[:2]))
        design("a.toml", text)


def test_another_kind_of_mechanism_has_its_own_entries():
    text = entered("a.toml", TEXT, '["axes", "1", "mechanism", "kind"]', "Set", "rack and pinion")
    mechanism = tomllib.loads(text)["axes"][1]["mechanism"]
    assert set(mechanism) == {"kind", "efficiency", "pinion_diameter"}
    assert not design("a.toml", text).machine.design.faults


def test_what_is_no_place_of_an_entry_is_told():
    for path in ('["axes", "1", "nothing"]', '["axes"]', "{}", "[]", '["axes", "9", "name"]'):
        with pytest.raises(InputError):
            entered("a.toml", TEXT, path, "Set", "1")
