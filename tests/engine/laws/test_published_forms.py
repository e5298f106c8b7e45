"""Laws against the formulas that VDI 2143 and Norton's Cam Design and Manufacturing Handbook print for them."""

import numpy as np
import pytest

from engine import law

XI = np.linspace(0.0, 1.0, 1001)
PI = np.pi


def modified_sine(x):
    """Norton, section 3.4: three sines that meet at 1/8 and 7/8."""
    edge = PI * x - np.sin(4 * PI * x) / 4
    inner = 2 + PI * x - 9 / 4 * np.sin((4 * PI * x + PI) / 3)
    return np.select([x < 1 / 8, x < 7 / 8], [edge, inner], edge + 4) / (4 + PI)


def modified_trapezoid(x):
    """Norton, section 3.4: sines of the first and the last eighth of each half, constant acceleration between."""
    early = np.minimum(x, 1 - x)
    ca, w = 8 * PI / (2 + PI), 4 * PI
    rise = ca * (early - np.sin(w * early) / w) / w
    u = early - 1 / 8
    middle = ca * ((1 / 8 - 1 / w) / w + u / w + u**2 / 2)
    v = early - 3 / 8
    last = ca * ((1 / 8 - 1 / w) / w + 1 / 4 / w + 1 / 32 + v * (1 / w + 1 / 4) + (1 - np.cos(w * v)) / w**2)
    half = np.select([early < 1 / 8, early < 3 / 8], [rise, middle], last)
    return np.where(x <= 0.5, half, 1 - half)


PUBLISHED = {
    "LIN": lambda x: x,
    "ACS": lambda x: np.where(x < 0.5, 2 * x**2, 1 - 2 * (1 - x) ** 2),
    "CIC": lambda x: x - np.sin(2 * PI * x) / (2 * PI),
    "SHM": lambda x: (1 - np.cos(PI * x)) / 2,
    "DHM": lambda x: (1 - np.cos(PI * x)) / 2 - (1 - np.cos(2 * PI * x)) / 8,
    "CUB": lambda x: 3 * x**2 - 2 * x**3,
    "PO5": lambda x: 10 * x**3 - 15 * x**4 + 6 * x**5,
    "PO7": lambda x: 35 * x**4 - 84 * x**5 + 70 * x**6 - 20 * x**7,
    "MSN": modified_sine,
    "MTP": modified_trapezoid,
}


@pytest.mark.parametrize("code", PUBLISHED)
def test_the_position_is_as_published(code):
    np.testing.assert_allclose(law(code).s(XI), PUBLISHED[code](XI), rtol=0, atol=1e-13)
