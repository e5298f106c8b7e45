"""Pieces of a law, a(u) = polynomial(u) + sines: their integrals, their places in a law, cuts and reversal."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array, require_finite, stage_of

POWERS = 6  # coefficients of the polynomial, at most
SINES = (POWERS, POWERS + 4)  # where the two sines stand in :attr:`Piece.row`
Columns = Sequence[Array] | Array
Sine = tuple[float, float, float]  # P, ω, φ of P sin(ωu + φ)


@dataclass(frozen=True)
class Piece:
    """A piece of a law: a(u) = c0 + c1 u + … + c5 u⁵ + P sin(ωu + φ) + P₂ sin(ω₂u + φ₂), u from its begin."""

    duration: float  # share of the law's time, 0 or more, else ValueError
    c: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0)  # c0 to c3, c4 or c5, else ValueError
    amplitude: float = 0.0  # P
    omega: float = 0.0  # ω, rad per unit of ξ
    phase: float = 0.0  # φ (rad)
    amplitude2: float = 0.0  # P₂; only DHM has two sines
    omega2: float = 0.0  # ω₂, rad per unit of ξ
    phase2: float = 0.0  # φ₂ (rad)

    def __post_init__(self) -> None:
        if not 4 <= len(self.c) <= POWERS:
            raise ValueError(f"{len(self.c)} coefficients of the polynomial are given; expected c0 to c3, c4 or c5")
        require_finite(duration=self.duration, amplitude=self.amplitude, omega=self.omega, phase=self.phase)
        require_finite(amplitude2=self.amplitude2, omega2=self.omega2, phase2=self.phase2)
        require_finite(**{f"c{i}": c for i, c in enumerate(self.c)})
        if self.duration < 0.0:
            raise ValueError(f"the duration of a piece is {self.duration:g}; expected 0 or more")
        object.__setattr__(self, "c", tuple(float(c) for c in self.c))

    @property
    def both(self) -> tuple[Sine, Sine]:
        """P, ω, φ of both sines."""
        return (self.amplitude, self.omega, self.phase), (self.amplitude2, self.omega2, self.phase2)

    @property
    def sines(self) -> tuple[Sine, ...]:
        """P, ω, φ of each sine that is not 0."""
        return tuple(sine for sine in self.both if sine[0])

    @property
    def row(self) -> tuple[float, ...]:
        """c0 … c5, then P, ω, sin φ, cos φ of both sines, as :func:`gains` takes them."""
        c = self.c + (0.0,) * (POWERS - len(self.c))
        return (*c, *(x for p, w, phi in self.both for x in (p, w, math.sin(phi), math.cos(phi))))

    def scaled(self, height: float, time: float = 1.0) -> "Piece":
        """Return the piece with its accelerations times ``height`` and its duration times ``time``.

        c_i becomes height c_i/timeⁱ, P becomes height P, ω becomes ω/time; φ stays. Raises ValueError unless time > 0.
        """
        if not time > 0.0:
            raise ValueError(f"the time is {time:g}; expected more than 0")
        return replace(
            self,
            duration=self.duration * time,
            c=tuple(height * c / time**i for i, c in enumerate(self.c)),
            amplitude=height * self.amplitude,
            omega=self.omega / time,
            amplitude2=height * self.amplitude2,
            omega2=self.omega2 / time,
        )


def gains(u: Array, row: Array) -> tuple[Array, Array, Array, Array]:
    """Return ∬a, ∫a, a and da/du of pieces from their begin to u; ``row`` is :attr:`Piece.row`, in columns."""
    return gains_of(u, row[:POWERS], [row[k : k + 4] for k in SINES if row[k].any()])


def snap(u: Array, row: Array) -> Array:
    """Return d²a/du² of pieces at u; ``row`` is :attr:`Piece.row`, in columns."""
    b = np.zeros_like(u)
    for i in range(POWERS - 1, 1, -1):
        b = b * u + i * (i - 1) * row[i]
    for p, w, sin_phi, cos_phi in (row[k : k + 4] for k in SINES if row[k].any()):
        b = b - p * w**2 * (sin_phi * np.cos(w * u) + cos_phi * np.sin(w * u))
    return b


def gains_of(u: Array, c: Columns, sines: Sequence[Columns]) -> tuple[Array, Array, Array, Array]:
    """Return ∬a, ∫a, a and da/du for an acceleration that is a polynomial plus sines.

    With h = ωu/2 and m, n the sine and cosine of φ + h, the integrals of a sine are
    ∫ = u m sin h/h and ∬ = u² (sin φ (sin h/h)²/2 + cos φ (2h − sin 2h)/(2h)²); they hold for ω = 0 too.

    Parameters
    ----------
    u : array (n,), any unit of time
        Time since the begin of the piece.
    c : sequence of float or array (n,), any unit of acceleration by powers of that time
        Coefficients of the polynomial, of 1, u, u², ….
    sines : sequence of such columns
        Amplitude P (unit of acceleration), frequency ω (rad per unit of time), sin φ and cos φ of each sine.

    Returns
    -------
    four arrays (n,)
        Gain of position and of velocity, acceleration, jerk.
    """
    s, v, a, j = (np.zeros_like(u) for _ in range(4))
    for i in range(len(c) - 1, -1, -1):
        s = s * u + c[i] / ((i + 1) * (i + 2))
        v = v * u + c[i] / (i + 1)
        j = j * u + a
        a = a * u + c[i]
    s, v = u * u * s, u * v
    for p, w, sin_phi, cos_phi in sines:
        h = w * u / 2.0
        sin, cos = np.sin(h), np.cos(h)
        m, n = sin_phi * cos + cos_phi * sin, cos_phi * cos - sin_phi * sin
        sinc = np.divide(sin, h, out=np.ones_like(h), where=h != 0.0)
        s = s + p * u * u * (sin_phi * sinc * sinc / 2.0 + cos_phi * _lag(h, sin, cos))
        v = v + p * u * m * sinc
        a = a + p * (m * cos + n * sin)
        j = j + p * w * (n * cos - m * sin)
    return s, v, a, j


class PlacedPiece(NamedTuple):
    """A piece at its place in a law.

    The position on it is S0 + u (S1 + polynomial) − Σ P/ω² sin(ωu + φ), the velocity S1 + polynomial −
    Σ P/ω cos(ωu + φ), summed over its sines: a formula each for every piece of every law.
    """

    piece: Piece
    begin: float  # ξ_k
    s: float  # position s_k at the begin
    v: float  # velocity v_k at the begin
    ds: float  # gain of s over the piece
    dv: float  # gain of v over the piece

    @property
    def amplitudes(self) -> list[tuple[float, float, float]]:
        """Amplitudes P/ω², P/ω and P ω of both sines in position, velocity and jerk; the first two are 0 if ω = 0."""
        return [(p / w**2, p / w, p * w) if w > 0.0 else (0.0, 0.0, p * w) for p, w, _ in self.piece.both]

    @property
    def constants(self) -> tuple[float, float]:
        """S0 = s_k + Σ P/ω² sin φ and S1 = v_k + Σ P/ω cos φ over both sines."""
        sines = [(s, v, phi) for (s, v, _), (_, _, phi) in zip(self.amplitudes, self.piece.both, strict=True)]
        return (
            self.s + math.fsum(s * math.sin(phi) for s, _, phi in sines),
            self.v + math.fsum(v * math.cos(phi) for _, v, phi in sines),
        )


def begins(pieces: Sequence[Piece]) -> list[float]:
    """Return the ξ at which each piece begins, at most 1."""
    return [min(xi, 1.0) for xi in itertools.accumulate((piece.duration for piece in pieces[:-1]), initial=0.0)]


def placed_pieces(pieces: Sequence[Piece], v: float = 0.0) -> list[PlacedPiece]:
    """Return consecutive pieces at their places in a law that begins at s = 0 with the velocity ``v``."""
    if not pieces:
        return []
    durations = np.array([piece.duration for piece in pieces])
    rows = np.array([piece.row for piece in pieces]).T
    gained, rates, _, _ = gains(durations, rows)
    places, s = [], 0.0
    for piece, begin, ds, dv in zip(pieces, begins(pieces), gained.tolist(), rates.tolist(), strict=True):
        places.append(PlacedPiece(piece, begin, s, v, v * piece.duration + ds, dv))
        s, v = s + places[-1].ds, v + dv
    return places


class Located(NamedTuple):
    """Places of abscissae among the pieces of a law, arrays of equal shape."""

    piece: NDArray[np.intp]  # number of the piece, from 0
    u: Array  # ξ since its begin
    angle: Array  # ωu + φ of its first sine (rad)
    angle2: Array  # of its second sine (rad)


def located(pieces: Sequence[Piece], xi: Array) -> Located:
    """Return the piece of each ξ: the last that begins at or before it; ξ = 1 is in the last."""
    starts = np.array(begins(pieces))
    k = stage_of(xi, starts)
    u = xi - starts[k]
    rates = np.array([(piece.omega, piece.phase, piece.omega2, piece.phase2) for piece in pieces]).T
    omega, phi, omega2, phi2 = rates[:, k]
    return Located(k, u, omega * u + phi, omega2 * u + phi2)


def _lag(h: Array, sin: Array, cos: Array) -> Array:
    """Return (2h − sin 2h)/(2h)², for small h by its series, as the difference would lose digits."""
    y = 4.0 * h * h
    series = h / 3.0
    term = np.ones_like(h)
    for divisor in (210.0, 156.0, 110.0, 72.0, 42.0, 20.0):
        term = 1.0 - y / divisor * term
    # the floor only avoids 0/0, where the series is used
    direct = (h - sin * cos) / np.maximum(0.5 * y, 0.5)
    return np.where(y < 1.0, series * term, direct)


def cut_piece(piece: Piece, shares: Sequence[float]) -> list[Piece]:
    """Return the parts of a piece between these shares of its duration, each with u from its own begin.

    c'_i = Σ_{k ≥ i} c_k C(k, i) u₀ᵏ⁻ⁱ, φ' = φ + ω u₀ from the begin u₀ of a part.
    """
    edges = [0.0, *(share * piece.duration for share in shares), piece.duration]
    return [
        replace(
            piece,
            duration=end - begin,
            c=shifted(piece.c, begin),
            phase=piece.phase + piece.omega * begin,
            phase2=piece.phase2 + piece.omega2 * begin,
        )
        for begin, end in itertools.pairwise(edges)
    ]


def backwards(piece: Piece) -> Piece:
    """Return a piece reversed in time, with the acceleration a'(u) = −a(d − u), so that a rise stays a rise.

    c'_i = −(−1)ⁱ Σ_{k ≥ i} c_k C(k, i) dᵏ⁻ⁱ, P' = P, ω' = ω, φ' = −(ωd + φ).
    """
    d = piece.duration
    return replace(
        piece,
        c=tuple(-((-1.0) ** i) * c for i, c in enumerate(shifted(piece.c, d))),
        phase=-(piece.omega * d + piece.phase),
        phase2=-(piece.omega2 * d + piece.phase2),
    )


def shifted(c: Sequence[float], d: float) -> tuple[float, ...]:
    """Return the coefficients Σ_{k ≥ i} c_k C(k, i) dᵏ⁻ⁱ of the polynomial Σ c_k xᵏ in powers of x − d."""
    n = len(c)
    return tuple(math.fsum(c[k] * math.comb(k, i) * d ** (k - i) for k in range(i, n)) for i in range(n))


def reversed_pieces(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces of the movement reversed in time: from rest to a velocity for from a velocity to rest."""
    return tuple(map(backwards, reversed(pieces)))
