"""Random composed motions: of any length, in any units, over several decades."""

import random
from typing import Any, get_args

from tests.laws import MOVING
from tests.mutation.machines import vary_laws
from workbook.motion.asked import Smoothness
from workbook.motion.room import within


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes = data["sizes"]
    vary_laws(data["laws"], drawn, sizes["pieces"])
    size = 10 ** drawn.uniform(-2, 3)
    count = drawn.choice((1, 2, 5, sizes["phases"]))
    data["motion"].update(
        abscissa_unit=drawn.choice(("s", "°", "mm")), lift_unit=drawn.choice(("mm", "°")),
        position=drawn.choice((0.0, drawn.uniform(-size, size))), cycle=drawn.choice(("closes", "open")),
        smoothness=drawn.choice(get_args(Smoothness)),
        phases=[phase(drawn, size) for _ in range(count)],
    )  # fmt: skip
    if drawn.random() < 0.3:
        return_home(data["motion"]["phases"])
    within(data["motion"]["phases"], data["laws"], sizes["motion_pieces"])
    return data


def phase(drawn: random.Random, size: float) -> dict[str, Any]:
    """Return a phase of any law, at times without a lift."""
    law = drawn.choice((*MOVING, "DWL"))
    lift = 0.0 if law == "DWL" else drawn.choice((0.0, drawn.uniform(-size, size), drawn.uniform(-size, size)))
    return {"law": law, "lift": lift, "duration": 10 ** drawn.uniform(-1, 2)}


def return_home(phases: list[dict[str, Any]]) -> None:
    """Let the last phase that moves bring the motion back to where it began, as nearly as rounding lets it."""
    for last in reversed(phases):
        if last["law"] not in ("DWL", "OWN"):
            last["lift"] -= sum(p["lift"] for p in phases)
            return
