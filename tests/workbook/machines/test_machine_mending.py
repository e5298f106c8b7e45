"""What would mend a drive that breaks a limit stands behind the limit: the rate up to which all are held."""

import re

import pytest

from tests.mutation.bench import sized
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]


def at_rate(rate):
    machine = sized(TEMPLATE, cycle=12, law=4)
    master = machine.master.model_copy(update={"rate": rate})
    return machine.model_copy(update={"axes": machine.axes[1:2], "master": master, "clearances": [], "switches": []})


def failing(rate):
    book = TEMPLATE.declare(at_rate(rate))
    return {q.label: q.sentence for _, q in book.checks if q.value == "FAIL" and "Drive" in q.label}


@pytest.mark.parametrize(("rate", "bound"), [(240.0, 2e-3), (600.0, 1e-2)])
def test_a_limit_that_is_broken_tells_the_rate_at_which_all_hold(rate, bound):
    """Never more than the exact one, and at most 1 % less."""
    told = failing(rate)
    assert told
    rates = {float(re.search(r"; the drive holds from 0 to ([\d.]+) cycles/min$", said)[1]) for said in told.values()}
    (most,) = rates
    assert most < rate
    assert failing(most) == {}
    assert failing(most * (1 + bound))
