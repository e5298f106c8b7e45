"""S3's composed motions as machines of one axis: exercise and examples in cells, junctions, closure, entries."""

import math
import subprocess

import openpyxl
import pytest

from tests.workbook.cells import computed
from tests.workbook.composed import EXERCISE, MACHINE, composed
from workbook.build import COMMITTED, DIGESTS, build, committed_descriptions, stale_templates
from workbook.reading.descriptions import read_machine, write_machine
from workbook.template import FOLDER
from workbook.writing.archive import book_digest

DESCRIPTION = FOLDER / "motion-composer.toml"
EXAMPLES = [FOLDER / f"motion-composer-example-{k}.toml" for k in (1, 2, 3)]
SMALL = {"cycle": 12, "law": 4}


def described(path=DESCRIPTION, **sizes):
    machine = read_machine(path)
    return machine.model_copy(update={"sizes": machine.sizes.model_copy(update=SMALL | sizes)})


def test_s3_exercise_carries_the_position_on():
    """0 → 20° cycloidal, the dwell stays up, modified trapezoidal back; S3's listing would drop to 0 after the rise."""
    value = computed(MACHINE, described())  # every 30°
    expected = [0, 0, 0, 10, 20, 20, 20, 10, 0, 0, 0, 0, 0]
    assert value("cycle1", "time") == pytest.approx([30.0 * k for k in range(13)], rel=1e-15)
    assert value("cycle1", "y") == pytest.approx(expected, abs=1e-12)
    assert value("axis1_taken", "gap")[:3] == pytest.approx([60.0, 60.0, 120.0], rel=1e-12)


def test_s3_exercise_peaks():
    value = computed(MACHINE, described())
    height = 8 * math.pi / (2 + math.pi) * 20 / 60**2
    assert value("axis1", "v")[:3] == pytest.approx([2 * 20 / 60, 2 * 20 / 60, 0], rel=1e-12)
    assert value("axis1", "a")[:3] == pytest.approx([2 * math.pi * 20 / 60**2, height, 0], rel=1e-12)
    assert (value("axes", "v"), value("axes", "a")) == (pytest.approx([2 / 3]), pytest.approx([math.pi / 90]))
    assert value("axes", "travel") == pytest.approx([0.0], abs=1e-15)
    assert value("overall") == "OK"


def test_dwells_told_as_phases_are_the_rests_between_them():
    """S3 tells five phases, two of which are dwells: so may an axis."""
    value, other = computed(MACHINE, composed(EXERCISE)), computed(MACHINE, described())
    assert value("axis1", "kind") == ["dwell", "rise", "dwell", "return", "dwell"]
    for column in ("y", "v", "a"):
        assert value("cycle1", column) == pytest.approx(other("cycle1", column), abs=1e-12)
    assert value("overall") == "OK"


def test_junctions_tell_the_jumps():
    """Constant acceleration 0 → 10 in 2, then −10 in 4: y'' falls from −10 to −2.5 at the top."""
    machine = composed((("ACS", 10.0, 2.0), ("ACS", -10.0, 4.0)), smoothness="velocity")
    value = computed(MACHINE, machine)
    steps, met = value("axis1_joints", "of"), value("axis1_joints", "met")
    pairs = [(steps[row - 1] if row else 0, step) for row, step in zip(met, value("axis1_pieces", "p"), strict=True)]
    joint, wrap = pairs.index((2, 4)), pairs.index((4, 2))  # steps: rests between them last nothing
    per = math.degrees(1.0) * value("omega") ** 2
    assert value("axis1_joints", "da")[joint] * per == pytest.approx(-2.5 + 10, rel=1e-12)
    assert value("axis1_joints", "da")[wrap] * per == pytest.approx(10 - 2.5, rel=1e-12)
    assert [value("axis1_joints", "dv")[k] for k in (joint, wrap)] == pytest.approx([0, 0], abs=1e-13)
    assert value("overall") == "OK"


