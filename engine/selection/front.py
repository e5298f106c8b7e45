"""The designs that no other beats in all that is asked of them."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def front(points: ArrayLike) -> NDArray[np.intp]:
    """Return which points, rows of objectives of which less is better, no other point beats; of equal ones the first.

    A point beats another that is nowhere less and somewhere more. They come by the first objective, then the next.
    Source: V. Pareto, Manuale di economia politica (1906); H. T. Kung, F. Luccio, F. P. Preparata, J. ACM 22 (1975).
    """
    values = np.asarray(points, dtype=np.float64)
    if not values.size:
        return np.zeros(0, dtype=np.intp)
    left, kept = np.lexsort(values.T[::-1]), []
    if values.shape[1] == 2:  # at once, as there may be very many
        second = values[left, 1]
        return np.asarray(left[np.append(True, second[1:] < np.minimum.accumulate(second)[:-1])])
    while left.size:  # of points so sorted none beats the first
        kept.append(left[0])
        left = left[(values[left] < values[left[0]]).any(axis=1)]
    return np.array(kept)
