"""The book of S5's flying machining: its equations in the cells, every cell as the engine says."""

import random
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from engine.flying.cut import flying_saw
from tests.engine.selection.tasks import sampled_task
from tests.laws import MOVING
from tests.mutation.draw_flying import varied
from tests.tiers import nights
from tests.workbook.cells import computed, disagreeing
from workbook.law_sheets.library import RISING, laws
from workbook.machines.flying.view import CutterView, ToolDrive
from workbook.reading.descriptions import read_machine
from workbook.template_outputs import judged_limits
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["flying-cutter"]
SAW = TEMPLATE.description.with_name("flying-cutter-saw.toml")
SMALL = {"cycle": 24, "law": 8, "lengths": 6}
L0 = 2 * pi / 3 * 0.12  # m, of the committed drum


def entries(description=TEMPLATE.description, **changed):
    """A committed description with small tables; ``drum__radius=3`` changes an entry of the cutter."""
    data = read_machine(description).model_dump()
    data["sizes"] |= SMALL
    for name, value in changed.items():
        part, _, entry = name.rpartition("__")
        (data["cutter"][part] if part else data["cutter"])[entry] = value
    return data


def described(description=TEMPLATE.description, **changed):
    return TEMPLATE.model.model_validate(entries(description, **changed))


@pytest.mark.parametrize(
    ("length", "case", "does", "row"),
    [
        (180.0, "faster", "keeps moving", 1),
        (80 * pi, "in step", "keeps moving", 2),
        (320.0, "slower", "keeps moving", 3),
        (500.0, "slower", "waits", 4),
    ],
)
def test_s5_cases_by_the_sign_of_h(length, case, does, row):
    value = computed(TEMPLATE, described(product_length=length))
    assert (value("fly_case"), value("fly_does")) == (case, does)
    assert value("cases", "here") == ["is here" if k == row else "-" for k in (1, 2, 3, 4)]


def test_beyond_the_limit_the_drum_waits_or_reverses():
    waiting = computed(TEMPLATE, described(product_length=600.0, beyond="standstill"))
    back = computed(TEMPLATE, described(product_length=600.0, beyond="reversal"))
    assert (waiting("fly_does"), back("fly_does")) == ("waits", "reverses")
    assert waiting("fly_wait") > 0.0 == back("fly_wait")
    assert waiting("fly_low") == pytest.approx(0.0, abs=1e-12)
    assert back("fly_low") < 0.0
    assert min(waiting("cycle", "v")) == pytest.approx(0.0, abs=1e-12)
    assert min(back("cycle", "v")) < 0.0
    stands = [k for k, phase in enumerate(waiting("tool_pieces", "p"), 1) if phase == 2]
    assert set(stands) & set(waiting("cycle", "q"))
    for value in (waiting, back):
        assert value("cycle", "s")[-1] == pytest.approx(1e3 * L0, rel=1e-12)
        assert value("strategies", "does") == ["waits", "reverses"]
        assert value("strategies", "a") == [waiting("fly_a"), back("fly_a")]


def test_the_torque_over_the_cycle_has_the_mean_squares_of_the_cells():
    """A load torque beside the inertia: T*_L,rms and (ω̇ T*)_mean against the sampled cycle."""
    machine = entries(load__torque=3.0)
    machine["sizes"]["cycle"] = 240
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(machine))
    task = sampled_task(*(value("cycle", name) for name in ("t", "w", "dw", "torque")))
    assert value("fly_dw_rms") == pytest.approx(task.acceleration_rms, rel=1e-5)
    assert value("fly_torque_rms") == pytest.approx(task.torque_rms, rel=1e-5)
    assert value("fly_mean") == pytest.approx(task.power_rate_mean, rel=1e-4)
    assert value("fly_beta") == pytest.approx(task.load_factor, rel=1e-4)
    assert value("fly_w_max") == pytest.approx(task.max_speed, rel=1e-3)


def test_at_the_highest_line_speed_the_shaft_is_at_its_first_limit():
    for limits in ({"speed": 300.0, "acceleration": 1e5}, {"speed": 1e4, "acceleration": 500.0}):
        value = computed(TEMPLATE, described(limits=limits))
        at = computed(TEMPLATE, described(limits=limits, line_speed=value("fly_line_max")))
        reached = at("fly_n") / limits["speed"], at("fly_dw") / limits["acceleration"]
        assert max(reached) == pytest.approx(1.0, rel=1e-12)
        assert (at("fly_ok_speed"), at("fly_ok_acceleration")) == ("OK", "OK")


@pytest.mark.parametrize("law", MOVING)
def test_the_stroke_of_a_saw_is_exact_with_every_law(law):
    machine = entries(SAW, law=law)
    machine["laws"]["OWN"]["pieces"] = RISING
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(machine))
    given = TEMPLATE.model.model_validate(machine)
    cut = CutterView(given, laws(given.laws)).cut
    exact = np.ptp(cut.at(np.linspace(0.0, cut.cycle_time, 200_001)).position)
    assert value("fly_stroke") == pytest.approx(1e3 * exact, rel=1e-9)
    assert TEMPLATE.judgement(given).deviations == []
    assert (value("fly_limit"), value("fly_does")) == (0, "reverses")


