"""Equal steps of ξ."""

import numpy as np

from engine.laws.base import Array


def abscissae(intervals: int) -> Array:
    """Return ξ = k/N for k = 0 … N."""
    return np.arange(intervals + 1) / intervals
