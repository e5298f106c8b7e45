"""What would make a machine faster: gains against a machine built with them, drawn machines, the file written."""

import math
import re
from itertools import chain, islice, pairwise, permutations

import pytest
from openpyxl import load_workbook

from engine.drive.limits import at_speed
from engine.drive.rate_range import rate_range
from engine.laws import PieceLaw
from tests.tiers import nights, seed
from tests.workbook.evaluated import by_formulon
from tests.workbook.machines.drawn_drives import drawn_machine
from tests.workbook.studies.studied import base
from workbook.book.quantity import OK
from workbook.build import read_entered, write_book
from workbook.commands import improve as command
from workbook.description.editing import edit_text
from workbook.errors import AGREES, FAILS, InputError, WriteError
from workbook.fields.paths import table
from workbook.fields.units import PER_MINUTE, si
from workbook.judging.verify import verify
from workbook.laws.entries import references
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.exact import drives_of, limits_of
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.studies import changes, shaping, timing
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import read_machine
from workbook.studies import improve_sheet
from workbook.studies.design import RATE, first_design
from workbook.studies.improve import STAGES, better, obstacles, single_gains
from workbook.studies.plan import changed_machine
from workbook.templates import TEMPLATES

RATE_AIM = ("rate", 0.0, 0.0)
CUTTING = TEMPLATES["machine"].description.with_name("cutting-machine.toml")


def silent(count, total, words):
    """Progress that nobody looks at."""


def at_rate(design, rate):
    """The machine of a design at a rate (cycles/min)."""
    return changed_machine(design.base, dict(design.data), {**design.changes, RATE: rate})


@pytest.fixture(scope="module")
def cutting():
    return first_design(read_machine(CUTTING))


def test_the_limits_of_the_cutting_machine_come_in_their_order(cutting) -> None:
    told = obstacles(cutting)
    assert [limit.limit.limit for limit in told] == ["RMS torque", "motor speed", "torque below the curve"]
    assert told[0].limit.rate * 60.0 == pytest.approx(112.079, abs=1e-3)
    assert told[0].where == "phase 1, 98 % of it"
    assert all(before.limit.rate <= after.limit.rate for before, after in pairwise(told))


def test_each_gain_is_that_of_the_exact_engine_with_the_machine_changed(cutting) -> None:
    gains = list(single_gains(cutting, THIS_PROCESS, silent))
    tried = {change.words: change for change in cutting.tries("MC01")}
    assert any("shaped" in gain.words for gain in gains)
    for gain in gains[:3]:
        machine = changed_machine(cutting.base, dict(cutting.data), tried[gain.words].entries)
        (view,) = drives_of(machine)
        assert 1.0 / gain.after == pytest.approx(rate_range(view.driven.limit_checks).high / math.tau, rel=1e-5)


@pytest.mark.parametrize(
    ("slope", "friction", "count"), [(90.0, 0.2, 2), (-30.0, 0.0, 2), (30.0, 0.2, 1), (0.0, 0.2, 0)]
)
def test_a_weight_is_held_by_a_spring_and_by_a_counterweight_that_moves_too(slope, friction, count, tmp_path) -> None:
    load = {"mass": 40.0, "slope": slope, "friction": friction, "force": 10.0}
    machine = read_machine(base(tmp_path, load=load))
    held = [*changes.balanced(machine, 0)]
    assert len(held) == count
    weight, share = 40.0 * machine.gravity * math.sin(math.radians(slope)), 1.0 + abs(math.sin(math.radians(slope)))
    for change, moved in zip(held, (1.0, share), strict=False):
        other = changed_machine(machine, table(machine), change.entries)
        then, now = (shaping.drives(each)["MC01"]().train for each in (machine, other))
        assert now.force(0.0, ()).level == pytest.approx(10.0)
        assert then.force(0.0, ()).level == pytest.approx(10.0 + weight)
        assert other.axes[0].load.mass == pytest.approx(40.0 * moved)


