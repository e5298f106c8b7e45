"""Entries as people type them, and parts that are added: what is taken works, what is refused leaves the file alone."""

import tomllib
from contextlib import suppress

import pytest
import tomlkit

from workbook.errors import InputError, ReadError
from workbook.fields.paths import get, put, split
from workbook.serve import design as designs
from workbook.serve.design import Edited, edited_design, figures, verdict, worked_out
from workbook.serve.parts import apply_changes
from workbook.serve.tables import schema
from workbook.serve.typed import number
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEXT = (FOLDER / "machine.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("112,5", "°", 112.5), ("112.5 °", "°", 112.5), ("25000 g", "kg", 25.0), ("4500 rpm", "rpm", 4500.0),
        ("20+5", "mm", 25.0), ("2.5e1", "", 25.0), ("-,5", "mm", -0.5), ("−3", "mm", -3.0), ("2*3-1", "", 5.0),
        ("0.5 kg m²", "kg cm²", 5000.0), ("3 cm", "mm", 30.0), ("50 %", "", 0.5), ("1 s", "ms", 1000.0),
        ("200 1/min", "cycles/min", 200.0), ("1.2 kW", "kW", 1.2), ("1e3", "N", 1000.0), ("360/7", "°", 360.0 / 7.0),
    ],
)  # fmt: skip
def test_what_is_typed_comes_into_the_unit_of_its_entry(text, unit, value):
    assert number(text, unit, "a number") == pytest.approx(value, rel=1e-11)


@pytest.mark.parametrize(
    "text", ["4o", "1.234,5", "nan", "inf", "1e999", "5 kg", "1/0", "2**9", "__import__('os')", "9" * 99, "1,2,3"]
)
def test_what_is_no_number_is_refused_in_one_sentence(text):
    with pytest.raises(InputError) as refusal:
        number(text, "mm", "a number")
    assert len(str(refusal.value).splitlines()) == 1
    after, refused = apply_changes(TEXT, [{"path": ["axes", 1, "motor", "peak_torque"], "value": text}])
    assert after == TEXT
    assert [*refused] == ["axes.1.motor.peak_torque"]


def places():
    """Every place at which the page adds, copies or removes a part of the committed machine."""
    data, lists = tomllib.loads(TEXT), ("axes", "switches", "clearances")
    yield from (([name], "add") for name in lists)
    for name in lists:
        for k in range(len(data[name])):
            yield from (([name, k], do) for do in ("copy", "remove"))
    for k, axis in enumerate(data["axes"]):
        yield [["axes", k, "phases"], "add"]
        yield from (([*("axes", k, "phases"), n], do) for n in range(len(axis["phases"])) for do in ("copy", "remove"))
        for section in (each["path"].split(".") for each in schema("machine") if each["path"].startswith("axes.*.")):
            there = axis
            for part in section[2:]:
                there = there.get(part) if isinstance(there, dict) else None
            if there is None:
                yield (["axes", k, *section[2:]], "add") if "mechanism" in axis else (["axes", k, "drive"], "add")
            else:
                yield ["axes", k, *section[2:]], "remove"
    yield from ((["axes", 0, name], "add") for name in ("parts", "stages"))
    yield from ((["laws", law], "add") for law in ("MSN", "SCV", "SPL", "PO7"))


def test_every_button_leads_to_a_valid_design_or_to_one_that_names_what_is_missing_in_its_field():
    for path, do in places():
        text, refused = apply_changes(TEXT, [{"path": path, "do": do}])
        if refused:
            assert text == TEXT
            continue
        design = Edited(text)
        for key in design.faults:
            assert isinstance(get(design.data, split(key)[:-1], {}), dict | list), (path, do, key)
        if do == "add" and len(path) < 3:
            assert design.faults == {}, (path, do)