def test_the_stroke_of_the_saw_with_constant_acceleration_by_hand():
    """It brakes with a = 4 L_p/t_R² from v_L to −v, and back: s = v_L²/(2a) forwards, more than L_T behind."""
    value, line, length, rest = computed(TEMPLATE, described(SAW, law="ACS")), 0.5, 2.0, 3.0
    a = 4 * length / rest**2
    forwards = line**2 / (2 * a)
    assert value("fly_stroke") == pytest.approx(1e3 * (0.5 + 2 * forwards), rel=1e-12)


def test_the_saw_has_no_mean_speed_and_needs_its_stroke():
    value = computed(TEMPLATE, described(SAW))
    assert value("cycle", "s")[-1] == pytest.approx(0.0, abs=1e-9)
    assert value("fly_rpm_high") == pytest.approx(750.0, rel=1e-12)
    assert value("fly_ok_stroke") == "OK"
    short = computed(TEMPLATE, described(SAW, saw__stroke=850.0))
    assert (short("fly_ok_stroke"), short("overall")) == ("FAIL", "FAIL")
    assert flying_saw(0.5, 0.04 / (2 * pi)).radius * 1e3 == pytest.approx(value("fly_r"), rel=1e-12)


def drawn(number):
    """A cutter of random entries, and small tables."""
    dice = random.Random(f"flying cutter {number}")
    return TEMPLATE.model.model_validate(varied(entries(SAW), dice))


@pytest.mark.parametrize("number", [*range(8), *nights(30)])
@pytest.mark.sample(2)
def test_a_drawn_cutter_is_as_its_sheet_states(number):
    """Cells agree with the engine, results with the exact engine to their bounds, judged limits with the checks."""
    given = drawn(number)
    assert disagreeing(TEMPLATE, given)[0] == []
    judged = TEMPLATE.judgement(given)
    if given.cutter.law != "OWN":  # whose acceleration may be largest between points
        assert judged.deviations == []
    blocks = TEMPLATE.declare(given).blocks
    for limit in judged.limits:
        assert blocks[limit.check].quantities[0].value == ("OK" if limit.sheet.ok else "FAIL")


@pytest.mark.parametrize("number", range(20))
def test_a_motor_exactly_at_its_limits_holds_them(number):
    """Whatever the last digit of the exact engine's figures."""
    given = drawn(number)
    drive = ToolDrive(CutterView(given, laws(given.laws)), given.selection, given.limits, given.sizes)
    exact, sheet = drive.exact, drive.limit_checks
    at = replace(exact.motor, max_speed=drive.speed)
    judged = {limit.what: limit for limit in judged_limits("", "", sheet, replace(exact, motor=at))}
    assert judged["motor speed"].exact.ok
    assert judged["motor speed"].exact.use == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize(
    ("share", "beyond"),
    [*((share, "reversal") for share in (-1e-6, -1e-12, 0.0, 1e-12, 2e-9, 1e-6, 1e-3)), (0.0, "standstill")],
)
@pytest.mark.parametrize("law", ["ACS", "TVP", "CIC", "CUB", "MTP"])
@pytest.mark.sample(2)
def test_a_tool_that_barely_turns_round_is_judged_alike_in_cells_and_engine(law, share, beyond):
    """A share of the longest product without standstill more, or less."""
    machine = described(law=law)
    limit = CutterView(machine, laws(machine.laws)).limit
    machine = described(law=law, product_length=limit * (1.0 + share), beyond=beyond)
    assert disagreeing(TEMPLATE, machine)[0] == []


@pytest.mark.parametrize("law", MOVING)
@pytest.mark.parametrize("changed", [{}, {"kind": "drum", "product_length": 900.0, "drum__tool_angle": 0.0}])
@pytest.mark.sample(4)
def test_the_last_look_at_a_turn_is_exact(law, changed):
    """Of a saw, and of a drum whose tools work for an instant."""
    machine = entries(SAW, law=law, beyond="reversal", **changed)
    machine["laws"]["OWN"]["pieces"] = RISING
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(machine), by_cells=True)
    cut = CutterView(given := TEMPLATE.model.model_validate(machine), laws(given.laws)).cut
    turns = [value("drive_turns", "at")[k] for k in (3, 7)]
    assert cut.at(turns).speed == pytest.approx(0.0, abs=1e-12)
    assert set(turns) <= set(value("drive_iv", "begin"))


@pytest.mark.parametrize(("law", "length", "asked", "said"), [
    ("ACS", 180.0, "acceleration", "works at line speed to moves by its law at 0 s: acceleration jumps by 46.76"),
    ("CIC", 900.0, "jerk", "works at line speed to moves by its law at 0 s: jerk jumps by "),
    ("ACS", 180.0, "velocity", ""), ("CIC", 180.0, "acceleration", ""), ("CIC", 900.0, "acceleration", ""),
])  # fmt: skip
def test_the_tool_is_as_smooth_as_asked_or_the_joint_is_named(law, length, asked, said):
    """Constant acceleration begins with 4 h v_L²/(L_p − L_T)²."""
    value = computed(TEMPLATE, described(law=law, product_length=length, smoothness=asked))
    assert value("fly_ok_smooth") == ("FAIL" if said else "OK")
    assert value("fly_ok_smooth_says").startswith(said or "what must not jump")
