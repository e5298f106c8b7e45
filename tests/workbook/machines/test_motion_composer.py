"""The composed motion's book: S3's exercise and examples in its cells, junctions, closure, units, entries."""

import math
import random

import openpyxl
import pytest

from tests.laws import MOVING, told
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_random_inputs import durations, piece, shares
from workbook.build import build, committed, inputs, stale_templates
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine, write_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["motion-composer"]
FOLDER = TEMPLATE.description.parent
EXAMPLES = [FOLDER / f"motion-composer-example-{k}.toml" for k in (1, 2)]
SMALL = {"cycle": 12, "law": 4, "own_law": 4}


def described(path=TEMPLATE.description, **sizes):
    machine = read_machine(path)
    return machine.model_copy(update={"sizes": machine.sizes.model_copy(update=SMALL | sizes)})


def with_motion(machine, **entries):
    data = machine.model_dump()
    data["motion"].update(entries)
    return TEMPLATE.model.model_validate(data)


def phase(law, lift, duration):
    return {"law": law, "lift": lift, "duration": duration}


def test_s3_exercise_carries_the_position_on():
    """0 → 20° cycloidal, the dwell stays up, modified trapezoidal back; S3's listing would drop to 0 after the rise."""
    value = computed(TEMPLATE, described())  # every 30°
    expected = [0, 0, 0, 10, 20, 20, 20, 10, 0, 0, 0, 0, 0]
    assert value("motion", "at") == pytest.approx([30.0 * k for k in range(13)], rel=1e-15)
    assert value("motion", "y") == pytest.approx(expected, abs=1e-12)


def test_s3_exercise_peaks():
    value = computed(TEMPLATE, described())
    height = 8 * math.pi / (2 + math.pi) * 20 / 60**2
    assert value("phases", "v")[:5] == pytest.approx([0, 2 * 20 / 60, 0, 2 * 20 / 60, 0], rel=1e-12)
    assert value("phases", "a")[:5] == pytest.approx([0, 2 * math.pi * 20 / 60**2, 0, height, 0], rel=1e-12)
    assert (value("move_v"), value("move_a")) == pytest.approx((2 / 3, math.pi / 90), rel=1e-12)
    assert value("move_gap") == pytest.approx(0, abs=1e-15)
    assert value("overall") == "OK"


def test_s3_complex_example():
    """{Dwell CIC Dwell CIC Dwell}, lifts 0 20 0 −20 0, durations 60 45 75 90 90."""
    value = computed(TEMPLATE, described(EXAMPLES[0], cycle=24))  # every 15°
    at = dict(zip(value("motion", "at"), zip(value("motion", "y"), value("motion", "y1"), strict=True), strict=True))
    assert at[75.0] == pytest.approx((20 * (1 / 3 - math.sin(2 * math.pi / 3) / 2 / math.pi), 20 / 45 * 1.5), rel=1e-12)
    assert at[135.0] == pytest.approx((20, 0), abs=1e-12)
    assert at[225.0] == pytest.approx((10, -2 * 20 / 90), rel=1e-12)
    assert at[315.0] == pytest.approx((0, 0), abs=1e-12)


def test_s3_simple_example():
    """{TVP}, h = π over 360: e_v = 1/3, c_v = 3/2, c_a = 9/2."""
    value = computed(TEMPLATE, described(EXAMPLES[1], cycle=6))
    expected = [0, 1 / 16, 1 / 4, 1 / 2, 3 / 4, 15 / 16, 1]
    assert value("motion", "y") == pytest.approx([s * math.pi for s in expected], abs=1e-12)
    assert value("move_v") == pytest.approx(1.5 * math.pi / 360, rel=1e-13)
    assert value("move_a") == pytest.approx(4.5 * math.pi / 360**2, rel=1e-13)
    assert value("move_ok_closes") == "OK"


@pytest.mark.parametrize("path", EXAMPLES, ids=["complex", "simple"])
def test_examples_have_s3_thousand_samples(path):
    machine = read_machine(path)
    assert TEMPLATE.declare(machine).blocks["motion"].size == 1000


