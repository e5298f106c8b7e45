"""Random machines of any axes."""

import random
from typing import Any, get_args

from tests.laws import MOVING
from tests.mutation.machines import shares, vary_laws
from workbook.motion.asked import Smoothness
from workbook.motion.room import within


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    sizes = data["sizes"]
    vary_laws(data["laws"], drawn, sizes["pieces"])
    data["master"]["rate"] = drawn.uniform(5, 600)
    for axis in data["axes"]:
        made = phases(drawn, sizes["phases"])
        axis.update(
            closes=drawn.choice(("feed", "position")), smoothness=drawn.choice(get_args(Smoothness)),
            shift=drawn.choice((0.0, float(drawn.randint(-720, 720)), drawn.uniform(-400, 400))),
            phases=within(made, data["laws"], sizes["motion_pieces"] - len(made) - 1),
        )  # fmt: skip
    return data


def phases(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return phases in order, with and without rests between them."""
    made: list[dict[str, Any]] = []
    count = drawn.randint(1, room)
    widths = shares(drawn, count + count + 1)
    reached = 0.0
    for rest, width in zip(widths[::2], widths[1::2], strict=False):
        start = reached + (rest * 360 if drawn.random() < 0.5 else 0.0)
        reached = start + width * 360
        law = drawn.choice((*MOVING, "DWL"))
        lift = 0.0 if law == "DWL" else drawn.choice((0.0, drawn.uniform(-200, 200), drawn.uniform(-200, 200)))
        made.append({"start": start, "stop": reached, "lift": lift, "law": law})
    if drawn.random() < 0.3:
        made[-1]["stop"] = 360.0
    return made
