"""Other catalogues and choices at which ``verify`` evaluates a Selection sheet.

They have every rank, proposed and named pairs, missing figures, missing limits, and no usable pair at all.
"""

from typing import Any

CHOICES: tuple[dict[str, Any], ...] = (
    {"rank": "margin", "greatest_margin": 50.0, "efficiency": 1.0},
    {"rank": "inertia match", "efficiency": 0.9},
    {"rank": "mass", "efficiency": 0.97},
    {"rank": "cost", "greatest_margin": 9.0, "efficiency": 0.85},
    {"rank": "inertia match", "efficiency": 0.95},
    {"rank": "smallest motor", "efficiency": 0.93},
)
WEAK = 4  # the variation whose motors can do nothing


def vary_selection(data: dict[str, Any], k: int, sizes: dict[str, Any]) -> None:
    """Put other catalogues and choices into a description's selection; ``sizes`` has the numbers of rows."""
    data |= CHOICES[k]
    for entry, make, few in (("motor", motor, 4 + k % 5), ("reducer", reducer, 4 + (k + 1) % 5)):
        room = sizes[f"{entry}s"]
        rows = [make(i, k) for i in range(room if k == 0 else min(room, few))]
        data |= {f"{entry}s": rows, entry: rows[(2 * k + 1) % len(rows)]["name"] if k % 4 == 1 else None}


def motor(i: int, k: int) -> dict[str, Any]:
    """Return a motor: the larger the later, every third with a curve, some without a mass or a cost."""
    strength = 1e-6 if k == WEAK else 1.0
    rated = strength * (20.0 + 3 * k) * 1.9**i
    top = 3000.0 + 170 * i + 29 * k
    curve = {"full_torque_to": top * (0.3 + 0.05 * k), "end_torque": rated * 1.1} if (i + k) % 3 == 0 else {}
    return {
        "name": f"motor {k}-{i + 1}",
        "inertia": (0.0006 + 0.0001 * k) * 3.1**i,
        "rated_torque": rated,
        "peak_torque": rated * (2.2 + 0.1 * i),
        "max_speed": top,
        "source": "a variation" if i % 2 else None,
        "shaft": 9.0 + 3 * i if (i + k) % 4 else None,
        "mass": 3.0 + 2.5 * i + 0.1 * k if i % 4 != 3 else None,
        "cost": 400.0 + 90 * i if k == 3 and i % 3 != 2 else None,
        "copper_losses": None if i % 3 else 0.01 * rated,
        "stall_torque": rated * (0.9 + 0.3 * (i % 4)) if (i + k) % 5 else None,
        "rated_speed": top * 0.35 * (i % 3) or None,
    } | curve


def reducer(i: int, k: int) -> dict[str, Any]:
    """Return a reducer: every third without an inertia, some without a limit, a mass or a cost."""
    return {
        "name": f"reducer {k}-{i + 1}",
        "reduction": (1.5 + 0.2 * k) * 1.45**i,
        "efficiency": 0.98 - 0.01 * ((i + k) % 5),
        "inertia": None if (i + k) % 3 == 2 else 0.0002 * (1 + i) + 0.00003 * k,
        "no_load_torque": 0.02 * i if (i + k) % 3 else None,
        "max_speed": None if (i + k) % 4 == 1 else 2500.0 + 400 * ((i + k) % 3),
        "full_cycles": (None, 60.0, 1e9)[(i + k) % 3],
        "cycle_factor": None if (i + k) % 4 == 3 else 1.0 + 0.3 * (i % 4),
        "max_torque": None if (i + k) % 4 == 2 else 150.0 * 2.5 ** ((i + 2 * k) % 5),
        "hub": 14.0 + 2 * i if (i + k) % 3 else None,
        "mass": 1.5 + 0.7 * i if (i + k) % 5 != 4 else None,
        "cost": 200.0 + 35 * i if k == 3 else None,
        "source": None,
    }
