"""What moves leave in a load that swings behind its axis: printed figures, cells, the exact engine, and odd loads."""

import math
import re

import numpy as np
import pytest

from engine.laws import law
from engine.laws.vibration import Shaper
from tests.engine.laws.test_vibration import residual
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.build import build, read_entered, read_inputs
from workbook.commands.improve import freeze
from workbook.controllers.registry import target
from workbook.controllers.tabulation import automatic
from workbook.errors import AGREES, FAILS, InputError
from workbook.improving import AIMS
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.entries_beside import UNTUNED, Vibration
from workbook.machines.machine.exact import judgement
from workbook.machines.machine.studies.results import results
from workbook.machines.machine.vibration import MOST, swings_of
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import make_machine, read_machine, write_machine
from workbook.studies.design import first_design
from workbook.studies.improve import single_gains
from workbook.template_outputs import Column

MOVES = ((30, 90, 20.0, "MTP"), (180, 300, -20.0, "CIC"))
LOAD = {"frequency": 12.0, "damping": 0.02, "settled": 15.0}


def swinging(load, *phases, laws=(), **entries):
    """Return a machine of an axis, behind which a load swings."""
    data = described([axis(1, *((*phase[:3], "CIC") for phase in phases or MOVES), **entries)], phases=4).model_dump()
    for told, phase in zip(data["axes"][0]["phases"], phases or MOVES, strict=True):
        told["law"] = phase[3]
    data["laws"] |= {name: {"family": name} for name in laws}
    data["axes"][0]["vibration"] = load
    del data["sizes"]["motion_pieces"]  # what these moves need
    return TEMPLATE.model.model_validate(data)


def swing(load, *phases, **entries):
    return swings_of(axes_of(swinging(load, *phases, **entries)))[0]


ODD = {
    "it never settles": ({"frequency": 0.01}, MOVES, {}),
    "no damping, and a limit": ({"frequency": 12.0, "settled": 1.0}, MOVES, {}),
    "stiffer than the points tell": ({"frequency": 4000.0, "damping": 0.99, "settled": 1e-9}, MOVES, {}),
    "stiffness": ({"stiffness": 40.0, "inertia": 8.0}, MOVES, {}),
    "it turns": ({"stiffness": 40.0, "inertia": 8.0, "damping": 0.1}, MOVES, {"unit": "°", "shift": 30.0}),
    "no rest at all": (LOAD, ((0, 120, 20.0, "MTP"), (120, 360, -20.0, "CIC")), {}),
    "a move across the end": (LOAD, ((0, 120, 20.0, "MTP"), (200, 360, -20.0, "CIC")), {}),
    "an open cycle": (LOAD, ((0, 120, 20.0, "MTP"), (200, 360, 20.0, "CIC")), {"closes": "open"}),
    "a dwell among the phases": (LOAD, ((0, 120, 20.0, "MTP"), (120, 200, 0.0, "DWL"), (200, 340, -20.0, "CIC")), {}),
    "in step": (LOAD, ((0, 120, 20.0, "MTP"), (120, 200, 30.0, "LIN"), (200, 300, -50.0, "CIC")), {"laws": ("LIN",)}),
}


@pytest.mark.parametrize("name", ODD)
@pytest.mark.sample(3)
def test_cells_and_engine_agree_on_odd_loads(name):
    load, phases, entries = ODD[name]
    machine = swinging(load, *phases, **entries)
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert judgement(machine).deviations == []


def test_what_is_odd_is_told():
    slow, stiff = swing({"frequency": 0.01}), swing(*ODD["stiffer than the points tell"][:1])
    assert slow.shares[:2] == pytest.approx([100.0, 100.0], abs=0.01)
    assert stiff.periods > MOST
    undamped = swing({"frequency": 12.0, "settled": 1.0})
    assert undamped.settling(2.0) == "never"
    assert undamped.later(undamped.left) == pytest.approx(undamped.left)
    assert swing({"stiffness": 40.0, "inertia": 8.0}).natural == pytest.approx(math.sqrt(40e3 / 8.0) / math.tau)
    assert swing({"stiffness": 40.0, "inertia": 8.0}, unit="°").natural == pytest.approx(math.sqrt(40e4 / 8) / math.tau)
    assert not swing(LOAD, *ODD["no rest at all"][1]).lift.any()
    in_step = swing(*ODD["in step"][:1], *ODD["in step"][1], laws=("LIN",))
    assert [lift > 0.0 for lift in in_step.lift] == [False, False, True, False]  # one move over three phases
    wraps = swing(LOAD, *ODD["a move across the end"][1])
    assert wraps.turned == pytest.approx([math.radians(280.0), 0.0, 0.0, 0.0])


