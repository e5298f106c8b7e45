"""What it costs to judge and rank a million motor–reducer pairs, as a ratio to one multiplication of each pair."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

import numpy as np
from rich.console import Console
from rich.table import Table

from engine.pairing import Motors, Reducers, rank, usable
from engine.selection import Task

MOTORS = REDUCERS = 1000
ROUNDS = 9
SHORT_LIST = 100


def catalogues() -> tuple[Motors, Reducers]:
    """Made-up catalogues with the spread of real ones: J_M grows with T_N to the power 1.6."""
    rng = np.random.default_rng(1)
    rated = np.geomspace(0.1, 100.0, MOTORS)
    inertia = 6e-5 * rated**1.6 * rng.lognormal(0.0, 0.3, MOTORS)
    names = tuple(f"M{k}" for k in range(MOTORS))
    motors = Motors(names, inertia, rated, 3.0 * rated, rng.uniform(200.0, 630.0, MOTORS), 2.0 * rated**0.8, rated)
    ratio = 1.0 / np.geomspace(1.0, 100.0, REDUCERS)
    names = tuple(f"R{k}" for k in range(REDUCERS))
    efficiency, own = rng.uniform(0.9, 0.98, REDUCERS), rng.lognormal(-10.0, 0.5, REDUCERS)
    return motors, Reducers(names, ratio, efficiency, own, np.array(630.0), np.array(np.inf), 1.0 / ratio, 1.0 / ratio)


def best_time(task: Callable[[], object]) -> float:
    """Shortest of a few runs, in seconds."""
    best = float("inf")
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        task()
        best = min(best, time.perf_counter() - begin)
    return best


def main() -> None:
    """Print the ratios."""
    task = Task.inertial(inertia=0.05, acceleration_rms=120.0, max_speed=30.0)
    motors, reducers = catalogues()
    one, other, out = np.full(MOTORS * REDUCERS, 1.5), np.full(MOTORS * REDUCERS, 2.5), np.empty(MOTORS * REDUCERS)
    unit = best_time(lambda: np.multiply(one, other, out=out))
    kept = len(rank(task, motors, reducers))
    table = Table("Step", "ms", "Ratio", title=f"{MOTORS * REDUCERS:,} pairs, {kept:,} usable / one multiplication")
    steps: dict[str, Callable[[], object]] = {"usable pairs": partial(usable, task, motors, reducers)}
    for criterion in ("margin", "inertia match", "size", "cost"):
        steps[f"best {SHORT_LIST} by {criterion}"] = partial(rank, task, motors, reducers, criterion, SHORT_LIST)
    steps["all ranked by margin"] = partial(rank, task, motors, reducers, "margin")
    for name, step in steps.items():
        seconds = best_time(step)
        table.add_row(name, f"{seconds * 1e3:.1f}", f"{seconds / unit:.1f}")
    console = Console()
    console.print(table)
    console.print(f"one multiplication of every pair: {unit * 1e3:.2f} ms")


if __name__ == "__main__":
    main()
