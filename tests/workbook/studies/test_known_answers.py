"""What is known of the best: a study finds it, and so does a search that knows nothing of studies."""

import numpy as np
import pytest

from engine.selection.front import front
from tests.workbook.studies.studied import base, laws, planned
from workbook.pool import THIS_PROCESS
from workbook.studies.folder import Parts
from workbook.studies.run import run

INERT = {"load": {}, "parts": [{"name": "Disc", "count": 1.0, "inertia": 10000.0, "shaft": "mechanism"}]}
FREE = {"*": "off"}
FAMILIES = ("ACS", "TVP", "CIC", "CUB", "MTP", "SHM", "PO5", "MSN", "SCC")


def best(tmp_path, *vary, **more):
    """The best design of a study of the feeding axis."""
    plan = planned(tmp_path, *vary, **more)
    parts = Parts(tmp_path / "r.csv", plan.digest, plan.space.size)
    with parts.opened(False, True):
        return run(plan, parts, THIS_PROCESS, lambda count, before: None)


def test_of_all_families_the_cubic_has_the_least_rms_torque_for_an_inertia(tmp_path):
    base(tmp_path, **INERT)
    found = best(tmp_path, laws(*FAMILIES), minimise=["drive1_rms"], constraints=FREE)
    ranked = [one.entries["axes.MC01.phases[1].law"] for one in found.best]
    assert ranked[0] == "CUB"
    rms = {one.entries["axes.MC01.phases[1].law"]: one.results["drive1_rms"] for one in found.best}
    assert rms["TVP"] ** 2 / rms["CUB"] ** 2 == pytest.approx(13.5 / 12.0, rel=1e-12)  # thirds, as delivered


def test_of_the_trapezoids_the_thirds_have_the_least_rms_torque(tmp_path):
    base(tmp_path, **INERT)
    rise = {"key": "laws.TVP.rise_end", "values": [0.2, 0.25, 0.3, 1 / 3, 0.36, 0.4, 0.45]}
    fall = {"key": "laws.TVP.fall_start", "values": [0.55, 0.6, 0.64, 2 / 3, 0.7, 0.75, 0.8]}
    found = best(tmp_path, laws("TVP"), rise, fall, minimise=["drive1_rms"], constraints=FREE)
    assert list(found.best[0].entries.values()) == ["TVP", 1 / 3, 2 / 3]
    assert found.designs == 49


def test_smoothness_asked_changes_the_winner_as_brute_force_finds_too(tmp_path):
    base(tmp_path, smoothness="acceleration", **INERT)
    asked = {"minimise": ["drive1_rms"], "constraints": FREE | {"axis1_smooth": "OK"}}
    found = best(tmp_path, laws(*FAMILIES), **asked)
    plan = planned(tmp_path, laws(*FAMILIES), **asked)
    (law,) = plan.space.dimensions
    kept = {}
    for name in FAMILIES:
        machine = plan.machine({law: name})
        book = plan.template.declare(machine)
        if book.blocks["axis1_smooth"].quantities[0].value == "OK":
            kept[name] = book.blocks["drive1_rms"].quantities[0].value
    winner = min(kept, key=kept.get)
    assert found.best[0].entries["axes.MC01.phases[1].law"] == winner != "CUB"
    assert found.best[0].results["drive1_rms"] == pytest.approx(kept[winner], rel=1e-12)


def test_the_best_ratio_is_the_one_of_s5(tmp_path):
    base(tmp_path, reducer={"ratio": 5.0}, **INERT)
    inertia = 0.02  # of the motor; of a pure inertia J_L the best ratio is √(J_L/J_M), S5 step 4
    way = {"kind": "evolution", "designs": 600, "seed": 3}
    found = best(
        tmp_path, {"key": "axes.MC01.reducer.ratio", "from": 1.0, "to": 60.0}, way=way, minimise=["drive1_rms"]
    )
    assert found.best[0].entries["axes.MC01.reducer.ratio"] == pytest.approx((1.0 / inertia) ** 0.5, rel=1e-3)


def test_the_front_is_what_comparing_each_with_each_leaves():
    rng = np.random.default_rng(4)
    for columns in (1, 2, 3, 4):
        points = rng.integers(0, 12, (300, columns)).astype(float)
        beaten = [
            any((other <= one).all() and (other < one).any() for other in points) or (points[:k] == one).all(1).any()
            for k, one in enumerate(points)
        ]
        assert sorted(front(points).tolist()) == np.flatnonzero(~np.array(beaten)).tolist()
        assert front(points[:0]).tolist() == []
