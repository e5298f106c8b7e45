"""Process forces over the cycle, energy and mean torque of a machine's drives: by other routes than the stretches."""

import math

import pytest

from tests.workbook.cells import computed
from tests.workbook.machines.test_machine import TEMPLATE, described, driven
from workbook.fields.units import KW

RATIO = 2 * math.pi / 0.01  # of a screw of 10 mm lead, rad/m
RISE = ((30, 90, 20.0, "CIC"), (180, 240, -20.0, "CIC"))
FIGURES = ("tmax", "tmin", "rms", "speed", "mean", "smax", "smean", "energy", "returned", "power", "res_rms", "ok_peak")


def small(axes, **sizes):
    """A machine with little room."""
    return described(axes, **{"phases": 2, "rotors": 2} | sizes)


def forced(*windows, phases=RISE, **entries):
    """An axis on a screw without losses, with process forces (from, to, force, resists)."""
    told = [
        {"start": start, "stop": stop, "force": force, "resists": resists} for start, stop, force, resists in windows
    ]
    return driven(*phases, load={"mass": 20.0, "friction": 0.1, "windows": told}, **entries)


def test_the_rms_point_lies_at_the_mean_speed():
    """40 mm of a screw of 10 mm lead in 0.3 s: 4 turns; at a rate of its own of 100 a minute, in 0.6 s."""
    for rate, rpm in ((None, 800.0), (100.0, 400.0)):
        value = computed(TEMPLATE, small([forced((20, 120, 500.0, "always"), rate=rate)]))
        assert value("drive1_mean") == pytest.approx(rpm, rel=1e-12)
        assert value("drive1_point", "rpm") == [value("drive1_mean")]
        assert value("drive1_point", "torque") == [value("drive1_rms")]


def test_over_a_closed_cycle_the_motor_does_the_work_of_friction_and_process_forces():
    """∮ T dφ = μ m g · 2 h + F h: the force acts over the whole rise, and once more while the axis rests."""
    value = computed(TEMPLATE, small([forced((20, 120, 500.0, "always"))]))
    net = value("drive1_energy") - value("drive1_returned")
    assert net == pytest.approx(0.1 * 20.0 * 9.81 * 0.04 + 500.0 * 0.02, rel=1e-9)
    assert KW * value("drive1_power") == pytest.approx(net / 0.3, rel=1e-9)
    assert value("drive1_returned") > 0.0


def test_a_force_in_a_dwell_is_held_by_the_motor_or_by_a_brake():
    """F/i for 36 of 360°, beside a motion that is the same without it."""
    motor = {"inertia": 10.0, "rated_torque": 60.0, "peak_torque": 450.0, "max_speed": 13000.0}
    bare, held, braked = (
        computed(TEMPLATE, small([one]))
        for one in (forced(), forced((100, 136, 800.0, "always")),
                    forced((100, 136, 800.0, "always"), motor=motor | {"holding": "brake"}))
    )  # fmt: skip
    rms = bare("drive1_rms")
    assert held("drive1_rms") == pytest.approx(math.sqrt(rms**2 + (800.0 / RATIO) ** 2 / 10), rel=1e-9)
    assert braked("drive1_rms") == pytest.approx(rms, rel=1e-12)


def test_a_force_that_begins_within_a_rise_shows_at_its_edge():
    """At half of the rise a cycloid does not accelerate: just behind it T is F/i and friction's, and no more later."""
    value = computed(TEMPLATE, small([forced((60, 61, 1e6, "always"))]))

    friction = 0.1 * 20.0 * 9.81 / RATIO
    assert value("drive1_tmax") == pytest.approx(1e6 / RATIO + friction, rel=1e-9)


def test_the_mean_torque_of_a_constant_force_is_that_force():
    """Without mass and friction S = F/i all the way: its mean by any power is the same."""
    axis = driven(*RISE, load={"mass": 0.0, "force": 700.0}, reducer={"ratio": 4.0})
    assert computed(TEMPLATE, small([axis]))("drive1_smean") == pytest.approx(700.0 / RATIO, rel=1e-9)


def test_a_drive_takes_a_polynomial_345():
    data = small([driven((30, 90, 20.0, "CIC"))]).model_dump()
    data["laws"]["PO5"] = {"family": "PO5"}
    data["axes"][0]["phases"] = [
        {"start": 30.0, "stop": 90.0, "lift": 20.0, "law": "PO5"},
        {"start": 180.0, "stop": 240.0, "lift": -20.0, "law": "PO5"},
    ]
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(data))
    hardest, inertia = 5.773502691896258 * 0.02 / 0.05**2, 1e-3 * RATIO + 20.0 / RATIO
    assert value("drive1_tmax") == pytest.approx(hardest * inertia, rel=1e-9)
    assert value("drive1_rms") == pytest.approx(math.sqrt(120 / 7) * 0.02 / 0.05**2 * inertia / math.sqrt(3), rel=1e-9)
