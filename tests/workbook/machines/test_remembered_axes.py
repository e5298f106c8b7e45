"""Axes that are remembered while one entry of their machine is another: as if each were worked out anew."""

import random
from contextlib import suppress

import pytest

from tests.mutation.bench import smaller
from tests.mutation.machines import machine as drawn_machine
from tests.tiers import seed
from workbook.book.rows import as_rows
from workbook.errors import InputError
from workbook.machines.machine.axes import drive_of, tables_of
from workbook.machines.machine.exact import judge_drive
from workbook.machines.machine.template import TEMPLATE
from workbook.reading.descriptions import make_machine, read_machine

OF_ALL = ("creep_forces", "gravity", "laws", "limits", "master", "selection")  # entries that all axes take


def told(machine):
    """Every value and formula of its book, and the judgement on it."""
    columns = [(block, q) for block in TEMPLATE.declare(machine).blocks.values() for q in block.quantities]
    return [(q.name, q.formula, as_rows(q.value, block.size, "")) for block, q in columns], TEMPLATE.judge(machine)


@pytest.mark.parametrize("edits", [4, pytest.param(30, marks=pytest.mark.nightly)])
def test_axes_are_remembered_as_they_are_worked_out(edits):
    drawn, machines = random.Random(seed(f"axes {edits}")), [smaller(read_machine(TEMPLATE.description))]
    while len(machines) <= edits:
        data, other = machines[-1].model_dump(), drawn_machine(machines[0], drawn).model_dump()
        axes = [*zip(data["axes"], other["axes"], strict=True)]
        entries, others = (data, other) if len(machines) % 2 else drawn.choice(axes)
        key = drawn.choice(OF_ALL if entries is data else [*entries])
        entries[key] = others[key]
        with suppress(InputError):
            made = make_machine(TEMPLATE, data, str)
            machines += [] if made.design.replaced or made == machines[-1] else [made]
    remembered = [told(machine) for machine in machines]
    assert all(memory.cache_info().hits for memory in (tables_of, drive_of, judge_drive))
    for machine, known in zip(machines, remembered, strict=True):
        tables_of.cache_clear()  # drives and judgements are remembered by tables
        assert told(machine) == known
