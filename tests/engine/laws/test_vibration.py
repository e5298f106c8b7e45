"""Vibration after a move: printed amplitudes, an oscillator integrated in time, and what input shapers leave."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from engine.laws import law
from engine.laws.vibration import SHORTEST, Shaper, left_by
from engine.motion import Motion, Phase
from engine.motion.pieces import motion_pieces

PERIODS = np.array([1.5, 2.0, 3.0, 4.0, 5.0])
PERCENT = {  # of the lift
    "constant acceleration": (9.006, 0.0, 4.503, 0.0, 1.621),
    "simple harmonic": (0.0, 6.667, 2.857, 1.587, 1.010),
    "cycloidal": (16.977, 0.0, 0.0, 0.0, 0.0),
    "modified trapezoid": (14.001, 0.0, 3.113, 0.0, 0.267),
}
BAND = {"ZV": 4.0 / math.pi * math.asin(0.05), "ZVD": 4.0 / math.pi * math.asin(math.sqrt(0.05)), "EI": 0.3995}


def residual(move, periods: float, damping: float = 0.0) -> float:
    """The vibration behind a move of a law, as a share of its lift, by T/T_n."""
    pieces = motion_pieces(Motion([Phase(move, 1.0, 1.0)]))
    velocities = [(piece.curves[1], piece.duration, 1.0 - piece.begin) for piece in pieces]
    return left_by(velocities, 2.0 * math.pi * periods, damping)


@pytest.mark.parametrize("name", PERCENT)
def test_vibration_is_as_printed(name: str) -> None:
    left = np.array([residual(law(name), ratio) for ratio in PERIODS])
    assert np.round(100.0 * left, 3) == pytest.approx(PERCENT[name], abs=1e-9)


@pytest.mark.parametrize("name", ["MSN", "CUB", "LIN"])
@pytest.mark.parametrize("damping", [0.0, 0.3])
def test_vibration_is_that_of_an_oscillator_integrated_in_time(name: str, damping: float) -> None:
    move, omega = law(name), 2.0 * math.pi * 2.3
    pushed = lambda t, x: [x[1], -2.0 * damping * omega * x[1] - omega**2 * x[0] - move.a(min(t, 1.0))]  # noqa: E731
    x, v = solve_ivp(pushed, (0.0, 1.0), [0.0, -move.start.v], rtol=1e-10, atol=1e-12, max_step=0.02).y[:, -1]
    v += move.end.v
    damped = omega * math.sqrt(1.0 - damping**2)
    assert residual(move, 2.3, damping) == pytest.approx(math.hypot(x, (v + damping * omega * x) / damped), abs=1e-5)


def test_vibration_refuses_what_is_no_oscillator() -> None:
    with pytest.raises(ValueError, match="damping is 1; expected a ratio from 0 to below 1"):
        residual(law("PO5"), 1.0, 1.0)
    with pytest.raises(ValueError, match="expected ZV, ZVD, EI"):
        Shaper("ZVDD")


@pytest.mark.parametrize(("kind", "printed", "time"), [("ZV", 0.063, 0.5), ("ZVD", 0.286, 1.0), ("EI", 0.399, 1.0)])
def test_the_band_of_a_shaper_is_as_printed_and_by_its_closed_form(kind: str, printed: float, time: float) -> None:
    low, high = Shaper(kind).band
    assert high - low == pytest.approx(BAND[kind], abs=1e-4)
    assert high - low == pytest.approx(printed, abs=0.0012)  # Singhose cuts his figures off
    assert Shaper(kind).time == time


@pytest.mark.parametrize(("kind", "damping"), [("ZV", 0.0), ("ZV", 0.1), ("ZVD", 0.0), ("ZVD", 0.1)])
def test_a_shaper_leaves_nothing_at_the_frequency_that_it_is_made_for(kind: str, damping: float) -> None:
    shaper = Shaper(kind, damping)
    assert shaper.left(1.0) == pytest.approx(0.0, abs=1e-12)
    assert math.fsum(shaper.shares) == pytest.approx(1.0, abs=1e-15)


def test_a_shaper_that_is_extra_insensitive_leaves_its_share_at_three_frequencies() -> None:
    shaper = Shaper("EI")
    assert [shaper.left(ratio) for ratio in (*shaper.band, 1.0)] == pytest.approx([0.05] * 3)


@pytest.mark.parametrize("kind", Shaper.KINDS)
@pytest.mark.parametrize("name", ["CIC", "MTP", "PO7", "DHM", "ACS"])
@pytest.mark.parametrize(("periods", "damping"), [(3.3, 0.0), (1.01 / (1.0 - SHORTEST), 0.04)])
def test_a_law_given_out_leaves_the_share_of_its_shaper(name: str, kind: str, periods: float, damping: float) -> None:
    """At the frequency it is made for and beside it; its position is the sum of the laws that the impulses begin."""
    shaper, base = Shaper(kind, damping), law(name)
    given, alone = shaper.law(base, periods, 60), periods - shaper.time
    xi = np.linspace(0.0, 1.0, 301)
    begun = (xi - wait / periods for wait in np.linspace(0.0, shaper.time, len(shaper.shares)))
    parts = [base.s(np.clip(each * periods / alone, 0.0, 1.0)) for each in begun]
    assert given.s(xi) == pytest.approx(np.array(shaper.shares) @ parts, abs=2e-5)
    assert (given.end.s, given.end.v) == pytest.approx((1.0, 0.0), abs=1e-11)
    assert given.coefficients.cv <= base.coefficients.cv * periods / alone * (1.0 + 1e-4)
    for ratio in (0.9, 1.0, 1.1):
        left = residual(given, periods * ratio, damping)
        assert left == pytest.approx(shaper.left(ratio) * residual(base, alone * ratio, damping), abs=2e-5)


def test_a_law_that_cannot_be_given_out_says_why() -> None:
    with pytest.raises(ValueError, match=r"expected at least 1\.01, as EI"):
        Shaper("EI").law(law("MTP"), 1.0, 60)
    with pytest.raises(ValueError, match="a law of more than 20 pieces; expected another to be given out by ZVD"):
        Shaper("ZVD").law(law("MTP"), 3.3, 20)