def test_a_load_settles_as_its_damping_lets_it():
    """It falls by e^(−ζω t) over the rest; an oscillator that is integrated over the move begins there."""
    load, machine = swing(LOAD), swinging(LOAD)
    move, pause = load.ms(load.turned) / 1e3, load.ms(np.radians(load.rests)) / 1e3
    assert load.shares[0] == pytest.approx(100.0 * residual(law("MTP"), 12.0 * move[0], 0.02), abs=1e-6)
    assert load.later(load.left)[0] == pytest.approx(load.left[0] * math.exp(-0.02 * 12.0 * math.tau * pause[0]))
    value = computed(TEMPLATE, machine)
    assert value("vib1_settles") == "OK"
    tight = swinging(LOAD | {"settled": 0.1})
    value = computed(TEMPLATE, tight)
    assert value("vib1_settles") == "FAIL"
    assert value("vib1_settles_says").endswith("mm; expected at most 0.1 mm")
    assert [limit.ok for limit in judgement(tight).limits if limit.check == "vib1_settles"] == [False]


def test_only_axes_that_ask_for_it_get_cells_and_they_come_back(tmp_path):
    def cells(load):
        return {(cell.block.sheet.title, cell.quantity.name) for cell in TEMPLATE.declare(swinging(load)).cells()}

    assert not {name for title, name in cells(None) if title == "Vibration" or name.startswith("vib")}
    assert ("Vibration", "vib1_settled") in cells(LOAD)
    build(swinging(LOAD), tmp_path / "book.xlsx")
    assert read_inputs(tmp_path / "book.xlsx") == (swinging(LOAD), [])


def test_a_load_without_a_frequency_is_told_and_over_no_time_refused(tmp_path):
    data = swinging(LOAD).model_dump()
    data["axes"][0]["vibration"] = {"damping": 0.1}
    untold = make_machine(TEMPLATE, data, str)
    assert [fault.key for fault in untold.design.faults] == ["axes.0.vibration"]
    (line,) = build(untold, tmp_path / "book.xlsx")
    assert line.endswith(UNTUNED)
    assert read_inputs(tmp_path / "book.xlsx") == (untold, [])
    data["master"] = {"cycle": 300.0, "unit": "mm"}
    with pytest.raises(InputError, match="does not tell how time passes, which a vibration needs"):
        make_machine(TEMPLATE, data, str)


def test_studies_and_improve_know_it():
    machine = swinging(LOAD)
    rates = Column([machine.per_minute, 0.5 * machine.per_minute], np.array([0, 1]))
    found = results(machine, {"master.rate": rates})
    slower = machine.model_copy(update={"master": machine.master.model_copy(update={"rate": 0.5 * machine.per_minute})})
    expected = [swings_of(axes_of(each))[0].left.max() for each in (machine, slower)]
    assert found.named["vib1_left"]() == pytest.approx(expected)
    assert found.named["vib1_settles"]().tolist() == ["OK", "OK"]
    alike = swinging(LOAD, (30, 90, 20.0, "MTP"), (180, 240, -20.0, "MTP"))
    design = first_design(alike, AIMS["vibration"])
    assert design.cost == pytest.approx(swings_of(axes_of(alike))[0].exact.max())
    gains = [gain for gain in single_gains(design, THIS_PROCESS, lambda *_: None) if "phase 1" in gain.words]
    assert gains  # though the other of both moves that leave alike stays
    with pytest.raises(InputError, match="expected --frequency of a load"):
        first_design(swinging(None), AIMS["vibration"])


def given_out(folder, load, phases=MOVES, of="MTP", **entries):
    """The description of a machine whose first move is given out by a shaper, as it is entered and frozen."""
    path, frozen = folder / "soft.toml", folder / "frozen.toml"
    machine = swinging(load, *phases).model_dump(exclude_none=True)
    machine["laws"]["SOFT"] = {"family": "OPT", "of": of, "shaper": "ZVD"} | entries
    machine["axes"][0]["phases"][0]["law"] = "SOFT"
    text = write_machine(TEMPLATE.model.model_validate(machine))
    path.write_text(re.sub("(?m)^motion_pieces.*", "", text), encoding="utf-8")
    return path, frozen


