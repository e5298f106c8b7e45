"""A machine of any axes: 1 to 24, their rests and shifts, other names, and what must not depend on samples."""

import math

import pytest
from pydantic import ValidationError

from tests.workbook.cells import computed, disagreeing, entered
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
SMALL = {"cycle": 12, "law": 4}
RATIO = 2 * math.pi / 0.01  # of a screw of 10 mm lead, rad/m
RISE = ((30, 90, 20.0, "CIC"), (180, 240, -20.0, "CIC"))


def described(axes=None, **sizes):
    """The committed machine, with other axes."""
    data = read_machine(TEMPLATE.description).model_dump()
    data["sizes"] |= SMALL | {"motion_pieces": None} | sizes
    others = {} if axes is None else {"axes": axes, "switches": [], "clearances": [], "power": {}, "selection": {}}
    return TEMPLATE.model.model_validate(data | others)


def small(axes, **sizes):
    """A machine with little room."""
    return described(axes, **{"phases": 2, "rotors": 2} | sizes)


def axis(number=1, *phases, **entries):
    told = [{"start": start, "stop": stop, "lift": lift, "law": law} for start, stop, lift, law in phases]
    return {"name": f"A{number}", "group": f"Group {number}", "phases": told} | entries


def many(count):
    """Axes alike in nothing: unit, rests, shift, laws."""
    laws = ("MTP", "CIC")
    return [
        axis(
            k,
            (3.0 * k, 3.0 * k + 40, 10.0 + k, "CIC"),
            (120.0 + k, 170.0 + 2 * k, -10.0 - k, laws[k % 2]),
            unit="°" if k % 3 == 0 else "mm",
            shift=17.0 * (k % 5),
        )
        for k in range(1, count + 1)
    ]


@pytest.mark.parametrize("count", [1, 5, 12, 24])
@pytest.mark.sample(2)
def test_machines_of_many_axes_agree_and_come_back(count):
    machine = described(many(count), phases=3)
    wrong, cells = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert cells > 4_000
    assert entered(TEMPLATE, machine) == (machine, [])


@pytest.mark.parametrize("count", [1, 3])
def test_laws_say_how_many_phases_have_them_and_which_axis_first(count):
    value = computed(TEMPLATE, small(many(count)))
    uses = zip(*(value("laws", name) for name in ("code", "phases", "first")), strict=True)
    has = {code: (phases, first) for code, phases, first in uses if phases}
    assert has == ({"CIC": (2, "A1")} if count == 1 else {"CIC": (5, "A1"), "MTP": (1, "A2")})


def test_more_axes_than_24_are_refused():
    with pytest.raises(ValueError, match="24"):
        described(many(25))


def test_a_shift_tells_the_motion_later_and_nothing_else():
    phases = ((30, 90, 20.0, "CIC"), (150, 240, -20.0, "MTP"))
    still, late = (described([axis(1, *phases, shift=shift)], cycle=24) for shift in (0.0, 45.0 - 720.0))
    one, other = computed(TEMPLATE, still), computed(TEMPLATE, late)
    y, moved = one("cycle1", "y"), other("cycle1", "y")
    assert moved == pytest.approx([*y[21:24], *y[:22]], abs=1e-12)  # 45° are three samples
    for column in ("v", "a", "travel", "low", "high"):
        assert one("axes", column) == other("axes", column)


def test_a_feed_goes_on_from_where_its_cycle_ends():
    value = computed(TEMPLATE, described([axis(1, (0, 120, 300.0, "CIC"), closes="feed", shift=-60.0)], cycle=12))
    y = value("cycle1", "y")
    assert (y[0], y[6], y[-1]) == pytest.approx((150.0, 300.0, 450.0))
    assert min(value("cycle1", "lane")) >= 0.0
    assert max(value("cycle1", "lane")) <= 0.94 + 1e-12


def test_axes_are_told_apart_whatever_the_case_of_their_names():
    with pytest.raises(ValueError, match="a second axis"):
        described([axis(1, (0, 90, 1.0, "CIC")), axis(1, (0, 90, 1.0, "CIC"), name="a1")])


# Drives


def driven(*phases, lead=10.0, **entries):
    """An axis on a screw without losses."""
    return axis(1, *phases) | {
        "mechanism": {"kind": "lead screw", "lead": lead, "efficiency": 1.0},
        "load": {"mass": 20.0},
        "motor": {"inertia": 10.0, "rated_torque": 60.0, "peak_torque": 450.0, "max_speed": 13000.0},
    } | entries  # fmt: skip


def test_cic_through_a_screw_at_200_a_minute():
    """2 mm in 5.5°, lead 10 mm: 5,236.36 rpm, 598.2 m/s²; T = (J_m i + m/i) a."""
    value = computed(TEMPLATE, described([driven((90.3, 95.8, 2.0, "CIC"), (180, 200, -2.0, "CIC"))]))
    ratio, hardest = 2 * math.pi / 0.01, 2 * math.pi * 0.002 / (0.3 * 5.5 / 360) ** 2
    assert value("drive1_speed") == pytest.approx(5236.3636363636, rel=1e-12)
    torque = (1e-3 * ratio + 20 / ratio) * hardest
    assert (value("drive1_tmax"), value("drive1_tmin")) == pytest.approx((torque, -torque), rel=1e-12)
    square = torque**2 / 2 * (5.5 + 20 * (5.5 / 20) ** 4) / 360  # of a full sine, ⟨sin²⟩ = 1/2
    assert value("drive1_rms") == pytest.approx(math.sqrt(square), rel=1e-12)


def test_no_result_hangs_on_the_samples():
    machine = read_machine(TEMPLATE.description).model_dump()["axes"]
    few, many_samples = (computed(TEMPLATE, described(machine, cycle=cycle)) for cycle in (12, 90))
    for i in (1, 2):
        for name in ("tmax", "tmin", "rms", "speed", "jtot", "res_rms"):
            assert few(f"drive{i}_{name}") == many_samples(f"drive{i}_{name}"), name


@pytest.mark.parametrize(
    "entries",
    [
        {"rate": 100.0}, {"load": {"mass": 3.0}},
        {"parts": [{"name": "Roll", "inertia": 10.0, "count": 1, "shaft": "motor"}]},
        {"reducer": {"ratio": 5.0}}, {"load": {"windows": [{"start": 10.0, "stop": 20.0, "force": 5.0}]}},
    ],
    ids=lambda entries: next(iter(entries)),
)  # fmt: skip
def test_what_belongs_to_a_drive_is_refused_without_one(entries):
    with pytest.raises(ValidationError, match="entered for an axis without a drive; expected none") as told:
        described([driven((0, 90, 2.0, "CIC")) | {"mechanism": None, "motor": None, "load": {}} | entries])
    assert told.value.errors()[0]["ctx"]["error"].field in entries
