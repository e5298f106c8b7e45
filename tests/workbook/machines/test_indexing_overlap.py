"""The book of S2's indexing mill and die: the document's figures in its cells, every cell as the engine says."""

import pytest

from engine.laws.inverse import HEIGHT, inverse
from tests.laws import MOVING
from tests.workbook.cells import computed
from workbook.law_sheets.library import RISING, laws
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["indexing-overlap"]
SMALL = {"cycle": 24, "law": 8, "margins": 5}


def entries(**changed):
    """The committed description with small tables; ``tool__dwell=3`` changes an entry of the overlap."""
    data = read_machine(TEMPLATE.description).model_dump()
    data["sizes"] |= SMALL
    data["laws"]["OWN"]["pieces"] = RISING
    for name, value in changed.items():
        part, _, entry = name.rpartition("__")
        place(data["overlap"], part)[entry] = value
    return data


def place(overlap, part):
    """Where the entries of a part stand, by its name: of the first tool, unless a number follows (``passage2``)."""
    name, number = part.rstrip("0123456789"), part.lstrip("abcdefghijklmnopqrstuvwxyz")
    if name in ("tool", "passage"):
        tool = overlap["tools"][int(number or 1) - 1]
        return tool["passage"] if name == "passage" else tool
    return overlap[name] if name else overlap


def described(**changed):
    return TEMPLATE.model.model_validate(entries(**changed))


def test_s2_at_its_rounded_angle():
    """S2: 0.625 s, 0.804 m/s² and 5.17 times lower at 125°; rounding up costs 0.1 mm of the margin."""
    value = computed(TEMPLATE, described(tool__angle_in=125.0, tool__angle_out=125.0))
    assert value("tool1_schedules", "t_in")[2] == pytest.approx(0.625, abs=1e-12)
    assert value("tool1_a1") == pytest.approx(0.804248, abs=5e-7)
    assert value("tool1_ratio") == pytest.approx(5.17, abs=5e-3)
    assert value("tool1_ratio") == pytest.approx(5.1653, abs=5e-5)
    assert 0.8 < value("tool1_least") < 1.0
    assert (value("tool1_ok_collide"), value("tool1_ok_margin"), value("overall")) == ("OK", "FAIL", "FAIL")


def test_parts_that_collide_fail_the_book():
    value = computed(TEMPLATE, described(tool__angle_in=160.0, tool__angle_out=95.0, view=134.0))
    assert value("tool1_least") < 0
    assert value("tool1_ok_collide") == value("overall") == "FAIL"
    assert value("stands", "says") == ["COLLISION"]


@pytest.mark.parametrize("law", MOVING)
def test_any_law_is_inverted_to_the_bound_that_its_sheet_states(law):
    machine = described(transfer__law=law, tool__law_in=law, tool__law_out=law)
    value, engine = computed(TEMPLATE, machine), laws(machine.laws)[law]
    residuals = []
    for name in ("inverse_transfer", "tool1_inverse_in", "tool1_inverse_out"):
        s, xi = (value(name, column) for column in ("wanted", "xi"))
        assert xi == pytest.approx([inverse(engine, x) for x in s], abs=1e-4)
        assert [engine.s(x) for x in xi] == pytest.approx(s, abs=HEIGHT)
        residuals += [abs(engine.s(x) - wanted) for x, wanted in zip(xi, s, strict=True)]
    assert value("inverse_residual") == pytest.approx(max(residuals), abs=1e-13)
    assert value("inverse_ok") == "OK"


def test_half_of_the_stroke_at_half_of_the_time_decides_no_point_by_rounding():
    """The cubic law is at s = 1/2 just on a point, where its pieces meet."""
    machine = described(tool__law_in="CUB", tool__law_out="CUB", passage__clearance=25.0, passage__margin=0.0)
    value = computed(TEMPLATE, machine)
    assert value("tool1_inverse_in", "wanted")[0] == 0.5
    assert value("tool1_inverse_in", "xi")[0] == pytest.approx(0.5, abs=1e-12)


def test_the_picture_moves_with_the_angle():
    value = computed(TEMPLATE, described(view=60.0))
    other = computed(TEMPLATE, described(view=220.0))
    for column in ("x", "y"):
        assert len(value("outline", column)) == 12
    assert value("outline", "x") != other("outline", "x")
    assert min(value("tool1_punch", "yb")) == pytest.approx(50, abs=1e-12)
    assert min(other("tool1_punch", "yb")) == min(other("tool1_punch", "ya")) == pytest.approx(0, abs=1e-9)
