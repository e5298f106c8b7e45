"""The book of the hoist computes what its Python says, and work balances."""

import pytest
from hoist import SIGNS, TEMPLATE, torque

from workbook.api import build, read_machine, verify


def test_every_formula_agrees(tmp_path):
    book = tmp_path / "hoist.xlsx"
    build(read_machine(TEMPLATE.description), book)
    assert verify(book).findings == []


def test_the_motor_s_work_lifts_the_mass():
    """∫T dφ over a lift is m g h over the efficiency: the motor's own inertia gives back what it took."""
    hoist = read_machine(TEMPLATE.description)
    ramp = hoist.ramp * hoist.time
    speed = hoist.height / (hoist.time - ramp)
    # m: speeding up, level, slowing down
    ways = [speed * ramp / 2, speed * (hoist.time - 2 * ramp), speed * ramp / 2]
    turned = [way * 2000 / hoist.drum * hoist.ratio for way in ways]  # rad of the motor
    work = sum(torque(hoist, sign * speed / ramp) * phi for sign, phi in zip(SIGNS[::2], turned, strict=True))
    assert work == pytest.approx(hoist.mass * 9.81 * hoist.height / hoist.efficiency, rel=1e-12)
