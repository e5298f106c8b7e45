"""What s, v, a, j of each law cost over a million samples, as a ratio to one np.sin over the same samples."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from rich.console import Console
from rich.table import Table

from engine.laws import CATALOGUE, Law, Piece, PieceLaw
from engine.laws.ends import BoundaryValues
from engine.laws.modified import ModifiedTrapezoidal, SineConstantCosine
from engine.laws.polynomials import Polynomial4567
from engine.laws.simple import DoubleHarmonic
from engine.laws.spline import Spline

SAMPLES = 10**6
ROUNDS = 7
GOAL = 12.0
WIDE_GOAL = 20.0
"""of laws of one's own, of points and of two sines"""

MIXED = PieceLaw(
    [
        Piece(0.3, amplitude=6.0, omega=5.0),
        Piece(0.2, (6.0, -30.0, 2.0, 0.0), amplitude=1.0, omega=9.0, phase=0.4),
        Piece(0.5, (-4.0, 8.0, 0.0, 0.0)),
    ]
)


POINTS = Spline(tuple((k / 99, k / 99 + 0.01 * (-1) ** k if 0 < k < 99 else k / 99) for k in range(100)))
BOTH_SINES = Piece(1.0, (1.0, -2.0, 3.0, -4.0, 5.0, -6.0), 6.0, 5.0, 0.1, 3.0, 11.0, 0.7)


def laws() -> dict[str, Law]:
    """Every law of the engine, and some that have all that can cost time."""
    cases = {one.code: one() for one in CATALOGUE}
    cases["MTP, asymmetric"] = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
    cases["SCC, at speed"] = SineConstantCosine(0.1, 0.2, 0.3, 0.4, 0.6).between(BoundaryValues(1.0, -0.4, 0.9))
    cases["PO7, between ends"] = Polynomial4567().between(BoundaryValues(1.0, 0.4, -0.3, 1.0, 2.0, 3.0, 4.0))
    cases["SPL, 100 points"] = POINTS
    cases["OWN, mixed pieces"] = MIXED
    cases["OWN, two sines"] = PieceLaw([BOTH_SINES])
    return cases


def goal(law: Law) -> float:
    """The greatest ratio that is wanted of a law."""
    return WIDE_GOAL if isinstance(law, PieceLaw | Spline | DoubleHarmonic) else GOAL


def ratios(laws: dict[str, Law], xi: np.ndarray) -> tuple[dict[str, float], float]:
    """Least processor time of each law over that of np.sin, and the latter in seconds; the rounds take turns."""
    tasks: dict[str, Callable[[np.ndarray], object]] = {"sin": np.sin}
    tasks |= {name: law.evaluate for name, law in laws.items()}
    best = dict.fromkeys(tasks, float("inf"))
    for _ in range(ROUNDS):
        for name, task in tasks.items():
            begin = time.process_time()
            task(xi)
            best[name] = min(best[name], time.process_time() - begin)
    sine = best.pop("sin")
    return {name: seconds / sine for name, seconds in best.items()}, sine


def main() -> None:
    """Print the ratios for samples in order and in disorder."""
    in_order = np.linspace(0.0, 1.0, SAMPLES)
    shuffled = np.random.default_rng(1).permutation(in_order)
    cases = laws()
    ordered, sine = ratios(cases, in_order)
    disordered, _ = ratios(cases, shuffled)
    table = Table("Law", "In order", "Shuffled", "Goal", title=f"s, v, a, j of {SAMPLES:,} samples / np.sin")
    for name in cases:
        worst = max(ordered[name], disordered[name])
        wanted = goal(cases[name])
        verdict = f"≤ {wanted:g} " + ("met" if worst <= wanted else "missed")
        table.add_row(name, f"{ordered[name]:.1f}", f"{disordered[name]:.1f}", verdict)
    console = Console()
    console.print(table)
    console.print(f"np.sin itself: {sine / SAMPLES * 1e9:.2f} ns a sample")


if __name__ == "__main__":
    main()
