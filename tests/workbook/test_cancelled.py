"""A difference that little is left of is measured against what it is of: its rounding is no disagreement."""

import math
import re

import pytest

from tests.tiers import by_day
from tests.workbook.composed import DESCRIBED, committed_as
from workbook.book.rows import as_rows

NAME = re.compile(r"[a-z][a-z_0-9]*_\w+")
SUM = re.compile(rf"=-?{NAME.pattern}(?:[+-]{NAME.pattern})*-{NAME.pattern}(?:[+-]{NAME.pattern})*")
ROUNDING, TOLERANCE = 2.0**-52, 1e-9


def greatest(values):
    """The greatest size of the finite numbers among the values, or 0."""
    return max((abs(v) for v in values if isinstance(v, int | float) and abs(v) < math.inf), default=0.0)


def unsure(book):
    """The differences of named cells that rounding alone may bring beyond the tolerance, with their formulas."""
    quantities = [(q, block.size) for block in book.blocks.values() for q in block.quantities if block.size == 1]
    sizes = {q.name: greatest(as_rows(q.value, size, q.name)) for q, size in quantities if q.value is not None}
    found = []
    for q, _ in quantities:
        if isinstance(q.formula, str) and SUM.fullmatch(q.formula):
            terms = max(sizes.get(name, 0.0) for name in NAME.findall(q.formula))
            if TOLERANCE * max(sizes[q.name], q.floor) < ROUNDING * terms:
                found.append((q.name, q.formula))
    return found


@pytest.mark.parametrize("name", by_day(DESCRIBED, "machine"))
def test_what_a_difference_leaves_is_measured_against_its_terms(name):
    template, machine = committed_as(name)
    for varied in (machine, *template.variants(machine)):
        assert unsure(template.declare(varied)) == []
