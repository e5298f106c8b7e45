"""What it costs to judge and rank a million motor–reducer pairs, as a ratio to one multiplication of each pair."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

import numpy as np
from rich.console import Console
from rich.table import Table

from engine.choice import Motors, Reducers, Task, rank, usable

MOTORS = REDUCERS = 1000
ROUNDS = 25
SHORT_LIST = 100
UNIT = "one multiplication"


def catalogues() -> tuple[Motors, Reducers]:
    """Made-up catalogues with the spread of real ones: J_M grows with T_N to the power 1.6."""
    rng = np.random.default_rng(1)
    rated = np.geomspace(0.1, 100.0, MOTORS)
    inertia = 6e-5 * rated**1.6 * rng.lognormal(0.0, 0.3, MOTORS)
    names = tuple(f"M{k}" for k in range(MOTORS))
    motors = Motors(names, inertia, rated, 3.0 * rated, rng.uniform(200.0, 630.0, MOTORS), 2.0 * rated**0.8, rated)
    reduction = np.geomspace(1.0, 100.0, REDUCERS)
    names = tuple(f"R{k}" for k in range(REDUCERS))
    efficiency, own = rng.uniform(0.9, 0.98, REDUCERS), rng.lognormal(-10.0, 0.5, REDUCERS)
    return motors, Reducers(names, reduction, efficiency, own, np.array(630.0), np.array(np.inf), reduction, reduction)


def best_times(tasks: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Shortest of a few runs of each task, in seconds; the rounds take turns."""
    best = dict.fromkeys(tasks, float("inf"))
    for _ in range(ROUNDS):
        for name, task in tasks.items():
            begin = time.perf_counter()
            task()
            best[name] = min(best[name], time.perf_counter() - begin)
    return best


def main() -> None:
    """Print the ratios."""
    task = Task(acceleration_rms=120.0, torque_rms=6.0, power_rate_mean=720.0, max_speed=30.0)  # 0.05 kg m², inert
    motors, reducers = catalogues()
    one, other, out = np.full(MOTORS * REDUCERS, 1.5), np.full(MOTORS * REDUCERS, 2.5), np.empty(MOTORS * REDUCERS)
    steps: dict[str, Callable[[], object]] = {UNIT: lambda: np.multiply(one, other, out=out)}
    steps["usable pairs"] = partial(usable, task, motors, reducers)
    for criterion in ("margin", "inertia match", "size", "cost"):
        steps[f"best {SHORT_LIST} by {criterion}"] = partial(rank, task, motors, reducers, criterion, SHORT_LIST)
    steps["all ranked by margin"] = partial(rank, task, motors, reducers, "margin")
    seconds = best_times(steps)
    kept = len(rank(task, motors, reducers))
    table = Table("Step", "ms", "Ratio", title=f"{MOTORS * REDUCERS:,} pairs, of which {kept:,} are usable")
    for name, spent in seconds.items():
        table.add_row(name, f"{spent * 1e3:.2f}", f"{spent / seconds[UNIT]:.1f}")
    Console().print(table)


if __name__ == "__main__":
    main()
