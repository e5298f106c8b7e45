"""What s, v, a, j of each law cost over a million samples, as a ratio to one np.sin over the same samples."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from rich.console import Console
from rich.table import Table

from engine.laws import CATALOGUE, Law, ModifiedTrapezoidal, Piece, PieceLaw

SAMPLES = 10**6
ROUNDS = 7
GOAL = 12.0

MIXED = PieceLaw(
    [
        Piece(0.3, amplitude=6.0, omega=5.0),
        Piece(0.2, (6.0, -30.0, 2.0, 0.0), amplitude=1.0, omega=9.0, phase=0.4),
        Piece(0.5, (-4.0, 8.0, 0.0, 0.0)),
    ]
)


def laws() -> dict[str, Law]:
    """Every law of the catalogue, and two that have all that can cost time."""
    cases = {entry.code: entry.example() for entry in CATALOGUE}
    cases["MTP, asymmetric"] = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
    cases["OWN, mixed pieces"] = MIXED
    return cases


def ratios(laws: dict[str, Law], xi: np.ndarray) -> tuple[dict[str, float], float]:
    """Best time of each law over the best of np.sin, and the latter in seconds; the rounds take turns."""
    tasks: dict[str, Callable[[np.ndarray], object]] = {"sin": np.sin}
    tasks |= {name: law.evaluate for name, law in laws.items()}
    best = dict.fromkeys(tasks, float("inf"))
    for _ in range(ROUNDS):
        for name, task in tasks.items():
            begin = time.perf_counter()
            task(xi)
            best[name] = min(best[name], time.perf_counter() - begin)
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
        verdict = f"≤ {GOAL:g} " + ("met" if worst <= GOAL else "missed")
        table.add_row(name, f"{ordered[name]:.1f}", f"{disordered[name]:.1f}", verdict)
    console = Console()
    console.print(table)
    console.print(f"np.sin itself: {sine / SAMPLES * 1e9:.2f} ns a sample")


if __name__ == "__main__":
    main()
