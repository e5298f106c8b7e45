"""Switches to controllers: golden files, parsers that share nothing with the readers, damaged files, the command."""

import json
import re
from itertools import pairwise
from pathlib import Path
from xml.dom import minidom

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.timing import Switch, compare_switches
from tests.workbook.controllers.examples import TEXT, build_described
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.target import MOST_OFF, SwitchExport, differences, tracks
from workbook.errors import TargetError
from workbook.reading.descriptions import read_machine
from workbook.template_outputs import CamSwitch

GOLDEN = Path(__file__).parent / "golden"
TAKING = [name for name in TARGETS if target(name).tappets]
NUMBER = r"(-?\d+\.?\d*(?:[eE]-?\d+)?)"


def switch(name, *on):
    return CamSwitch(name, Switch(name, on, 360.0), "°")


LANES = (
    switch("Valve 3", (20.0, 95.0), (200.1, 215.0)), switch("Film -- sensor", (345.0, 15.0)), switch("Never"),
    switch("On", (0.0, 360.0)), switch("From 360", (360.0, 10.0)), switch("To 0", (350.0, 0.0)),
)  # fmt: skip
MEANT = {
    1: [(20.0, 95.0), (200.1, 215.0)],
    2: [(345.0, 15.0)],
    4: [(0.0, 360.0)],
    5: [(0.0, 10.0)],
    6: [(350.0, 360.0)],
}


def written(name, lanes=LANES):
    one = target(name).tappets
    return one.write(SwitchExport(tracks(lanes, one), "Switches", ("an example",)))


def by_dom(text):
    """The elements of an OUTPUT_CAM tag, by another parser; two that meet at the end of the turn are one."""
    found = {}
    for one in minidom.parseString(text).getElementsByTagName("Structure"):
        held = {m.getAttribute("Name"): m.getAttribute("Value") for m in one.getElementsByTagName("DataValueMember")}
        ends = round(float(held["Left"]), 4), round(float(held["Right"]), 4)
        found.setdefault(int(held["OutputBit"]) + 1, []).append(ends)
    found[2] = [(found[2][0][0], found[2][1][1])]
    return found


def by_pattern(pattern):
    def parser(text):
        found = {}
        for number, *ends in re.findall(pattern, text):
            found.setdefault(int(float(number)), []).append(tuple(map(float, ends)))
        return found

    return parser


PARSERS = {
    "csv": by_pattern(rf"(?m)^(\d+);{NUMBER};{NUMBER}\r$"),
    "codesys": by_pattern(rf"TrackNumber := (\d+), FirstOnPosition := {NUMBER}, LastOnPosition := {NUMBER}, Axis"),
    "twincat": by_pattern(rf"_(\d+)_S\[\d+\]\.FirstOnPosition := {NUMBER}; \S+LastOnPosition := {NUMBER};"),
    "rockwell": by_dom,
}


@pytest.mark.parametrize("name", TAKING)
def test_a_file_is_what_it_was(name):
    found = written(name).encode()
    assert found == (GOLDEN / f"{name}-switches{target(name).suffix}").read_bytes()
    assert found == written(name).encode()


@pytest.mark.parametrize("name", TAKING)
def test_another_parser_finds_the_times(name):
    assert PARSERS[name](written(name)) == MEANT


@given(edges=st.lists(st.floats(0.0, 359.9), min_size=2, max_size=12, unique=True), across=st.booleans())
def test_random_switches_are_read_back(edges, across):
    edges = sorted(np.round(edges, 3).tolist())
    assume(all(b - a > 0.01 for a, b in pairwise(edges)))
    order = [*edges[1:], *edges[:1]] if across else edges
    on = list(zip(order[::2], order[1::2], strict=False))
    lanes = [switch("A", *on), switch("B", *on[:1])]
    for name in TAKING:
        one = target(name).tappets
        off = differences(lanes, one.read(written(name, lanes)))
        assert max(each.largest for each in off) <= (1e-4 if name == "rockwell" else 0.0)
        assert max(each.duration for each in off) <= (1e-3 if name == "rockwell" else 0.0)


def test_a_switch_that_differs_is_told_by_edge_and_share():
    meant = Switch("V", ((20.0, 95.0),), 360.0)
    assert compare_switches(meant, Switch("V", ((20.0, 95.5),), 360.0)) == (2, 0.5, 95.0, 0.5)
    assert compare_switches(meant, Switch("V", ((350.0, 95.0),), 360.0)) == (2, 30.0, 20.0, 30.0)
    assert compare_switches(meant, Switch("V", (), 360.0)).largest == np.inf
    assert compare_switches(meant, Switch("V", ((20.0, 50.0), (50.0, 95.0)), 360.0)) == (2, 0.0, 20.0, 0.0)
    with pytest.raises(ValueError, match="expected the same"):
        compare_switches(meant, Switch("V", (), 1.0))


def outcome(text, one):
    """The line that refuses a text; empty where it is none."""
    try:
        differences(LANES, one.read(text))
    except TargetError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("name", TAKING)
