"""The Pareto front: designs that no other design beats in all objectives."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def front(points: ArrayLike) -> NDArray[np.intp]:
    """Return the row numbers of the Pareto-optimal points, of equal ones the first; less is better in each column.

    A point is beaten by another that is nowhere more and somewhere less. They are sorted by the first objective on.
    Source: V. Pareto, Manuale di economia politica (1906); H. T. Kung, F. Luccio, F. P. Preparata, J. ACM 22 (1975).
    """
    values = np.asarray(points, dtype=np.float64)
    if not values.size:
        return np.zeros(0, dtype=np.intp)
    left, indices = np.lexsort(values.T[::-1]), []
    if values.shape[1] == 2:  # at once, as there may be very many
        second = values[left, 1]
        return np.asarray(left[np.append(True, second[1:] < np.minimum.accumulate(second)[:-1])])
    while left.size:  # of points so sorted none beats the first
        indices.append(left[0])
        left = left[(values[left] < values[left[0]]).any(axis=1)]
    return np.array(indices)
