"""Every law of the engine, wherever it is registered, and what tests of laws share."""

import pkgutil
from importlib import import_module
from itertools import pairwise

import numpy as np

import engine.laws
from engine.laws import Entry
from engine.laws.piece import gains

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
SHARE = np.linspace(0.02, 0.98, 13)
COEFFICIENTS = ("cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min")


def _entries():
    modules = (import_module(f"engine.laws.{found.name}") for found in pkgutil.iter_modules(engine.laws.__path__))
    found = (getattr(module, "ENTRY", None) for module in modules)
    return tuple(sorted((entry for entry in found if isinstance(entry, Entry)), key=lambda entry: entry.code))


ENTRIES = _entries()
"""of every module in engine/laws that has one: those without a page are measured too"""

EXAMPLES = tuple(
    (f"{entry.code} {k}", law) for entry in ENTRIES for k, law in enumerate((*entry.examples, *entry.beyond))
)


def stages(law):
    """Begin and end of each stage that lasts."""
    edges = [0.0, *law.breaks, 1.0]
    return [(begin, end) for begin, end in pairwise(edges) if end > begin]


def integrals(law):
    """For each stage of a law its begin and end, and the integrals of v, a, j and a² over it, by Gauss-Legendre."""
    for begin, end in stages(law):
        half = (end - begin) / 2
        at = law.evaluate(begin + half * (NODES + 1))
        yield begin, end, [float(half * WEIGHTS @ values) for values in (at.v, at.a, at.j, at.a**2)]


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
