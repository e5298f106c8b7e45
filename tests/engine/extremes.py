"""The exact extremes of pieces of a law, by the places at which the engine finds its rates stationary."""

from typing import NamedTuple

import numpy as np

from engine.laws.extremes import stationary_points, values_by_piece


class Extremes(NamedTuple):
    """Lowest and largest v, a and j; jumps of a do not count in j."""

    v: tuple[float, float]
    a: tuple[float, float]
    j: tuple[float, float]


def extremes_of(pieces, v0):
    """Return the exact extremes of consecutive pieces that begin with the velocity ``v0``."""
    _, *rates = np.concatenate(values_by_piece(pieces, v0, lambda piece, _: stationary_points(piece)), axis=1)
    return Extremes(*((float(x.min()), float(x.max())) for x in rates))
