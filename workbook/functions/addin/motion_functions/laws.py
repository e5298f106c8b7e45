"""The laws that the functions MOTION.* know, declared once for the add-in and the names of Excel.

A law is seven stages, a polynomial of two halves, or pieces written out, by functions of its parameters. The add-in
calls them with numbers; ``workbook/functions/lambdas.py`` with the names of parameters, and so has the formulas of
the LAMBDA texts. The own law, whose pieces are its parameters, stands beside them.
"""

from __future__ import annotations

import math
from typing import Any, Callable, Mapping, NamedTuple, Sequence

SUM_TOLERANCE = 1e-9  # of the durations of a law
OWN_WIDTH = 8
OWN = ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),)
"""the pieces of the own law where none are given"""


class Text(NamedTuple):
    """The same words in English, Italian and German."""

    en: str
    it: str
    de: str


class Domain(NamedTuple):
    """The numbers that a parameter may be: those named, else from 0 to 1; ``open`` without both ends."""

    among: tuple[float, ...] = ()
    open: bool = False

    def has(self, value: float) -> bool:
        """Whether a number is in the domain."""
        if self.among:
            return value in self.among
        return 0.0 < value < 1.0 if self.open else 0.0 <= value <= 1.0


class Declared(NamedTuple):
    """A law: its parameters as delivered, what they are called, and one of its three forms.

    ``stages`` gives the durations of the edge up, the constant and the edge down of the first pulse, of the uniform
    velocity, and of the second pulse in the order of time; edges are quarters of a sine, or ``straight``. ``half``
    has the acceleration of a polynomial's first half by powers of u/λ, over 1/λ and twice. ``pieces`` gives the
    entries of each piece by name, and ``begin`` is the velocity with which they begin.
    """

    takes: Text | None = None
    delivered: tuple[float, ...] = ()
    stages: Callable[..., Sequence[Any]] | None = None
    straight: bool = False
    half: tuple[float, ...] = ()
    pieces: Callable[..., Sequence[Mapping[str, Any]]] | None = None
    begin: float = 0.0
    domains: Mapping[int, Domain] = {}
    """of parameters by their place, where the durations that follow do not tell what is impossible"""


def turning(turn: Any, end: float, then: Any, other: Any) -> Any:
    """Return ``then`` where a motion turns round at this end (−1 start, 1 end), else ``other``."""
    if isinstance(turn, (int, float)):
        return then if turn == end else other
    return turn.chosen(end, then, other)


def shared(share: Any, rise: Sequence[Any], fall: Sequence[Any], cruise: Any = 0.0) -> Sequence[Any]:
    """Return the durations of two pulses by the shares of their stages, those of the second from its end."""
    return (*(share * d for d in rise), cruise, *((1.0 - share) * d for d in fall[::-1]))


def cut(share: Any, turn: Any, whole: Sequence[Any], rest: Sequence[Any]) -> Sequence[Any]:
    """Return the durations of two pulses, of which the one where the motion turns round has the stages ``rest``."""
    rise, fall = ([turning(turn, end, *both) for both in zip(rest, whole)] for end in (-1.0, 1.0))
    return shared(share, rise, fall)


def mirrored(half: Sequence[Any]) -> Sequence[Any]:
    """Return the acceleration of a polynomial's second half, by powers of u: that of the first, seen from its end."""
    n = len(half)
    return [-sum(half[i] * math.comb(i, k) * (-1) ** k for i in range(k, n)) for k in range(n)]


def two_sines(turn: Any) -> Sequence[Mapping[str, Any]]:
    """Return the piece of the double harmonic, from rest to a reversal at its end, or the other way round."""
    first, second = (turning(turn, 1.0, 0.5 * math.pi, past * math.pi) for past in (-1.5, -2.5))
    p = math.pi**2 / 2
    return [{"duration": 1.0, "amplitude": p, "omega": math.pi, "phase": first,
             "amplitude2": -p, "omega2": 2.0 * math.pi, "phase2": second}]  # fmt: skip