def test_a_damaged_file_is_refused_in_a_line_or_says_so(name):
    one, text = target(name).tappets, written(name)
    for cut in range(0, len(text), max(5, len(text) // 80)):
        assert "\n" not in outcome(text[:cut], one)
    for wrong in ("nan", "1e999", "abc", "--1", "-5.0", "400.0"):
        with pytest.raises(TargetError) as said:
            one.read(re.sub(r"(?<![\d.])95\.0(?!\d)", wrong, text, count=1))
        assert "\n" not in str(said.value)
    with pytest.raises(TargetError, match="overlap"):
        one.read(re.sub(r"(?<![\d.])95\.0(?!\d)", "210.0", text, count=1))


def test_limits_are_refused():
    codesys, rockwell = target("codesys").tappets, target("rockwell").tappets
    many = [switch(f"S{k}", (1.0, 2.0)) for k in range(33)]
    for one in (codesys, rockwell):
        with pytest.raises(TargetError, match="33 switches; expected at most 32"):
            tracks(many, one)
    with pytest.raises(TargetError, match="0 times of being on"):
        tracks([switch("Never")], codesys)
    with pytest.raises(TargetError, match="is no time in REAL"):
        tracks([switch("Short", (200.0, 200.000001))], rockwell)
    with pytest.raises(TargetError, match=r"tracks 1; expected 1 to 2"):
        differences(LANES[:2], codesys.read(written("codesys", LANES[:1])))


# The command

LANED = TEXT + '[[switches]]\nname = "Valve 3"\non = [ [20.0, 95.0], [345.0, 15.0] ]\n'


@pytest.fixture(scope="module")
def laned(tmp_path_factory):
    build_described(LANED, path := tmp_path_factory.mktemp("laned") / "laned.xlsx")
    return path


def test_all_writes_the_switches_too_where_the_target_takes_them(run, laned, tmp_path):
    code, out, _ = run("export", laned, "--all", "--to", "codesys", "-o", "cams", "--json", "--report", "c.html")
    assert code == 0
    assert {path.name for path in (tmp_path / "cams").iterdir()} == {
        "laned-Press.st", "laned-Feed_2.st", "laned-switches.st",
    }  # fmt: skip
    told = json.loads(out)[-1]
    assert told["switches"] == [
        {"switch": "Valve 3", "unit": "°", "edges": 4, "largest": 0.0, "at": 20.0, "apart": 0.0}
    ]
    text = (tmp_path / "cams" / "laned-switches.st").read_text("utf-8")
    assert "track 1: Valve 3" in text
    assert "SHA-256" in text
    assert "Valve 3" in (tmp_path / "c.html").read_text("utf-8")


def test_a_target_without_them_says_that_they_stay(run, laned, tmp_path):
    code, _, err = run("export", laned, "--all", "--to", "sew", "-o", "cams", "--unverified")
    assert code == 0
    assert "sew takes no switches: Valve 3 stay in the book" in " ".join(err.split())
    assert len([*(tmp_path / "cams").iterdir()]) == 2


def test_switches_alone(run, laned, tmp_path):
    code, out, _ = run("export", laned, "--switches", "--to", "rockwell", "-o", "s.xml", "--unverified")
    assert code == 0
    assert "Valve 3" in out
    assert target("rockwell").tappets.read((tmp_path / "s.xml").read_text("utf-8"))[0].on == (
        (20.0, 95.0),
        (345.0, 15.0),
    )
    for more, said in (
        (("--to", "sew"), "sew takes no switches; expected one of csv, codesys, twincat, rockwell"),
        (("--to", "csv", "--axis", "Press"), "either --axis NAME, --switches or --all"),
    ):
        code, _, err = run("export", laned, "--switches", *more, "--unverified")
        assert code == 2
        assert said in " ".join(err.split())


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", TAKING)
def test_switches_come_back_and_are_compared(run, laned, tmp_path, name):
    assert run("export", laned, "--switches", "--to", name, "-o", "s", "--unverified")[0] == 0
    code, out, err = run("read", "s", "--from", name, "--switches")
    assert (code, "2 times of being on" in err) == (0, True)
    assert out.strip() == LANED[LANED.index("[[switches]]") :].strip().replace("[ ", "[").replace(" ]", "]").replace(
        ".0", ""
    )
    (tmp_path / "again.toml").write_text(f"{TEXT}{out}", "utf-8")
    assert read_machine(tmp_path / "again.toml").switches == read_machine(laned.with_suffix(".toml")).switches
    asked = ("compare", laned, "s", "--switches", "--from", name, "--unverified")
    assert run(*asked)[0] == 0
    text = (tmp_path / "s").read_text("utf-8")
    assert "95.0" in text
    (tmp_path / "s").write_text(text.replace("95.0", "95.5"), "utf-8")
    code, out, err = run(*asked)
    assert code == 1
    assert "Valve 3: an edge is off by 0.5 °" in err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("read", "s", "--from", "sew", "--switches"), "sew takes no switches"),
        (("read", "s", "--from", "csv", "--switches", "-o", "s.toml"), "switches alone are no machine"),
        (("read", "s", "--from", "csv", "--switches"), "is no number"),
        (("compare", "none.xlsx", "s", "--from", "csv"), "either --axis NAME or --switches"),
        (("compare", "none.xlsx", "s", "--from", "csv", "--switches", "--axis", "A"), "either --axis NAME"),
        (("compare", "none.xlsx", "s", "--from", "csv", "--switches"), "is no number"),
    ],
)
def test_switches_that_cannot_be_meant_are_refused(run, tmp_path, arguments, said):
    (tmp_path / "s").write_text("1;20;x\n", "utf-8")
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert said in " ".join(err.split())


def test_a_machine_without_switches_says_so(run, book):
    code, _, err = run("export", book, "--switches", "--to", "csv", "--unverified")
    assert code == 2
    assert "the machine has no switches" in err


def test_an_edge_that_is_too_far_off_is_not_written(run, laned, tmp_path, monkeypatch):
    monkeypatch.setattr("workbook.commands.switch_export.MOST_OFF", -1.0)
    assert MOST_OFF > 0.0
    code, _, err = run("export", laned, "--switches", "--to", "csv", "--unverified")
    assert code == 1
    assert "nothing is written" in err
    assert list(tmp_path.iterdir()) == []
