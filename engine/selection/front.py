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
    order = np.lexsort(values.T[::-1])
    ranked = values[order]
    if values.shape[1] == 1:
        return np.asarray(order[:1])
    if values.shape[1] == 2:
        lowest = np.minimum.accumulate(ranked[:, 1])
        return np.asarray(order[np.concatenate([[True], ranked[1:, 1] < lowest[:-1]])])
    return np.asarray(order[_unbeaten(ranked)])


def _unbeaten(ranked: NDArray[np.float64]) -> list[int]:
    """Return the rows of sorted points that no row above is nowhere more than; those below never beat one above."""
    left = np.arange(len(ranked))
    kept: list[int] = []
    while left.size:
        best = left[0]
        kept.append(int(best))
        left = left[(ranked[left] < ranked[best]).any(axis=1)]
    return kept
