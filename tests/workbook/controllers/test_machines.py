"""Random machines to every target: what is read back lies within the certificate's bound of the closed forms."""

import random

import numpy as np
import pytest

from tests import tiers
from tests.mutation.machines import machine as drawn_machine
from tests.workbook.machines.test_machine import axis, described
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.tabulation import certify_table, fewest_points, reread, rules_of, tabulate
from workbook.controllers.target import CamExport
from workbook.errors import TargetError
from workbook.fields.units import DEGREE, shown, si
from workbook.law_sheets.library import laws
from workbook.machines.machine.view import moving_axes
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
PLACES = 400
APART = 1e-4  # degrees: beside a break, of which numbers of 32 bits hold the place to 3e-5
REFUSED = (
    "no y is above 0",
    "the breaks of the motion need",
    "beyond what",
    "expected the master to rise",
    "expected 2",
)


def random_machine(seed):
    """A machine of two axes, mm and °, with shifts of any size, laws of any family, rests told and not told."""
    given = described(
        [axis(1, (10, 60, 20.0, "CIC")), axis(2, (10, 60, 20.0, "CIC"), unit="°")], phases=3, motion_pieces=60
    )
    return drawn_machine(given, random.Random(seed))


def whole(machine):
    return moving_axes(machine, laws(machine.laws))


def closed(one, x):
    """Position, velocity and acceleration by the closed forms, at angles of the master shaft, in the units entered."""
    at, y, rad = one.at(si(x, DEGREE)), shown(1.0, one.unit), shown(1.0, DEGREE)
    return at.y * y, at.y1 * y / rad, at.y2 * y / rad**2


def written(to, cam, n):
    """An axis as a target's table and text, or the line that refuses it."""
    try:
        made = certify_table(to, tabulate(to, cam, n), cam.profile)
        return made, to.write(CamExport(made.table, "demo", ("x in °;",), (cam.x_unit, cam.y_unit), cam.repeats))
    except TargetError as error:
        return None, str(error)


def within_its_bound(one, cam, name, draw):
    """Write an axis, read it back, rebuild it: its distance from the closed forms is no more than is certified."""
    to = target(name)
    n = to.counts[0] if to.counts else min(to.points[1], max(to.points[0], 2 * fewest_points(to, cam.profile)))
    made, text = written(to, cam, n)
    if made is None:
        assert any(word in text for word in REFUSED), text
        return False
    back = certify_table(to, reread(to, text, made.table), cam.profile)
    edges = np.concatenate([cam.profile.edges, back.table.x])
    x = draw.uniform(0.01, 359.99, PLACES)
    x = x[np.min(np.abs(x[:, None] - edges[None, :]), axis=1) > APART]
    meant = closed(one, x)
    for rule, certificate in zip(rules_of(to, back.table).values(), back.certificates.values(), strict=True):
        rebuilt = rule.rebuild(back.table).at(x)
        for order, values in enumerate(meant):
            bound = certificate.deviations[order]
            allowed = bound.largest * (1 + 1e-9) + 1e-9 * max(bound.peak, np.abs(values).max())
            assert np.abs(rebuilt[order] - values).max(initial=0.0) <= allowed, (name, order)
    return True


@pytest.mark.parametrize(
    ("seed", "names"),
    [
        (1, ("codesys", "siemens-segments", "br")),
        (2, ("rockwell", "mitsubishi", "sew")),
        *(pytest.param(tiers.seed(k), TARGETS, marks=pytest.mark.nightly, id=f"night {k}") for k in range(12)),
    ],
)
def test_what_is_read_back_lies_within_the_certificates_bound(seed, names):
    machine, draw = random_machine(seed), np.random.default_rng(random.Random(seed).randrange(2**32))
    for one, cam in zip(whole(machine), TEMPLATE.axes(machine), strict=True):
        done = [within_its_bound(one, cam, name, draw) for name in names]
        assert any(done)


@pytest.mark.parametrize("seed", ["0, 29", "0, 38", 1, 2])  # the first two end with an own law that misses 1
def test_a_cam_is_the_motion_as_late_as_entered(seed):
    machine, x = random_machine(seed), np.linspace(0.3, 359.7, PLACES)
    for one, cam in zip(whole(machine), TEMPLATE.axes(machine), strict=True):
        size = np.ptp(cam.profile.at(cam.profile.edges).y)
        np.testing.assert_allclose(cam.profile.at(x).y, closed(one, x)[0], rtol=0, atol=1e-9 * size)