def test_an_edge_keeps_the_order_of_all_edges_and_stays_within_10_degrees() -> None:
    machine = read_machine(TEMPLATES["machine"].description)
    before = [place for axis in machine.axes for place in timing.places_of(axis)]
    moved = [change for i in range(len(machine.axes)) for change in changes.edge_changes(machine, i)]
    assert len(moved) > 4
    for change in moved:
        other = changed_machine(machine, table(machine), change.entries)
        after = [place for axis in other.axes for place in timing.places_of(axis)]
        for (was, now), (first, then) in permutations(zip(before, after, strict=True), 2):
            assert was >= first or now <= then + 1e-6, change.words
        assert 0.0 < max(abs(now - was) for was, now in zip(before, after, strict=True)) <= 10.0 + 1e-9


NUMBERS = [*((k, "faster") for k in range(7)), (198, "1, faster")]  # the last reached far above the rate of its points


@pytest.mark.parametrize(("number", "drawn_from"), NUMBERS)
@pytest.mark.sample(3)
def test_a_drawn_machine_is_never_slower_and_holds_its_limits_at_its_rate(number: int, drawn_from: str) -> None:
    try:
        design = first_design(drawn_machine(number, drawn_from))
    except InputError:
        return  # no drive limits it
    best = design
    for other in islice(better(design, ("law",), THIS_PROCESS, silent), 1 if drawn_from == "faster" else 3):
        assert other.rate >= best.rate
        best = other
    assert best.breaks() <= design.breaks()
    rate = best.rate_to_write
    if not rate:
        return
    for view in drives_of(at_rate(best, rate)):
        if view.driven.entered.rate is None:
            assert [limit.line for limit in limits_of(view) if not limit.ok] == []
        else:
            speed = si(rate, PER_MINUTE) * math.tau
            assert at_speed(view.driven.limit_checks, speed).worst.use <= 1.0 + 1e-9


SMALL = {"cycle": 4, "law": 4, "export": 1, "points": 8, "rotors": 2}


def apart(machine):
    """A small machine whose first two axes, if there are, keep nine tenths of the least gap of their motions."""
    named = {*machine.laws.of("LIN"), *(reference.name for reference in references(machine))}
    data = table(machine) | {"laws": {name: law for name, law in machine.laws.root.items() if name in named}}
    data["sizes"] = SMALL | {
        "phases": max(2, *(len(axis.phases) for axis in machine.axes)),
        "positions": machine.sizes.positions,
    }
    if len(machine.axes) > 1:
        pair = {"name": "Gap", "first": machine.axes[0].name, "second": machine.axes[1].name}
        wide = TEMPLATES["machine"].model.model_validate(data | {"clearances": [pair | {"least": -1e4}]})
        gap = ClearanceView(wide.clearances[0], 1, axes_of(wide)).exact
        data["clearances"] = [pair | {"least": gap - 0.1 * abs(gap)}]
    return TEMPLATES["machine"].model.model_validate(data)


def failing(machine):
    """The checks that fail, by sheet or exact engine."""
    template = TEMPLATES["machine"]
    book, exact = template.declare(machine), template.judge(machine)
    return {q.name for _, q in book.checks if exact.judge(q.name, q.value, "")[0] != OK}


@pytest.mark.parametrize("number", nights(100))
def test_a_drawn_machine_improved_is_never_worse_and_its_book_verifies(number: int, tmp_path) -> None:
    """Laws and edges, clearances kept; the book is built at the rate that would be written, and verified."""
    try:
        design = first_design(apart(drawn_machine(number, seed("improved"))))
    except InputError:
        return  # no drive limits it
    best = design
    for other in islice(better(design, ("law", "edge"), THIS_PROCESS, silent), 3):
        assert other.rate >= best.rate
        assert other.exact_cost <= best.exact_cost
        best = other
    before, rate = design.rate_to_write, best.rate_to_write
    if not before or not rate:
        return
    assert rate >= before
    machine = at_rate(best, rate)
    assert failing(machine) <= failing(at_rate(design, before))
    write_book(machine, tmp_path / "faster.xlsx")
    assert [str(finding) for finding in verify(tmp_path / "faster.xlsx").findings] == []


