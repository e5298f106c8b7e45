"""SEW MOVI-C: cam points as text, a count and then pairs."""

import numpy as np

from workbook.controllers.table import CENTRAL, LOCAL, Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.text import numbers, written

MANUAL = "SEW help 27800520, page 31491133835"


def write(handed: Handed) -> str:
    """Return the count, and x and y of each point; the format has no comment."""
    table = handed.table
    return f"{len(table.x)}\r\n" + written((table.x, table.y), handed.separator, handed.decimal)


TARGETS = (
    Target(
        "sew", "SEW MOVI-C, cam points as text, cubic", ".txt", ("x", "y"), (LOCAL, CENTRAL),
        write, lambda text: Table(*np.array(numbers(text, (2,))).T), (
            Claim("a count, then x and y a line, semicolon (newer manual: tab), point or comma", "documented", MANUAL),
            Claim("up to 1024 points for linear and cubic, 64 for a spline", "documented", MANUAL),
            Claim("cubic: the velocity is continuous, the acceleration jumps at points", "documented",
                  "SEW help 57491440523"),
            Claim("the slope that a cubic has at a point: by its neighbours; at equal steps all such rules agree "
                  "inside", "untested", "no document says it"),
        ),
        points=(2, 1024), spacing="equal", signs=("separator", "decimal"),
    ),
)  # fmt: skip
