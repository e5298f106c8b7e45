"""Where v, a, j and v·a of one piece a(u) = polynomial + P sin(ωu + φ) are stationary."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.polynomial import Polynomial

from engine.laws.base import Array

CELLS = 512  # at least, in which a mixed piece is searched for changes of sign
HALVINGS = 60


def stationary(
    c: Sequence[float], amplitude: float, omega: float, phase: float, duration: float, v0: float
) -> list[float]:
    """Return the abscissae within the piece where v, a, j or v·a is stationary.

    Roots of the polynomial or angles of the sine in closed form; where both are present, roots refined to
    the last digit by halving.
    """
    polynomial, sine = any(c), bool(amplitude and omega)
    if sine and polynomial:
        found = _mixed(Polynomial(c), amplitude, omega, phase, duration, v0)
    elif sine:
        found = _sine(amplitude, omega, phase, duration, v0)
    else:
        constant = amplitude * math.sin(phase)
        found = _polynomial(Polynomial([c[0] + constant, *c[1:]]), v0)
    return [u for u in found if 0.0 < u < duration]


def _polynomial(a: Polynomial, v0: float) -> list[float]:
    v = a.integ() + v0
    roots = [f.trim().roots() for f in (a, a.deriv(), a.deriv(2), (v * a).deriv())]
    # the real part of a complex root is a harmless candidate; that of a split double root is a needed one
    return [float(root.real) for group in roots for root in group]


def _sine(amplitude: float, omega: float, phase: float, duration: float, v0: float) -> list[float]:
    """v, a, j at multiples of π/2; v·a = (V − q cos x) P sin x where 2q cos²x − V cos x − q = 0, q = P/ω."""
    q = amplitude / omega
    mean = v0 + q * math.cos(phase)
    root = math.hypot(mean, math.sqrt(8.0) * q)
    angles = [0.0, math.pi / 2, math.pi, 3 * math.pi / 2]
    for cos in ((mean + root) / (4.0 * q), (mean - root) / (4.0 * q)):
        if abs(cos) <= 1.0:
            angles += [math.acos(cos), -math.acos(cos)]
    low, high = sorted((phase, omega * duration + phase))
    turns = range(math.floor(low / math.tau) - 1, math.ceil(high / math.tau) + 1)
    return [(angle + math.tau * turn - phase) / omega for turn in turns for angle in angles]


def _mixed(
    polynomial: Polynomial, amplitude: float, omega: float, phase: float, duration: float, v0: float
) -> list[float]:
    slope, bend, integral = polynomial.deriv(), polynomial.deriv(2), polynomial.integ()
    q = amplitude / omega

    def a(u: Array) -> Array:
        return np.asarray(polynomial(u) + amplitude * np.sin(omega * u + phase))

    def j(u: Array) -> Array:
        return np.asarray(slope(u) + amplitude * omega * np.cos(omega * u + phase))

    def snap(u: Array) -> Array:
        return np.asarray(bend(u) - amplitude * omega**2 * np.sin(omega * u + phase))

    def power_slope(u: Array) -> Array:
        v = v0 + integral(u) + q * (math.cos(phase) - np.cos(omega * u + phase))
        return np.asarray(a(u) ** 2 + v * j(u))

    cells = CELLS + int(abs(omega) * duration * 16.0)
    grid = np.linspace(0.0, duration, cells + 1)
    return [u for f in (a, j, snap, power_slope) for u in _roots(f, grid)]


def _roots(f: Callable[[Array], Array], grid: Array) -> list[float]:
    """Return where f changes sign between the points of a grid, halving all cells at once."""
    negative = f(grid) < 0.0
    cells = np.flatnonzero(negative[1:] != negative[:-1])
    low, high, below = grid[cells], grid[cells + 1], negative[cells]
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        same = (f(middle) < 0.0) == below
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return [float(u) for u in low]
