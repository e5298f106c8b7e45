"""SEW MOVI-C: cam points as text, a count and then pairs."""

import numpy as np

from workbook.controllers.table import CENTRAL, LOCAL, Table
from workbook.controllers.target import Handed, Target
from workbook.controllers.text import numbers, written


def write(handed: Handed) -> str:
    """Return the count, and x and y of each point; the format has no comment."""
    table = handed.table
    return f"{len(table.x)}\r\n" + written((table.x, table.y), handed.separator, handed.decimal)


TARGETS = (
    Target(
        "sew", "SEW MOVI-C, cam points as text, cubic", ".txt", ("x", "y"), (LOCAL, CENTRAL),
        write, lambda text: Table(*np.array(numbers(text, (2,))).T),
        points=(2, 1024), spacing="equal", signs=("separator", "decimal"),
    ),
)  # fmt: skip