def test_a_copied_axis_has_a_free_name_and_what_names_an_axis_follows_it():
    copied, _ = apply_changes(TEXT, [{"path": ["axes", 1], "do": "copy"}])
    assert [axis["name"] for axis in tomllib.loads(copied)["axes"]] == ["MC01", "MC02", "MC03", "MC04", "MC05"]
    renamed, _ = apply_changes(TEXT, [{"path": ["axes", 1, "name"], "value": "Punch"}])
    data = tomllib.loads(renamed)
    assert (data["clearances"][0]["first"], data["selection"]["axis"]) == ("Punch", "Punch")
    removed, _ = apply_changes(TEXT, [{"path": ["axes", 1], "do": "remove"}])
    assert Edited(removed).faults == {}


def test_a_missing_entry_is_told_at_its_field_and_the_other_axes_go_on():
    text, _ = apply_changes(TEXT, [{"path": ["axes", 1, "phases", 0, "stop"], "value": ""}])
    design = edited_design(text)
    assert design.faults == {"axes.1.phases.0.stop": "missing: expected a number of at least 0"}
    shown = figures(text, 0)["axes"]
    assert shown["1"]["error"].startswith("phase 1, to: ")
    assert shown["1"]["stale"]
    assert [shown[k]["error"] for k in "023"] == [None] * 3
    lines = verdict("a.toml", text)["checks"]
    assert [line["sentence"] for line in lines] == ["MC02, phase 1, to: missing: expected a number of at least 0"]
    drive, _ = apply_changes(TEXT, [{"path": ["axes", 1, "motor", "peak_torque"], "value": ""}])
    one = figures(drive, 1)["axes"]["1"]
    assert (one["stale"], [chart["key"] for chart in one["charts"]]) == (True, ["v", "a", "j"])


def test_figures_of_all_axes_are_worked_out_in_parts_so_that_a_change_comes_between(monkeypatch):
    monkeypatch.setattr(designs, "PART", 0.0)
    assert [worked_out(TEXT, first) for first in (0, 3, 4)] == [1, 4, None]
    assert worked_out("no = TOML =", 0) is None


def test_the_page_has_the_figures_of_the_book():
    shown = figures(TEXT, 1)
    machine = shown["machine"]
    book = TEMPLATES["machine"].declare(edited_design(TEXT).template.model.model_validate(edited_design(TEXT).data))
    values = {q.name: q.value for block in book.blocks.values() for q in block.quantities}
    assert machine["highest"]["value"] == pytest.approx(values["about_highest"])
    assert machine["peak_power"] == pytest.approx(values["about_peak"])
    torque = next(chart for chart in shown["axes"]["1"]["charts"] if chart["key"] == "T")
    assert max(map(abs, torque["y"])) == pytest.approx(32.4, abs=0.5)
    for k, axis in enumerate(edited_design(TEXT).data["axes"]):
        for pieces, _ in zip(shown["axes"][str(k)]["pieces"], axis["phases"], strict=True):
            assert (pieces[0]["from"], pieces[-1]["to"]) == (0.0, 1.0)
            assert sum(pieces[-1]["x"]) == pytest.approx(1.0, abs=1e-6)


ODD = ["5", '"x"', "[]", "{}", "[5]", "[[1.0]]", "true", "1e300", "nan", "[{}]"]
ANYWHERE = ["axes", "axes.1", "axes.1.phases", "axes.1.phases.0", "master", "axes.1.phases.0.start", "axes.1.motor"]


@pytest.mark.parametrize("wrong", ODD)
@pytest.mark.parametrize("place", ANYWHERE)
@pytest.mark.sample(24)
def test_whatever_stands_in_the_text_is_told_or_shown(wrong, place):
    data = tomllib.loads(TEXT)
    put(data, split(place), tomllib.loads(f"x = {wrong}")["x"])
    for path, do in ((["axes"], "add"), (["axes", 1], "copy"), (["axes", 1, "phases"], "add"), (["clearances"], "add")):
        with suppress(InputError, ReadError):
            text, _ = apply_changes(tomlkit.dumps(data), [{"path": path, "do": do}])
            figures(text, 1)
