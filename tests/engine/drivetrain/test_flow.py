"""Where the flow of power turns round: the bent line against the chain's torques, mean squares against samples."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.drivetrain import KINDS, NEAR, Drive, Load, Part, Sizing, Stage
from engine.drivetrain.flow import Flow
from engine.drivetrain.magnitudes import Magnitudes
from engine.drivetrain.squares import BentPhase, CycleSquares, hinge, trapezoids
from engine.laws import CATALOGUE, Cycloidal, Dwell, ModifiedTrapezoidal
from engine.motion import Motion, Phase

ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
LAWS = [e.example() for e in CATALOGUE if e.code not in ("DWL", "OWN")] + [ASYMMETRIC]
laws = st.sampled_from(LAWS)


def drive(torque=1.0, friction=0.5, method="physical", holding="motor", losses=(0.8, 0.7), inertia=0.0):
    stages = [Stage("first", 3.0, losses[0]), Stage("second", 5.0, losses[1])]
    parts = [Part("pinion", 1e-4), Part("middle", 1e-3, 1)]
    load = Load(0.05, torque, friction)
    return Drive(KINDS["gear train"].of(load, gears=stages, parts=parts), inertia, method, holding)


def bent_torque(flow, b):
    """T* in the direction of motion, by the line and its bends."""
    y = -flow.sign * b
    past = np.maximum(y[:, None] - flow.turn, 0.0)
    return flow.level + flow.slope * b - flow.sign * (past * flow.step).sum(axis=1)


@settings(max_examples=60)
@given(st.floats(-4, 4), st.floats(0, 2), st.sampled_from([1.0, -1.0]), st.sampled_from(["physical", "document"]))
def test_the_bent_line_is_the_torque_of_the_chain(torque, friction, going, method):
    one = drive(torque, friction, method)
    flow, b = Flow(one, going), np.linspace(-300.0, 300.0, 601)
    found = one.torques(going * b, going)[0] * going
    assert bent_torque(flow, b) == pytest.approx(found, rel=1e-9, abs=1e-8)


@given(st.floats(-4, 4), st.floats(0, 2))
def test_slopes_before_and_after_each_turn(torque, friction):
    """Their sum and difference are those of the torque's slopes, by differences, between the turns."""
    one = drive(torque, friction)
    flow = Flow(one, 1.0)
    turns = np.sort(flow.turn[flow.weight > 0])
    if np.diff(turns, prepend=0.0).min() < 1e-3:
        return  # two turns at once, or one at rest
    for stage in np.flatnonzero(flow.step):
        y = flow.turn[stage] + np.array([-4e-4, -2e-4, 2e-4, 4e-4])
        t = one.torques(-flow.sign * y, 1.0)[0]
        before, after = abs(t[1] - t[0]) / 2e-4, abs(t[3] - t[2]) / 2e-4
        assert flow.both[stage] == pytest.approx(before + after, rel=1e-5)
        assert flow.step[stage] == pytest.approx(after - before, rel=1e-5, abs=1e-9)


def test_the_document_s_line_does_not_bend():
    flow = Flow(drive(method="document"), 1.0)
    assert flow.step.tolist() == [0.0, 0.0, 0.0]
    assert flow.run[-1] == pytest.approx(flow.front[0])


@pytest.mark.parametrize(("torque", "sign"), [(0.0, 1.0), (-NEAR / 2, 1.0), (-2 * NEAR, -1.0), (2.0, 1.0)])
def test_a_load_that_hardly_drives_counts_as_resisting(torque, sign):
    assert Flow(drive(torque, 0.0), 1.0).sign == sign


def fine(one, phase, n=400_000):
    """∫T*² dt, ∫ω̇T* dt and ∫ω̇² dt by midpoints."""
    motion = Motion([phase])
    time = (np.arange(n) + 0.5) / n * phase.duration
    a = motion.at(time).y2
    torque, dw = one.torques(a, math.copysign(1.0, phase.lift))[0], one.mechanism.ratio * a
    return [float(values.mean()) * phase.duration for values in (torque**2, dw * torque, dw**2)]


@settings(max_examples=12)
@given(laws, st.sampled_from([6.0, -6.0]), st.floats(-4, 4))
def test_mean_squares_of_a_phase_are_those_of_fine_samples(law, lift, torque):
    one, phase = drive(torque), Phase(law, lift, 0.2)
    squares, size = BentPhase(one, phase).squares, fine(one, phase)
    room = 1e-4 * math.sqrt(size[0] * size[2])
    assert squares.torque == pytest.approx(size[0], rel=1e-4)
    assert squares.product == pytest.approx(size[1], abs=room)
    assert squares.acceleration == pytest.approx(size[2], rel=1e-4)


