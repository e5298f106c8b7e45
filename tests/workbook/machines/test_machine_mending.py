"""What would mend a drive that breaks a limit stands behind the limit: the rate up to which all are held."""

import re

import pytest

from tests.mutation.bench import sized
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]


def failing(rate, longer=1.0):
    """Return what fails of a drive whose axis moves twice, over 45° each, or so many times as long."""
    machine = sized(TEMPLATE, cycle=12, law=4)
    master, (axis,) = machine.master.model_copy(update={"rate": rate}), machine.axes[1:2]
    begins = zip(axis.phases, (90.0, 220.0), strict=True)
    phases = [phase.model_copy(update={"start": x, "stop": x + 45.0 * longer}) for phase, x in begins]
    axes = [axis.model_copy(update={"phases": phases})]
    pieces = machine.sizes.motion_pieces[1:2]  # those of the first axis are fewer
    sizes = machine.sizes.model_copy(update={"motion_pieces": pieces})
    alone = {"axes": axes, "master": master, "clearances": [], "switches": [], "sizes": sizes}
    small = machine.model_copy(update=alone)
    return {q.label: q.sentence for _, q in TEMPLATE.declare(small).checks if q.value == "FAIL" and "Drive" in q.label}


@pytest.mark.parametrize(("rate", "bound"), [(240.0, 2e-3), (600.0, 1e-2)])
def test_a_limit_that_is_broken_tells_the_rate_at_which_all_hold(rate, bound):
    """Never more than the exact one, and at most 1 % less."""
    limit = re.compile(r"; the drive holds from 0 to ([\d.]+) cycles/min(?:, or with moves|$)")
    (most,) = {float(limit.search(said)[1]) for said in failing(rate).values()}
    assert most < rate
    assert failing(most) == {}
    assert failing(most * (1 + bound))


@pytest.mark.parametrize("rate", [240.0, 260.0])
def test_a_limit_that_is_broken_tells_how_long_moves_hold_it(rate):
    (degrees,) = {float(re.search(r"moves of about (\d+)° in all$", said)[1]) for said in failing(rate).values()}
    assert 90 < degrees < 120
    assert failing(rate, 1.01 * degrees / 90.0) == {}
    assert failing(rate, 0.97 * degrees / 90.0)
