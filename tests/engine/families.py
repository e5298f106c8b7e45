"""Every law of the engine, with what it claims, and what tests of laws share."""

from itertools import pairwise

import numpy as np

from engine.laws.piece import gains
from tests.engine.laws.claims import CLAIMS

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
SHARE = np.linspace(0.02, 0.98, 13)
COEFFICIENTS = ("cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min")


ENTRIES = tuple(sorted(CLAIMS, key=lambda entry: entry.code))

EXAMPLES = tuple(
    (f"{entry.code} {k}", law) for entry in ENTRIES for k, law in enumerate((*entry.examples, *entry.beyond))
)


def stages(law):
    """Begin and end of each stage that lasts."""
    edges = [0.0, *law.breaks, 1.0]
    return [(begin, end) for begin, end in pairwise(edges) if end > begin]


def integrals(law):
    """For each stage of a law its begin and end, and the integrals of v, a, j, a² and v² over it, by Gauss-Legendre."""
    for begin, end in stages(law):
        half = (end - begin) / 2
        at = law.evaluate(begin + half * (NODES + 1))
        yield begin, end, [float(half * WEIGHTS @ values) for values in (at.v, at.a, at.j, at.a**2, at.v**2)]


def carried(law):
    """ξ within each piece of a law, with s, v, a and j carried on from its start piece by piece."""
    begin, s, v = 0.0, law.start.s, law.start.v
    for piece in law.as_pieces():
        u = np.append(piece.duration * SHARE, piece.duration)
        ds, dv, a, j = gains(u, np.array(piece.row)[:, None])
        values = s + v * u + ds, v + dv, a, j
        if piece.duration > 0:
            yield begin + u[:-1], [x[:-1] for x in values]
        begin, s, v = begin + piece.duration, float(values[0][-1]), float(values[1][-1])


def largest(law):
    """The sizes of s, v, a and j, to compare with; never 0."""
    xi = np.concatenate([begin + (end - begin) * np.linspace(0.001, 0.999, 97) for begin, end in stages(law)])
    return [max(1.0, float(np.abs(values).max())) for values in law.evaluate(xi)]