@pytest.mark.parametrize(("closes", "verdict"), [("position", "FAIL"), ("open", "OK")])
def test_a_motion_that_does_not_come_back(closes, verdict):
    value = computed(MACHINE, composed((("CIC", 7.0, 2.0), ("CIC", -3.0, 4.0)), closes=closes))
    said = value("axis1_closes_says")
    assert said == ("it ends 4 ° from where it begins" if verdict == "FAIL" else said)
    assert value("axis1_joints", "order")[:2] == [0, 0]
    assert (value("axis1_closes"), value("axis1_position"), value("overall")) == (verdict, "OK", verdict)


def own(**piece_entries):
    laws = {"OWN": {"pieces": [{"duration": 1.0, **piece_entries}]}}
    return composed((("OWN", 5.0, 2.0), ("CIC", -5.0, 3.0)), laws, smoothness="velocity")


def test_a_law_that_does_not_end_at_rest_jumps_in_velocity():
    value = computed(MACHINE, own(c0=2.0))  # s = ξ², v = 2 at its end
    assert value("axis1_smooth_says") == "Axis at 2°: velocity jumps by 5 °/°"  # 2 · 5/2
    assert (value("axis1_smooth"), value("axis1_position")) == ("FAIL", "OK")


def test_a_law_that_does_not_reach_its_lift_jumps_in_position():
    value = computed(MACHINE, own(c0=1.0))  # s = ξ²/2
    assert value("axis1_position") == "FAIL"
    assert value("axis1_position_says") == "a lift lacks 2.5 °"
    assert value("axis1_taken", "lack")[0] == pytest.approx(math.radians(2.5))


def test_axis_titles_follow_the_units_entered(tmp_path):
    build(composed(over="s", unit="mm"), tmp_path / "time.xlsx")
    build(composed(over="mm"), tmp_path / "travel.xlsx")
    for name, expected in (
        ("time", {"Timing diagram", "time t [s]", "ẏ [m/s]", "ÿ [m/s²]", "j [m/s³]"}),
        ("travel", {"Timing diagram", "travel x [mm]", "y' [°/mm]", "y'' [°/mm²]", "y''' [°/mm³]"}),
    ):
        charts = openpyxl.load_workbook(tmp_path / f"{name}.xlsx")["Timing"]._charts
        ends = [axis.title for chart in charts for axis in (chart, chart.x_axis, chart.y_axis) if axis.title]
        titles = {"".join(run.t for part in title.tx.rich.p for run in part.r or []) for title in ends}
        assert titles == expected


def test_every_committed_description_has_its_digest_and_six_books_are_in_git():
    assert {DESCRIPTION, *EXAMPLES} <= set(committed_descriptions())
    lines = (FOLDER / DIGESTS).read_text(encoding="utf-8").splitlines()
    assert [line.split()[1] for line in lines] == [p.with_suffix(".xlsx").name for p in committed_descriptions()]
    listed = subprocess.run(["git", "ls-files", "*.xlsx"], cwd=FOLDER, capture_output=True, text=True, check=False)
    assert listed.returncode or set(listed.stdout.split()) == {
        f"{name}.xlsx" for name in (*COMMITTED, "motion-functions")
    }


def test_a_stale_example_is_found(tmp_path, monkeypatch):
    """Each committed description counts, not only the one that its template is named after."""
    monkeypatch.setattr("workbook.build.FOLDER", tmp_path)
    example = tmp_path / "other-name.toml"
    example.write_text(write_machine(described(EXAMPLES[1])), encoding="utf-8")
    book = example.with_suffix(".xlsx")
    assert stale_templates() == [book]
    build(read_machine(example), book)
    (tmp_path / DIGESTS).write_text(f"{book_digest(book)}  {book.name}\n", encoding="utf-8")
    assert stale_templates() == []
    build(described(), book, overwrite=True)
    assert stale_templates() == [book]
    book.unlink()  # as in git
    assert stale_templates() == []
    (tmp_path / DIGESTS).write_text(f"{'0' * 64}  {book.name}\n", encoding="utf-8")
    assert stale_templates() == [book]