def test_what_is_written_keeps_comments_and_is_the_best_design(tmp_path) -> None:
    text = base(tmp_path).read_text("utf-8").replace("[master]", "# a remark\n[master]")
    path, faster = tmp_path / "feed.toml", tmp_path / "faster.toml"
    path.write_text(text, encoding="utf-8")
    assert command.improve(path, faster, "laws", RATE_AIM, "", (None, None), False) == AGREES
    assert "# a remark" in faster.read_text("utf-8")
    before, after = (first_design(read_machine(file)) for file in (path, faster))
    assert after.rate > before.rate * 1.01
    assert after.machine.per_minute == pytest.approx(after.rate_to_write, abs=0.02)
    untouched = [line for line in text.splitlines() if not re.search(r"\b(rate|law) = ", line)]
    assert set(untouched) <= set(faster.read_text("utf-8").splitlines())


def test_each_stage_is_better_than_what_it_begins_with_and_keeps_the_order_of_edges(cutting) -> None:
    best = {"": cutting}
    for name, (_, kinds, begin) in STAGES.items():
        best[name] = best[begin]
        for other in better(best[begin], kinds, THIS_PROCESS, silent):
            assert other.rate > best[name].rate
            best[name] = other
    assert best["both"].rate > max(best["laws"].rate, best["timing"].rate) * 1.05
    for name in ("timing", "both"):
        assert best[name].machine.axes[0].phases[0].stop == best[name].machine.axes[0].phases[1].start == 90.0
        assert best[name].breaks() <= cutting.breaks()


def test_interrupted_it_keeps_the_best_so_far(cutting, monkeypatch, capsys) -> None:
    kept = next(better(cutting, ("law",), THIS_PROCESS, silent))

    def interrupted(*_):
        yield kept
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "better", interrupted)
    monkeypatch.setattr(command, "single_gains", lambda *_: iter(()))
    assert command.show_gains(cutting, "laws", THIS_PROCESS, silent, []) is kept
    assert "best so far" in capsys.readouterr().err