def test_every_formula_cell_has_an_engine_value():
    cells = list(TEMPLATE.declare(described(cycle=360)).cells())
    formulas = [c for c in cells if isinstance(c.content, str) and c.content.startswith("=")]
    assert not [f"{c.block.name}.{c.quantity.name}[{c.i}]" for c in formulas if c.expected is None]
    assert len([c for c in formulas if c.block.name == "motion"]) == 361 * 8


# --- Junctions and closure ------------------------------------------------------------------------


def test_junctions_report_the_jumps():
    """Constant acceleration 0 → 10 in 2, then −10 in 4: y'' falls from −10 to −2.5 at the top."""
    phases = [phase("ACS", 10.0, 2.0), phase("ACS", -10.0, 4.0)]
    value = computed(TEMPLATE, with_motion(described(), smoothness="velocity", phases=phases))
    assert value("junctions", "kind")[:3] == ["joint", "wrap", "spare"]
    assert value("junctions", "x")[:2] == [2.0, 6.0]
    assert value("junctions", "jump_a")[:3] == pytest.approx([-2.5 + 10, 10 - 2.5, 0], rel=1e-13)
    assert value("junctions", "jump_v")[:3] == pytest.approx([0, 0, 0], abs=1e-13)
    assert value("move_jump") == pytest.approx(7.5)
    assert value("overall") == "OK"


@pytest.mark.parametrize(("cycle", "verdict"), [("closes", "FAIL"), ("open", "OK")])
def test_a_motion_that_does_not_come_back(cycle, verdict):
    value = computed(
        TEMPLATE, with_motion(described(), cycle=cycle, phases=[phase("CIC", 7.0, 2.0), phase("CIC", -3.0, 4.0)])
    )
    assert value("move_gap") == pytest.approx(4.0)
    assert value("junctions", "jump_y")[1] == pytest.approx(4.0 if cycle == "closes" else 0.0)
    assert (value("move_ok_closes"), value("move_ok_position"), value("overall")) == (verdict, "OK", verdict)


def own(**piece_entries):
    data = described().model_dump()
    data["laws"]["OWN"]["pieces"] = [{"duration": 1.0, **piece_entries}]
    data["motion"]["phases"] = [phase("OWN", 5.0, 2.0), phase("CIC", -5.0, 3.0)]
    return TEMPLATE.model.model_validate(data)


def test_a_law_that_does_not_end_at_rest_jumps_in_velocity():
    value = computed(TEMPLATE, own(c0=2.0))  # s = ξ², v = 2 at its end
    assert value("junctions", "jump_v")[0] == pytest.approx(-2 * 5 / 2)
    assert (value("move_ok_velocity"), value("move_ok_position")) == ("FAIL", "OK")


def test_a_law_that_does_not_reach_its_lift_jumps_in_position():
    value = computed(TEMPLATE, own(c0=1.0))  # s = ξ²/2
    assert value("junctions", "jump_y")[0] == pytest.approx(2.5)
    assert value("move_ok_position") == "FAIL"


def test_the_motion_begins_where_it_is_told_to():
    value = computed(TEMPLATE, with_motion(described(), position=-3.5))
    assert value("motion", "y")[0] == pytest.approx(-3.5)
    assert value("move_high") == pytest.approx(16.5)


# --- Units, sizes, entries ------------------------------------------------------------------------


def test_axis_titles_follow_the_units_entered(tmp_path):
    machine = with_motion(described(), abscissa_unit="s", lift_unit="mm")
    value = computed(TEMPLATE, machine)
    names = [value(f"move_title_{q}") for q in "xyva"]
    assert names == ["x [s]", "y [mm]", "y' [mm/s]", "y'' [mm/s²]"]
    build(machine, tmp_path / "book.xlsx")
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    titles = {chart.y_axis.title.tx.strRef.f for chart in book["Motion"]._charts}
    cells = {book.defined_names[f"move_title_{q}"].attr_text for q in "yva"}
    assert {t.replace("'", "") for t in titles} == {c.replace("'", "") for c in cells}


def test_twenty_four_phases_fit_and_twenty_five_do_not():
    data = described().model_dump()
    data["sizes"]["motion_pieces"] = None
    data["motion"]["phases"] = [phase("CIC", 10.0 * (-1) ** i, 15.0) for i in range(24)]
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(data))
    assert (value("move_count"), value("move_total")) == (24, 360.0)
    data["motion"]["phases"].append(phase("CIC", 1.0, 1.0))
    with pytest.raises(ValueError, match="at most 24"):
        TEMPLATE.model.model_validate(data)