@pytest.mark.parametrize("kind", Shaper.KINDS)
def test_within_its_band_a_shaper_leaves_at_most_5_percent_on_the_sheet(kind, tmp_path):
    """Of what the other law leaves, in the time that the shaper leaves it; the book has it and takes it back."""
    path, frozen = given_out(tmp_path, {"frequency": 40.0}, shaper=kind)
    assert freeze(path, None, False) == FAILS
    assert freeze(path, frozen, False) == AGREES
    assert freeze(frozen, None, False) == AGREES
    machine, shaper = read_machine(frozen), Shaper(kind)
    for ratio in (*shaper.band, 1.0):
        swinging_so = machine.axes[0].model_copy(update={"vibration": Vibration(frequency=40.0 * ratio)})
        load = swings_of(axes_of(machine.model_copy(update={"axes": [swinging_so]})))[0]
        shorter = load.ms(load.turned[0]) / 1e3 - shaper.time / 40.0
        alone = 100.0 * residual(law("MTP"), 40.0 * ratio * shorter)
        assert load.shares[0] == pytest.approx(shaper.left(ratio) * alone, abs=1e-3)
        assert load.shares[0] < 0.0501 * alone + 1e-3
    assert judgement(machine).deviations == []
    (cam,) = TEMPLATE.axes(machine)
    assert automatic(target("csv"), cam, {"a": 0.01}).excess({"a": 0.01}) <= 1.0
    build(machine, tmp_path / "book.xlsx")
    assert read_entered(tmp_path / "book.xlsx")[1].laws["SOFT"] == machine.laws["SOFT"]


def test_a_law_that_is_given_out_fits_until_the_rate_changes_and_its_cells_agree(tmp_path, capsys):
    path, frozen = given_out(tmp_path, {"frequency": 40.0, "damping": 0.02})
    assert freeze(path, frozen, False) == AGREES
    assert "SOFT: A1 phase 1 → ZVD of MTP, which costs 25.01 of 50 ms, " in capsys.readouterr().out
    machine = read_machine(frozen)
    assert machine.sizes.pieces == len(machine.laws["SOFT"].pieces) == 28
    assert disagreeing(TEMPLATE, machine)[0] == []
    text = frozen.read_text("utf-8")
    frozen.write_text(text.replace("rate = 200.0", "rate = 201.0"), encoding="utf-8")
    assert freeze(frozen, None, False) == FAILS


@pytest.mark.parametrize(
    ("load", "entries", "match"),
    [
        ({"frequency": 20.0}, {}, r"laws.SOFT.shaper: the move lasts 1 natural periods of its load; expected at least"),
        ({"frequency": 40.0, "damping": 0.3}, {}, r"laws.SOFT.shaper: damping is 0.3; expected"),
        ({"frequency": 40.0}, {"of": "MTQ"}, r"laws.SOFT.of: found 'MTQ'; expected a law from rest to rest"),
        ({"frequency": 40.0}, {"of": "SOFT"}, r"laws.SOFT.of: found 'SOFT'; expected a law"),
        (None, {}, r"laws.SOFT.shaper: 1 phases have this law, 0 of them between two rests with a vibration"),
    ],
)
def test_a_law_that_cannot_be_given_out_says_why(load, entries, match, tmp_path):
    with pytest.raises(InputError, match=match):
        freeze(given_out(tmp_path, load, **entries)[0], None, False)


@pytest.mark.parametrize("entries", [{"shaper": "ZVD"}, {"of": "MTP"}, {"shaper": "EI", "of": "MTP", "shaped": "rate"}])
def test_a_shaper_and_its_law_are_entered_together(entries):
    with pytest.raises(InputError, match=r"laws.SOFT"):
        make_machine(TEMPLATE, swinging(LOAD).model_dump() | {"laws": {"SOFT": {"family": "OWN"} | entries}}, str)


def test_improve_tries_shapers_for_a_vibration():
    design = first_design(swinging({"frequency": 45.0}), AIMS["vibration"])
    tried = {change.words.partition(" → ")[2]: change for change in design.tries("A1") if " of " in change.words}
    assert [*tried][:2] == ["ZV of MTP, which costs 11.11 of 50 ms", "ZVD of MTP, which costs 22.22 of 50 ms"]
    other = design.changed(tried["ZVD of MTP, which costs 22.22 of 50 ms"])
    assert other.cost < design.cost
    assert other.machine.laws["ZVD 1-1"].of == "MTP"
