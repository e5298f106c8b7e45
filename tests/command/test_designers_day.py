"""A designer's day: a form-fill-seal machine of three axes, from a blank file to a controller's table and a study."""

import openpyxl
import pytest

from workbook.build import build, read_description

MACHINE = """
template = "machine"
title = "Form-fill-seal machine"

[master]
rate = 55.0

[[axes]]
name = "Film"
group = "Film"
closes = "feed"
phases = [ { start = 20.0, stop = 160.0, lift = 220.0, law = "MTP" } ]
parts = [ { name = "Pulleys", count = 2.0, inertia = 18.0, shaft = "mechanism" } ]
mechanism = { kind = "belt", pulley_diameter = 76.4, belt_mass = 0.6, efficiency = 0.95 }
load = { force = 60.0, mass = 1.5 }
motor = { inertia = 2.0, rated_torque = 4.0, peak_torque = 12.0, max_speed = 4000.0 }
reducer = { ratio = 4.0, efficiency = 0.95 }

[[axes]]
name = "Jaw"
group = "Sealing"
phases = [
  { start = 165.0, stop = 215.0, lift = 36.0, law = "CIC" },
  { start = 290.0, stop = 345.0, lift = -36.0, law = "CIC" },
]
mechanism = { kind = "crank-slider", crank_radius = 32.0, rod_length = 150.0, start = 6.0, efficiency = 0.92 }
load = { mass = 9.0, friction = 0.08, windows = [ { start = 215.0, stop = 285.0, force = 350.0 } ] }
motor = { inertia = 3.5, rated_torque = 5.0, peak_torque = 15.0, max_speed = 4500.0 }
reducer = { ratio = 7.0, efficiency = 0.94 }

[[axes]]
name = "Pusher"
group = "Filling"
phases = [
  { start = 30.0, stop = 95.0, lift = 65.0, law = "MTP" },
  { start = 110.0, stop = 170.0, lift = -65.0, law = "MTP" },
]
mechanism = { kind = "lead screw", lead = 16.0, efficiency = 0.88 }
load = { mass = 6.0, friction = 0.06 }
motor = { inertia = 0.9, rated_torque = 2.0, peak_torque = 6.0, max_speed = 5000.0 }

[[switches]]
name = "Valve of the sealing air"
on = [ [210.0, 288.0] ]

[selection]
axis = "Jaw"

[power]
efficiency = 0.92
hours = 3800.0

[sizes]
cycle = 72
law = 8
phases = 3
"""
STUDY = """
title = "Movement of the pusher"
base = "machine.toml"
minimise = ["drive3_rms"]

[[vary]]
key = "axes.Pusher.phases[1].law"
values = ["MTP", "PO5"]

[[vary]]
key = "axes.Pusher.phases[1].stop"
from = 80.0
to = 105.0
steps = 2
"""


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """The folder of the machine's description and study."""
    folder = tmp_path_factory.mktemp("desk")
    (folder / "machine.toml").write_text(MACHINE, encoding="utf-8")
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def book(desk):
    """The machine's workbook: all its checks are OK."""
    assert build(read_description(desk / "machine.toml"), desk / "machine.xlsx") == []
    return desk / "machine.xlsx"


def test_every_cell_agrees(book, motionbook):
    code, said, _ = motionbook("verify", str(book))
    assert code == 0, said


def test_a_study_finds_a_movement_of_less_torque(desk, motionbook, monkeypatch):
    monkeypatch.chdir(desk)
    code, said, wrong = motionbook("study", "study.toml", "--unverified")
    assert (code, "drive3_rms" in said) == (0, True), wrong
    code, _, wrong = motionbook("study", "study.toml", "--pick", "1", "-o", "best.xlsx", "--unverified")
    assert code == 0, wrong
    assert openpyxl.load_workbook("best.xlsx")["Timing"] is not None
