"""Coefficients that books print, to their printed digits."""

import math

import pytest

from engine.laws import ConstantAcceleration, Cubic, Cycloidal, ModifiedTrapezoidal, PieceLaw, TrapezoidalVelocity

INF = math.inf
HARMONIC = ModifiedTrapezoidal((0, 0, 1 / 2, 0, 1 / 2, 0, 0))
MODIFIED_SINE = ModifiedTrapezoidal((1 / 8, 0, 3 / 8, 0, 3 / 8, 0, 1 / 8))
POLYNOMIAL_345 = PieceLaw()


@pytest.mark.parametrize(
    ("law", "cv", "ca", "ca_rms", "cj", "va"),
    [
        pytest.param(ConstantAcceleration(), 2, 4, 4, INF, 8, id="constant acceleration"),
        pytest.param(TrapezoidalVelocity(), 1.5, 4.5, 3.674235, INF, 6.75, id="trapezoidal velocity 1/3"),
        pytest.param(Cubic(), 1.5, 6, 3.464102, INF, 3.464102, id="cubic"),
        pytest.param(HARMONIC, 1.570796, 4.934802, 3.489432, INF, 3.875785, id="simple harmonic"),
        pytest.param(Cycloidal(), 2, 6.283185, 4.442883, 39.478418, 8.162097, id="cycloidal"),
        pytest.param(ModifiedTrapezoidal(), 2, 4.888124, 4.233239, 61.42598, 8.089981, id="modified trapezoidal"),
        pytest.param(MODIFIED_SINE, 1.759603, 5.527957, 3.908856, 69.4664, 5.457753, id="modified sine"),
        pytest.param(POLYNOMIAL_345, 1.875, 5.773503, 4.140393, 60, 6.694269, id="polynomial 3-4-5"),
    ],
)
def test_printed_coefficients(law, cv, ca, ca_rms, cj, va):
    k = law.coefficients
    assert (k.cv, k.ca, k.ca_rms, k.va) == pytest.approx((cv, ca, ca_rms, va), abs=5.1e-7)
    assert k.cj == pytest.approx(cj, abs=6e-5 if cj > 65 else 6e-6)
