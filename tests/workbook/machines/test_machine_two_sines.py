"""Drives of the law of two sines (double harmonic): where the acceleration turns, torque, RMS and energy in cells."""

import math
import random

import pytest

from engine.laws.registry import CATALOGUE
from engine.machine.stationary import inside, plain, turning
from engine.motion.pieces import Scaled, pieces_of
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, described, driven
from tests.workbook.machines.test_machine_linked import CRANK, MOTOR
from tests.workbook.machines.test_random_machines import window
from workbook.reading.descriptions import checked

AWAY, BACK = {"family": "DHM"}, {"family": "DHM", "reversal": "start"}
RISE = ((20, 140, 60.0, "away"), (140, 300, -60.0, "back"))
RATIO = 2 * math.pi / 0.01  # of a screw of 10 mm lead, rad/m


def machine(*axes, **sizes):
    """A machine with the law from rest to a reversal, and from a reversal to rest."""
    plain_one = described([driven((0, 90, 2.0, "CIC"))], **{"phases": 2, "rotors": 2} | sizes).model_dump()
    laws = plain_one["laws"] | {"away": AWAY, "back": BACK}
    made = checked(TEMPLATE, plain_one | {"laws": laws, "axes": list(axes)}, str)
    assert made.design.replaced == {}
    return made


def test_every_law_that_does_not_turn_back_is_one_of_a_drive():
    known = {
        entry.law.__name__: [plain(p) for p in pieces_of(Scaled(entry.example(), 1.0, 1.0))] for entry in CATALOGUE
    }
    assert [name for name, found in known.items() if not all(found)] == []


@pytest.mark.parametrize("reversal", ["start", "end"])
@pytest.mark.parametrize("lift", [0.06, -3.0])
def test_its_acceleration_turns_where_the_jerk_is_0(reversal, lift):
    """y''' = 0 of s = ½(1 − cos πξ) − ⅛(1 − cos 2πξ): cos πξ = ¼."""
    law = next(entry.law for entry in CATALOGUE if entry.law.__name__ == "DoubleHarmonic")(reversal)
    (piece,) = pieces_of(Scaled(law, lift, 0.7))
    at = math.acos(0.25) / math.pi
    assert inside(piece, turning(piece)) == pytest.approx([0.7 * (at if reversal == "end" else 1 - at), 0.7, 0.7])


def test_torque_and_rms_in_closed_form():
    """T = (J i + m/i) a: a from 9π²/16 at the place above to −π² at the reversal, ⟨a²⟩ = (π²/2)² h²/t⁴."""
    value = computed(TEMPLATE, machine(driven(*((a, b, h / 3, law) for a, b, h, law in RISE))))
    inertia = 1e-3 * RATIO + 20 / RATIO
    away, back = (0.02 * (math.pi**2) / (0.3 * span / 360) ** 2 for span in (120, 160))
    assert value("drive1_tmax") == pytest.approx(inertia * away * 9 / 16, rel=1e-11)
    assert value("drive1_tmin") == pytest.approx(-inertia * away, rel=1e-11)
    square = inertia**2 * ((away / 2) ** 2 * 120 + (back / 2) ** 2 * 160) / 360
    assert value("drive1_rms") == pytest.approx(math.sqrt(square), rel=1e-11)


LOADS = {
    "losses": {"load": {"mass": 12.0, "friction": 0.1, "slope": 30.0}, "reducer": {"ratio": 5.0, "efficiency": 0.8}},
    "a process force": {"load": {"mass": 5.0, "windows": [{"start": 100.0, "stop": 200.0, "force": 400.0}]}},
    "behind a crank": {"mechanism": CRANK, "load": {"mass": 12.0, "friction": 0.1}, "motor": MOTOR},
}


@pytest.mark.parametrize("more", LOADS.values(), ids=LOADS.keys())
def test_cells_agree_with_the_engine_and_entries_come_back(more):
    one = machine(driven(*RISE, **more))
    assert disagreeing(TEMPLATE, one)[0] == []
    assert entered(TEMPLATE, one) == (one, [])
    assert [f"{number}" for number, made in enumerate(TEMPLATE.variants(one)) if disagreeing(TEMPLATE, made)[0]] == []


def test_no_result_hangs_on_the_samples():
    few, many = (computed(TEMPLATE, machine(driven(*RISE, **LOADS["losses"]), cycle=cycle)) for cycle in (12, 720))
    for name in ("tmax", "tmin", "rms", "speed", "mean", "pmax", "pmin", "energy", "returned"):
        assert few(f"drive1_{name}") == many(f"drive1_{name}"), name


@pytest.mark.parametrize("number", nights(100))
def test_drawn_loads(number):
    drawn = random.Random(seed(f"two sines {number}"))
    low, top, high = sorted(drawn.sample(range(5, 355, 5), 3))
    lift = drawn.choice((1, -1)) * drawn.uniform(5, 80)
    load = {"mass": drawn.uniform(0, 30), "friction": drawn.uniform(0, 0.3), "slope": drawn.uniform(-90, 90),
            "windows": [window(drawn) for _ in range(drawn.randint(0, 2))]}  # fmt: skip
    for one in load["windows"]:
        one["force"] = abs(one["force"]) if one["resists"] == "moving" else one["force"]
    reducer = {"ratio": drawn.uniform(1, 10), "efficiency": drawn.uniform(0.6, 1)}
    phases = ((low, top, lift, "away"), (top, high, -lift, "back"))
    assert disagreeing(TEMPLATE, machine(driven(*phases, load=load, reducer=reducer)))[0] == []