def test_where_nothing_is_better_no_file_is_written_and_that_is_said(tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.setattr(command, "show_gains", lambda design, *_: design)
    assert (
        command.improve(base(tmp_path), tmp_path / "faster.toml", "laws", RATE_AIM, "", (None, None), False) == AGREES
    )
    assert not (tmp_path / "faster.toml").exists()
    assert "is not written" in capsys.readouterr().err.replace("\n", " ")


def test_a_book_has_what_was_printed_and_tells_entries_that_changed_since(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(command, "show_gains", lambda design, *_: design)
    path, book = base(tmp_path), tmp_path / "feed.xlsx"

    def improve(force: bool) -> int:
        return command.improve(path, None, "laws", RATE_AIM, "", (None, None), force, book)

    assert improve(False) == AGREES
    with pytest.raises(WriteError, match="exists"):
        improve(False)
    written = load_workbook(book)
    sheet = written["Improve"]
    assert sheet["A6"].value.startswith("Highest rate: 205.1 cycles/min")
    (row,) = (cell.row for cell in sheet["A"] if cell.value == "master.rate")
    entry = sheet.cell(row, 3).value.removeprefix("=Timing!")
    valued = load_workbook(book, data_only=True)  # of formulas elsewhere the values that the book has
    for cell in chain(*sheet.iter_rows()):
        valued["Improve"][cell.coordinate] = cell.value
    for rate, says, mark in ((60, improve_sheet.SAME, ""), (61, improve_sheet.OTHER, improve_sheet.CHANGED)):
        valued["Timing"][entry.replace("$", "")] = rate
        values = by_formulon(valued)
        assert (values["Improve", 4, 1], values["Improve", row, 3]) == (says, rate)
        assert values["Improve", row, 4] == mark
    written.create_sheet("Mine")["A1"] = "kept"
    written.save(book)
    assert improve(True) == AGREES
    assert load_workbook(book)["Mine"]["A1"].value == "kept"
    sheet["A1"] = "an engineer's own"
    written.save(book)
    with pytest.raises(WriteError, match="'Improve' is your own"):
        improve(True)


def shaped_feed(tmp_path, of: str = 'shaped = "torque"', **changes):
    """The description of a feed whose law is to be shaped."""
    path = base(tmp_path, **changes)
    text = re.sub(r'law = "[^"]*"', 'law = "OPT"', path.read_text("utf-8"), count=1)
    path.write_text(f"{text}\n[laws.OPT]  # a remark\n{of}\n", encoding="utf-8")
    return path


@pytest.mark.parametrize("aim", ["torque", "rate"])
def test_a_law_is_frozen_and_fits_until_the_drive_changes(aim: str, tmp_path, capsys) -> None:
    path, frozen = shaped_feed(tmp_path, f'shaped = "{aim}"'), tmp_path / "frozen.toml"
    assert command.freeze(path, None, False) == FAILS
    assert "→ shaped for its drive, " in capsys.readouterr().out
    assert command.freeze(path, frozen, False) == AGREES
    assert "[laws.OPT]  # a remark" in frozen.read_text("utf-8")
    before, after = (first_design(read_machine(file)) for file in (path, frozen))
    assert after.rate > before.rate or aim == "torque"
    assert after.machine.laws["OPT"].shaped == aim
    assert after.machine.master == before.machine.master
    assert command.freeze(frozen, None, False) == AGREES
    assert "still fits" in capsys.readouterr().out
    text = re.sub(r"(?m)^efficiency = .*", "efficiency = 0.6", frozen.read_text("utf-8"))
    frozen.write_text(text, encoding="utf-8")
    assert command.freeze(frozen, None, False) == FAILS


def test_a_law_is_shaped_with_no_more_jerk_than_its_bound(tmp_path, capsys) -> None:
    path, frozen = shaped_feed(tmp_path, 'shaped = "torque"\nmax_jerk = 70.0'), tmp_path / "frozen.toml"
    assert command.freeze(path, frozen, False) == AGREES
    law = read_machine(frozen).laws["OPT"]
    assert 69.0 < PieceLaw([piece.engine_piece for piece in law.pieces]).coefficients.cj <= 70.0
    assert law.max_jerk == 70.0
    command.show_fit(first_design(read_machine(frozen)), lines := [])
    assert [line.partition(", ")[2] for line in lines] == ["still fits"]


def test_a_book_keeps_what_its_law_is_shaped_for(tmp_path) -> None:
    path = shaped_feed(tmp_path, 'shaped = "torque"\nmax_jerk = 70.0')
    write_book(machine := read_machine(path), tmp_path / "feed.xlsx")
    _, read, _ = read_entered(tmp_path / "feed.xlsx")
    assert read.laws["OPT"] == machine.laws["OPT"]
    text = path.read_text("utf-8").replace("[laws.OWN]", '[laws.OWN]\nshaped = "rate"')
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"laws.OWN.shaped: every book has this law"):
        read_machine(path)


@pytest.mark.parametrize(
    ("of", "smoothness", "match"),
    [
        ("", "velocity", "no law is shaped"),
        ('[laws.X]\nfamily = "opt"\nshaped = "rate"', "velocity", r"laws.X.shaped: 0 phases"),
        ('shaped = "torque"', "jerk", r"laws.OPT.shaped: degree"),
        ('shaped = "torque"\nmax_jerk = 10.0', "velocity", r"laws.OPT.shaped: jerk is 10; no law"),
        ("max_jerk = 20.0", "velocity", r"laws.OPT.max_jerk: bounds laws that are shaped"),
    ],
)
def test_a_law_that_cannot_be_shaped_says_why(of: str, smoothness: str, match: str, tmp_path) -> None:
    path = shaped_feed(tmp_path, of, smoothness=smoothness)
    path.write_text(re.sub("(?m)^pieces = .*", "pieces = 2", path.read_text("utf-8")), encoding="utf-8")
    with pytest.raises(InputError, match=match):
        command.freeze(path, None, False)


RAMP, LINE = {"start": 0.0, "stop": 90.0, "lift": 60.0}, {"start": 90.0, "stop": 150.0, "lift": 90.0, "law": "LIN"}
PASSING = {"start": 90.0, "stop": 270.0, "lift": 90.0, "velocity": 0.05, "acceleration": 0.02}
OTHER = {"start": 150.0, "stop": 270.0, "lift": 100.0}


@pytest.mark.parametrize(
    "phases",
    [
        [RAMP | {"law": "OPT"}, LINE, OTHER | {"law": "OUT"}],
        [RAMP | {"law": "OPT"}, PASSING | {"law": "OUT"}],
        [RAMP | {"law": "OPT"}, PASSING | {"law": "PO5"}],
    ],
)
def test_laws_between_velocities_are_frozen_verify_and_follow_moved_edges(phases, tmp_path, capsys) -> None:
    path, frozen, book = base(tmp_path, phases=phases), tmp_path / "frozen.toml", tmp_path / "feed.xlsx"
    own = [name for name in ("OPT", "OUT") if name in [phase["law"] for phase in phases]]
    laws = "".join(f'[laws.{name}]\nfamily = "OPT"\nshaped = "torque"\n' for name in own)
    path.write_text(f'{path.read_text("utf-8")}\n[laws.LIN]\nfamily = "LIN"\n{laws}', encoding="utf-8")
    assert command.freeze(path, None, False) == FAILS
    assert capsys.readouterr().out.count("which meets its neighbours now") == len(own)
    assert command.freeze(path, frozen, False) == AGREES  # and so do all checks
    assert command.freeze(frozen, None, False) == AGREES
    machine = read_machine(frozen)
    write_book(machine, book)
    assert [str(finding) for finding in verify(book).findings] == []
    assert read_entered(book)[1].laws == machine.laws
    design = first_design(machine)
    assert design.breaks() == set()
    for change in changes.edge_changes(machine, 0):
        moved = design.changed(change)
        assert moved.breaks() == set(), change.words
        assert not [*shaping.misfits(moved.machine)]


def test_axes_that_limit_alike_have_better_laws_both(tmp_path) -> None:
    machine = read_machine(base(tmp_path))
    twin = machine.axes[0].model_copy(update={"name": "MC02"})
    design = first_design(machine.model_copy(update={"axes": [machine.axes[0], twin]}))
    best = list(better(design, ("law",), THIS_PROCESS, silent))[-1]
    assert best.rate > design.rate * 1.01
    laws = {path[1]: law for path, law in best.changes.items() if path[-1] == "law"}
    assert laws.keys() == {"0", "1"}
    assert all(law.startswith(f"Shaped {int(i) + 1}-1") for i, law in laws.items() if "Shaped" in law)


def test_a_drive_that_holds_at_no_rate_says_so(tmp_path) -> None:
    machine = read_machine(base(tmp_path))
    weak = machine.axes[0].motor.model_copy(update={"rated_torque": 0.01, "peak_torque": 0.02})
    axes = [machine.axes[0].model_copy(update={"motor": weak})]
    with pytest.raises(InputError, match="MC01: its drive holds its limits at no rate"):
        first_design(machine.model_copy(update={"axes": axes}))


def test_a_machine_without_drives_says_so() -> None:
    machine = read_machine(TEMPLATES["motion-laws"].description)
    with pytest.raises(InputError, match="expected machine"):
        first_design(machine)
    axes = [axis.model_copy(update={"motor": None, "mechanism": None}) for axis in read_machine(CUTTING).axes[1:]]
    with pytest.raises(InputError, match="no drive of this machine limits its rate"):
        first_design(read_machine(CUTTING).model_copy(update={"axes": axes}))


def test_a_law_that_nothing_takes_any_more_is_not_written(cutting) -> None:
    first, second = ({("laws", name): {"family": "PO5"}, ("axes", "0", "phases", "0", "law"): name} for name in "AB")
    one = cutting.changed(changes.Change("", first, "law"))
    two = one.changed(changes.Change("", second, "law"))
    text = edit_text(CUTTING.read_text("utf-8"), two.changes.items())
    assert "[laws.B]" in text
    assert "[laws.A]" not in text
