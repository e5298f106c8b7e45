"""Random catalogues and choices of motor and reducer, for the templates that have a sheet Selection."""

import random
from typing import Any

from engine.selection.pair_matrix import RANKS


def vary_selection(selection: dict[str, Any], sizes: dict[str, Any], drawn: random.Random) -> None:
    """Draw the catalogues, the rank and the pair anew; ``sizes`` says how many rows there are."""
    motors = [motor(i, drawn) for i in range(drawn.randint(1, sizes["motors"]))]
    reducers = [reducer(i, drawn) for i in range(drawn.randint(1, sizes["reducers"]))]
    if drawn.random() < 0.3:
        motors[-1] = motors[0] | {"name": "again"}  # equals in the ranking
    selection |= {
        "rank": drawn.choice(RANKS),
        "greatest_margin": 10 ** drawn.uniform(0.5, 3),
        "efficiency": drawn.choice((1.0, drawn.uniform(0.5, 1))),
        "motors": motors,
        "reducers": reducers,
        "motor": drawn.choice((None, drawn.choice(motors)["name"])),
        "reducer": drawn.choice((None, drawn.choice(reducers)["name"])),
    }


def motor(i: int, drawn: random.Random) -> dict[str, Any]:
    """Return a motor, small or large, with or without a curve, a mass, a cost."""
    rated, top = 10 ** drawn.uniform(-2, 5), drawn.uniform(300, 9000)
    made = {
        "name": f"motor {i}",
        "inertia": rated ** drawn.uniform(0.9, 1.4) * 10 ** drawn.uniform(-1, 1),
        "rated_torque": rated,
        "peak_torque": rated * drawn.uniform(1, 5),
        "max_speed": top,
        "mass": maybe(drawn, drawn.uniform(0.1, 90)),
        "cost": maybe(drawn, drawn.uniform(50, 9000)),
        "copper_losses": maybe(drawn, rated * drawn.uniform(0, 0.02)),
        "stall_torque": maybe(drawn, rated * drawn.uniform(0.9, 3)),
        "rated_speed": maybe(drawn, top * drawn.uniform(0.2, 1.2)),
    }
    if drawn.random() < 0.4:
        made |= {"full_torque_to": drawn.uniform(0, 0.95) * top, "end_torque": rated * drawn.uniform(0, 2)}
    return made


def reducer(i: int, drawn: random.Random) -> dict[str, Any]:
    """Return a reducer, with or without an inertia, limits, a mass, a cost."""
    return {
        "name": f"reducer {i}",
        "reduction": 10 ** drawn.uniform(-0.3, 2),
        "efficiency": drawn.uniform(0.4, 1),
        "inertia": maybe(drawn, 10 ** drawn.uniform(-2, 3)),
        "max_speed": maybe(drawn, drawn.uniform(500, 9000)),
        "max_torque": maybe(drawn, 10 ** drawn.uniform(0, 5)),
        "mass": maybe(drawn, drawn.uniform(0.1, 90)),
        "cost": maybe(drawn, drawn.uniform(50, 9000)),
        "full_cycles": maybe(drawn, 10 ** drawn.uniform(1, 5)),
        "cycle_factor": maybe(drawn, drawn.uniform(1, 3)),
        "no_load_torque": maybe(drawn, 10 ** drawn.uniform(-3, 1)),
    }


def maybe(drawn: random.Random, value: float) -> float | None:
    """Return a figure, or none."""
    return None if drawn.random() < 0.25 else value