@pytest.mark.parametrize(
    ("column", "entry", "said"),
    [
        ("law", "Sine", "expected one of DWL, ACS"),
        ("duration", "long", "expected a number"),
    ],
)
def test_a_wrong_entry_names_the_cell(column, entry, said, tmp_path):
    path = tmp_path / "book.xlsx"
    build(described(), path)
    book = openpyxl.load_workbook(path)
    block = TEMPLATE.declare(described()).blocks["phases"]
    cell = book["Motion"].cell(block.row + 2, block.columns[column])  # the third phase, a dwell
    cell.value = entry
    book.save(path)
    with pytest.raises(InputError) as raised:
        inputs(path)
    assert f"Motion!{cell.coordinate}" in str(raised.value)
    assert said in str(raised.value)


# --- Against the engine ---------------------------------------------------------------------------


@pytest.mark.parametrize("law", MOVING)
def test_pycel_agrees_with_each_law(law):
    phases = [phase(law, 20.0, 40.0), phase("DWL", 0.0, 15.0), phase(law, -20.0, 65.0)]
    assert disagreeing(TEMPLATE, with_motion(described(cycle=48), phases=phases))[0] == []


def test_every_check_of_the_motion_that_can_fail_does_so_in_some_variant():
    verdicts = {}
    for machine in TEMPLATE.variants(described()):
        for _, q in TEMPLATE.declare(machine).checks:
            verdicts.setdefault(q.name, set()).add(q.value)
    for name in ("move_ok_position", "move_ok_velocity", "move_ok_closes"):
        assert verdicts[name] == {"OK", "FAIL"}, name


@pytest.mark.parametrize("seed", range(25))
def test_random_motions_agree_with_the_engine(seed):
    assert disagreeing(TEMPLATE, drawn(random.Random(seed)))[0] == []


def drawn(dice):
    """A motion of any length in any units, its durations over four decades."""
    data = described(cycle=dice.choice((7, 24)), motion_pieces=120).model_dump()
    data["laws"]["MTP"]["durations"] = durations(dice)
    data["laws"]["OWN"]["pieces"] = told(lambda: [piece(dice, d) for d in shares(dice, dice.randint(1, 4))])
    low, high = sorted(dice.uniform(0.02, 0.98) for _ in range(2))
    data["laws"]["TVP"].update(rise_end=low, fall_start=high)
    size = 10 ** dice.uniform(-4, 3)
    phases = []
    for _ in range(dice.choice((1, 2, 5, 24))):
        law = dice.choice(("DWL", *MOVING))
        lift = 0.0 if law == "DWL" else dice.choice((0.0, dice.uniform(-size, size), dice.uniform(-size, size)))
        phases.append(phase(law, lift, 10 ** dice.uniform(-2, 2)))
    cycle = dice.choice(("closes", "open"))
    data["motion"].update(position=dice.uniform(-size, size), cycle=cycle, phases=phases)
    return TEMPLATE.model.model_validate(data)


# --- The committed files --------------------------------------------------------------------------


def test_every_committed_description_has_its_book():
    assert {TEMPLATE.description, *EXAMPLES} <= set(committed())
    assert [p.name for p in committed() if not p.with_suffix(".xlsx").exists()] == []


def test_a_stale_example_is_found(tmp_path, monkeypatch):
    """Each committed description counts, not only the one that its template is named after."""
    monkeypatch.setattr("workbook.build.FOLDER", tmp_path)
    example = tmp_path / "other-name.toml"
    example.write_text(write_machine(described(EXAMPLES[1])), encoding="utf-8")
    assert stale_templates() == [example.with_suffix(".xlsx")]
    build(read_machine(example), example.with_suffix(".xlsx"))
    assert stale_templates() == []
    build(described(), example.with_suffix(".xlsx"), overwrite=True)
    assert stale_templates() == [example.with_suffix(".xlsx")]


@pytest.mark.parametrize("path", [TEMPLATE.description, *EXAMPLES], ids=lambda p: p.stem)
def test_the_committed_books_verify(path):
    assert verify(path.with_suffix(".xlsx")).findings == []