FLAT, HALVES, EDGE, QUARTERS = (0.0, 1.0, 0.0), (0.5, 0.0, 0.5), (0.0, 0.0, 1.0), (0.25, 0.5, 0.25)
"""stages of a pulse, from the dwell on"""
ENDS, ANYWHERE, PART, SHARED = Domain((-1.0, 1.0)), Domain((-1.0, 0.0, 1.0)), Domain(), {0: Domain(open=True)}
SHARE = Text(
    "share λ of the time that accelerates", "quota λ del tempo in accelerazione", "Anteil λ der Beschleunigung"
)
RAMPS = Text(
    "end of acceleration, start of deceleration",
    "fine dell'accelerazione, inizio della decelerazione",
    "Ende der Beschleunigung, Beginn der Verzögerung",
)
SEVEN = Text("seven durations", "sette durate", "sieben Dauern")
LAWS: dict[str, Declared] = {
    "DWL": Declared(pieces=lambda: [{"duration": 1.0}]),
    "LIN": Declared(pieces=lambda: [{"duration": 1.0}], begin=1.0),
    "ACS": Declared(SHARE, (0.5,), lambda share: shared(share, FLAT, FLAT)),
    "CIC": Declared(SHARE, (0.5,), lambda share: shared(share, HALVES, HALVES)),
    "CUB": Declared(SHARE, (0.5,), half=(1.5, -1.5), domains=SHARED),
    "SHM": Declared(SHARE, (0.5,), lambda share: shared(share, EDGE, EDGE)),
    "PO5": Declared(SHARE, (0.5,), half=(0.0, 7.5, -11.25, 3.75), domains=SHARED),
    "PO7": Declared(SHARE, (0.5,), half=(0.0, 0.0, 26.25, -52.5, 32.8125, -6.5625), domains=SHARED),
    "TVP": Declared(RAMPS, (1 / 3, 2 / 3), lambda rise, fall: (0.0, rise, 0.0, fall - rise, 0.0, 1.0 - fall, 0.0)),
    "SRT": Declared(
        RAMPS,
        (0.25, 0.75),
        lambda rise, fall: (rise / 2, 0.0, rise / 2, fall - rise, (1.0 - fall) / 2, 0.0, (1.0 - fall) / 2),
    ),
    "MTP": Declared(SEVEN, (0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125), lambda *d: d),
    "SCV": Declared(SEVEN, (1 / 12, 1 / 6, 1 / 12, 1 / 3, 1 / 12, 1 / 6, 1 / 12), lambda *d: d, straight=True),
    "DHM": Declared(
        Text("turns round at start or end", "inverte a start o end", "kehrt um bei start oder end"),
        (1.0,),
        pieces=two_sines,
        domains={0: ENDS},
    ),
    "MSN": Declared(
        Text("λ, first edge, last edge", "λ, primo e ultimo bordo", "λ, erste und letzte Flanke"),
        (0.5, 0.25, 0.25),
        lambda share, first, last: shared(share, (first, 0.0, 1.0 - first), (last, 0.0, 1.0 - last)),
    ),
    "MTS": Declared(
        Text("λ, none, start or end, edge", "λ, none, start o end, bordo", "λ, none, start oder end, Flanke"),
        (0.5, 0.0, 0.5),
        lambda share, turn, edge: cut(share, turn, QUARTERS, (0.0, 1.0 - edge, edge)),
        domains={1: ANYWHERE, 2: PART},
    ),
    "SCC": Declared(
        Text("sine, constant, cosine, straight, λ", "seno, costante, coseno, retta, λ",
             "Sinus, Konstante, Kosinus, Gerade, λ"),
        (1 / 3, 1 / 3, 1 / 3, 0.0, 0.5),
        lambda outer, level, inner, cruise, share: shared(share, (outer, level, inner), (outer, level, inner), cruise),
    ),
    "HAC": Declared(
        Text("λ, start or end", "λ, start o end", "λ, start oder end"),
        (0.5, 1.0),
        lambda share, turn: cut(share, turn, (0.25, 0.0, 0.75), EDGE),
        domains={1: ENDS},
    ),
    "SGS": Declared(
        Text("λ, share of the sines", "λ, quota dei seni", "λ, Anteil der Sinus"),
        (0.5, 0.5),
        lambda share, curved: shared(share, (0.0, 0.0, curved), (0.0, 0.0, curved), 1.0 - curved),
    ),
}  # fmt: skip
PARAMETERS = {code: len(one.delivered) for code, one in LAWS.items()}
OWN_TAKES = Text(
    "a row a piece (duration, c0, c1, c2, c3, P, ω, φ)",
    "una riga per tratto (durata, c0, c1, c2, c3, P, ω, φ)",
    "eine Zeile je Abschnitt (Dauer, c0, c1, c2, c3, P, ω, φ)",
)
