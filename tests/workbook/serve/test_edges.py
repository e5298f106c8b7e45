"""Edges of phases in the text of a description: where they stand, and what comes of moving one."""

import re
from xml.etree.ElementTree import fromstring

import pytest

from workbook.reading.descriptions import write_machine
from workbook.serve.live import design, edges, fragment
from workbook.template import FOLDER

TEXT = (FOLDER / "machine.toml").read_text(encoding="utf-8")


def moved(text, edge, words):
    """The text with the numbers of an edge replaced, as the page does it."""
    for begin, end in sorted(edge.places, reverse=True):
        text = text[:begin] + words + text[end:]
    return text


def of(text):
    """The edges of a text, and its machine."""
    machine = design("a.toml", text).machine
    return list(edges(text, machine)), machine


@pytest.mark.parametrize("text", [TEXT, write_machine(design("a.toml", TEXT).machine)], ids=["written", "generated"])
def test_each_number_of_a_phase_stands_where_an_edge_says(text):
    found, machine = of(text)
    told = {(axis.name, value) for axis in machine.axes for one in axis.phases for value in (one.start, one.stop)}
    assert {(edge.axis, edge.value) for edge in found if not edge.lane} == told
    assert all(float(text[begin:end] or 0.0) == edge.value for edge in found for begin, end in edge.places)


def test_a_moved_edge_moves_both_phases_that_meet_there_and_nothing_else():
    text = TEXT.replace("{ start = 305.0, stop = 350.0, lift = -20.0", "{ start = 135.0, stop = 350.0, lift = -20.0")
    found, before = of(text)
    edge = next(one for one in found if one.key == "MC02 135")
    assert len(edge.places) == 2
    _, after = of(moved(text, edge, "141.0"))
    phases = before.axes[1].phases
    phases[0] = phases[0].model_copy(update={"stop": 141.0})
    phases[1] = phases[1].model_copy(update={"start": 141.0})
    assert after.model_dump() == before.model_dump()


@pytest.mark.parametrize("text", [TEXT, write_machine(design("a.toml", TEXT).machine)], ids=["written", "generated"])
def test_a_moved_lane_shifts_its_axis_and_nothing_else(text):
    found, before = of(text)
    lanes = [edge for edge in found if edge.lane]
    assert [(one.axis, one.value) for one in lanes] == [(axis.name, axis.shift) for axis in before.axes]
    for k, one in enumerate(lanes):
        _, after = of(moved(text, one, f"{one.before}12.5"))
        assert after.axes[k].shift == 12.5
        after.axes[k] = after.axes[k].model_copy(update={"shift": before.axes[k].shift})
        assert after == before


def test_a_number_in_a_comment_is_no_edge():
    text = TEXT.replace("phases = [ { start", "phases = [ # was start = 5.0\n { start", 1)
    found, _ = of(text)
    assert len(found) == len(of(TEXT)[0])
    assert 5.0 not in {edge.value for edge in found}


def test_the_timing_diagram_has_a_handle_for_each_edge_that_keys_reach():
    html = fragment("a.toml", TEXT, TEXT)
    svg = fromstring(re.search(r"(?s)<svg.*?</svg>", html)[0])
    handles = [one for one in svg.iter() if one.get("data-edge")]
    found, _ = of(TEXT)
    assert sorted(one.get("data-edge") for one in handles) == sorted(edge.key for edge in found)
    assert [one.text for one in handles if one.get("class") == "lane"] == [edge.axis for edge in found if edge.lane]
    assert all(one.get("tabindex") == "0" and one.get("data-step") == "1" for one in handles)
