"""Every mechanism is whole: what its recipe asks for is there, and its cells agree with the engine.

A failing test has the mechanism's name in brackets; what it says names the place (docs/recipes/mechanism.md).
"""

import contextlib
import re
from pathlib import Path

import pytest
from pydantic import ValidationError

from engine.drive import KINDS
from tests.engine.drive import machines
from tests.workbook.cells import disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from tests.workbook.machines.test_machine_drives import some_mechanism
from workbook.build import build
from workbook.fields.units import MM
from workbook.judging.verify import verify
from workbook.machines.machine.drive.driven import changing_ratio
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive.reach import size_fault
from workbook.machines.machine.mechanism import LINKED, MECHANISMS, Belted

EVERY = [*dict.fromkeys([*KINDS, *MECHANISMS, *LINKAGES])]
FAR = 5.0  # m: no axis goes so far
MOTOR = {"inertia": 1.0, "rated_torque": 1.0, "peak_torque": 1.0, "max_speed": 1.0}
GUIDE = Path(__file__).parents[3] / "docs/workbooks.md"
MODELS = "in workbook/machines/machine/mechanism.py"


def missing(kind):
    """The places that do not have a mechanism, or have it otherwise than the engine."""
    if kind not in KINDS:
        return ["a Kind of its name in KINDS, in engine/drive/mechanisms/__init__.py"]
    if kind not in MECHANISMS:
        return [f"its model in the union Mechanism, {MODELS}"]
    model, constant = MECHANISMS[kind], KINDS[kind].turns
    there = {
        f"SIZE, the entry that sets its ratio, {MODELS}": bool(model.SIZE) == bool(constant),
        f"UNITS, of the axes that it moves, {MODELS}":
            kind in LINKED or kind in LINKAGES or ("°" in model.UNITS) == (constant is None),
        f"Belted, what its model derives from, {MODELS}": issubclass(model, Belted) == KINDS[kind].belt,
        f"LARGE, sizes that reach anywhere, {MODELS}": kind in LINKED or kind not in LINKAGES,
        "its page in LINKAGES, in workbook/machines/machine/drive/mechanisms/__init__.py":
            kind in LINKAGES or kind not in LINKED,
        "the engine's tests: SIZES or LINKAGES in tests/engine/drive/machines.py":
            kind in machines.SIZES or kind in machines.LINKAGES or model.SLIDES,
        "its name in docs/workbooks.md": re.search(rf"\b{kind}s?\b", " ".join(GUIDE.read_text("utf-8").split())),
    }  # fmt: skip
    return [place for place, right in there.items() if not right]


@pytest.mark.parametrize("kind", EVERY)
def test_every_place_has_the_mechanism(kind):
    assert missing(kind) == []


@pytest.mark.parametrize("kind", LINKED)
def test_with_its_large_sizes_it_reaches_wherever_an_axis_goes(kind):
    low, high, *_ = changing_ratio(some_mechanism(kind), MM).reach
    assert low < -FAR < FAR < high, f"LARGE, {MODELS}"


@pytest.mark.parametrize("kind", LINKED)
def test_without_sizes_it_is_unfinished(kind):
    with contextlib.suppress(ValidationError):
        MECHANISMS[kind].model_validate({"kind": kind, "efficiency": 1.0})
        pytest.fail(f"made without a size: NEEDED, {MODELS}")


@pytest.mark.parametrize("kind", LINKED)
def test_each_variation_has_other_sizes_that_reach_its_positions(kind):
    made = [LINKAGES[kind].varied(0, k, 6) for k in range(6)]
    assert len({str(sizes) for sizes, *_ in made}) == 6
    for sizes, low, high in made:
        given = MECHANISMS[kind].model_validate({"kind": kind, "efficiency": 1.0} | sizes)
        assert size_fault(given, "mm") == ""
        linkage = changing_ratio(given, MM)
        assert [y for y in (low, 0.0, high) if linkage.beyond(y / 1000)] == []


@pytest.mark.parametrize("kind", MECHANISMS)
def test_its_cells_agree_with_the_engine_and_its_entries_come_back(kind, tmp_path):
    """Where they do not, verify tells the causes first."""
    phases = (10.0, 150.0, 30.0, "CIC"), (200.0, 340.0, -30.0, "CIC")
    told = {"unit": MECHANISMS[kind].UNITS[0], "mechanism": some_mechanism(kind).model_dump(), "motor": MOTOR}
    large = described([axis(1, *phases, **told)], phases=2, rotors=2)
    other = TEMPLATE.variants(large)[1]
    if disagreeing(TEMPLATE, other)[0]:
        build(other, tmp_path / "book.xlsx")
        first = verify(tmp_path / "book.xlsx").findings[0]
        pytest.fail(f"{first.sheet}!{first.cell}, {first.what}: {first.computed}, not {first.expected}")
    assert entered(TEMPLATE, large) == (large, [])