@settings(max_examples=12)
@given(laws, st.sampled_from([6.0, -6.0]), st.floats(-4, 4))
def test_mean_square_in_closed_form_with_hinges(law, lift, torque):
    """What the workbook's cells add up: the line, and for each turn its step times N1 and N2."""
    one, phase = drive(torque), Phase(law, lift, 0.2)
    bent = BentPhase(one, phase)
    flow, mean2 = bent.flow, bent.move.mean_square
    added = sum(
        flow.step[s] * (flow.both[s] * bent.hinge(s, 2) + 2 * flow.front[s] * flow.turn[s] * bent.hinge(s, 1))
        for s in range(len(flow.turn))
    )
    line = bent.slope**2 * mean2 + 2 * bent.slope * bent.level * bent.mean + bent.level**2
    assert phase.duration * (line + added) == pytest.approx(bent.torque_square, rel=1e-9)


def test_a_cycle_is_the_sum_of_its_phases_for_a_motor_of_any_inertia():
    phases = [Phase(Cycloidal(), 6.0, 0.2), Phase(Dwell(), 0.0, 0.1), Phase(ASYMMETRIC, -6.0, 0.3)]
    for holding in ("motor", "brake"):
        one = drive(holding=holding)
        cycle = CycleSquares([BentPhase(one, phase) for phase in phases])
        for inertia in (0.0, 1e-4, 3e-3):
            exact = Sizing(one.mechanism, phases, inertia, holding=holding).rms_torque
            assert cycle.rms_torque(inertia) == pytest.approx(exact, rel=1e-12)
        assert cycle.torque == cycle.rms_torque(0.0)
        assert cycle.time == pytest.approx(0.6)


def test_a_law_known_by_samples_comes_near_as_they_grow():
    one, phase = drive(), Phase(Cycloidal(), 6.0, 0.2)
    exact = BentPhase(one, phase).squares
    gaps = [abs(BentPhase(one, phase, n).squares.torque / exact.torque - 1) for n in (20, 200)]
    assert 0 < gaps[1] < 0.03 * gaps[0]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.code)
@pytest.mark.parametrize("power", [1, 2])
def test_hinge_is_the_integral_past_the_turn(law, power):
    turn = 0.4 * law.coefficients.ca_max
    xi = (np.arange(300_000) + 0.5) / 300_000
    assert hinge(law, 1.0, turn, power) == pytest.approx(
        float((np.maximum(law.a(xi) - turn, 0) ** power).mean()), rel=1e-4
    )
    assert hinge(law, 0.0, turn, power) == 0.0
    assert hinge(law, 1.0, 1.01 * law.coefficients.ca_max, power) == 0.0


def test_trapezoids():
    assert trapezoids(lambda xi: 3 * xi**2, 1000) == pytest.approx(1.0, rel=1e-6)


def test_shares_and_angles_of_turns_that_are_not_reached():
    bent = BentPhase(drive(friction=50.0), Phase(Cycloidal(), 0.1, 2.0))
    assert bent.shares.tolist() == [1.0, 1.0, 1.0]
    assert bent.angles.tolist() == [0.0, 0.0, 0.0]
    still = BentPhase(drive(), Phase(Dwell(), 0.0, 2.0))
    assert (still.slope, still.sign, still.level) == (0.0, 1.0, drive().held_torque)


def test_magnitudes_bound_what_a_lossless_cycle_asks_for_and_are_never_zero():
    phases = [Phase(Cycloidal(), 6.0, 0.2), Phase(Cycloidal(), -6.0, 0.3)]
    one = drive(losses=(1.0, 1.0))
    sizing = Sizing(one.mechanism, phases, 1e-4)
    sides, c = Magnitudes(sizing), Cycloidal().coefficients
    assert sizing.peak_torque <= c.ca * sides.torque
    assert sizing.max_speed == pytest.approx(c.cv * sides.motor_speed)
    assert sizing.max_acceleration == pytest.approx(c.ca * sides.motor_acceleration)
    assert sides.power == sides.torque * sides.motor_speed
    resting = Magnitudes(Sizing(one.mechanism, [Phase(Dwell(), 0.0, 1.0)], 0.0))
    assert min(resting.lift, resting.torque, resting.force, resting.slope, resting.shaft_torque(1)) > 0
