"""Random machines: pycel and the engine agree in every formula cell, and what goes into a book comes out of it."""

import io
import itertools
import random
import tempfile
from filecmp import cmp
from pathlib import Path

import formualizer
import openpyxl
import pytest
from hypothesis import given, settings
from hypothesis.strategies import integers

from tests.laws import MOVING, PAGED, blended
from tests.mutation.draw_machine import SHAPED, teeth
from tests.workbook.cells import disagreeing, disagreeing_in
from workbook.build import build, read_inputs
from workbook.reading.descriptions import read_machine, validated, write_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
SIZES = {"cycle": 24, "law": 8, "phases": 8, "rotors": 6, "pieces": 8, "motors": 2, "reducers": 2}


def shares(dice, count, zeros=0.0):
    """So many numbers that sum to 1, some of them zero."""
    parts = [0.0 if dice.random() < zeros else dice.uniform(0.05, 1.0) for _ in range(count)]
    total = sum(parts)
    return [p / total for p in parts] if total else [1.0, *parts[1:]]


def durations(dice):
    """Seven durations, of each kind at times zero; the law must be able to start and stop."""
    while True:
        made = shares(dice, 7, zeros=dice.choice((0.0, 0.3, 0.5)))
        if sum(made[:3]) and sum(made[4:]):
            return made


def piece(dice, duration):
    """A piece of polynomial, sine, or both."""
    kind = dice.choice(("polynomial", "sine", "both"))
    made = {"duration": duration}
    if kind != "sine":
        made |= {name: dice.uniform(-20, 20) for name in ("c0", "c1", "c2", "c3")}
    if kind != "polynomial":
        made |= {"amplitude": dice.uniform(-9, 9), "omega": dice.uniform(0.5, 30), "phase": dice.uniform(-4, 4)}
    return made


def phases(dice, known):
    """From one phase to as many as the table has rows, over the whole turn; lifts of either sign."""
    count = dice.choice((1, 2, 3, 5, SIZES["phases"]))
    cuts = sorted(dice.sample(range(1, 36), count - 1)) if dice.random() < 0.5 else []
    edges = [10.0 * c for c in cuts] or sorted(dice.uniform(5, 355) for _ in range(count - 1))
    edges = [0.0, *edges, 360.0]
    made = []
    for start, stop in itertools.pairwise(edges):
        law = dice.choice((*known, "DWL"))
        lift = 0.0 if law == "DWL" or dice.random() < 0.1 else dice.choice((-1, 1)) * dice.uniform(0.5, 500)
        made.append({"start": start, "stop": stop, "lift": lift, "law": law})
    if dice.random() < 0.5 and made[-1]["law"] != "DWL":
        made[-1]["lift"] -= sum(p["lift"] for p in made)
    return made


def machine(seed):
    """A machine that no engineer would build, but that the rules allow."""
    dice = random.Random(seed)
    first = dice.uniform(0.01, 0.9)
    laws = {
        code: {"lift": dice.uniform(-300, 300), "time": dice.uniform(0.01, 3), **blended(code, random.Random(seed))}
        for code in PAGED
    }
    laws["TVP"] |= {"rise_end": first, "fall_start": first if seed % 7 == 0 else dice.uniform(first, 0.99)}
    laws["MTP"]["durations"] = durations(dice)
    pieces = shares(dice, dice.randint(1, SIZES["pieces"]), zeros=0.1)
    laws["OWN"] = {"name": f"Own law {seed}", "pieces": [piece(dice, d) for d in pieces]}
    names = ["MC01", "Träger ½", "Cutter's <2> & more"]
    driven = seed % 3
    axes = [
        {"name": name, "group": f"Group {i}", "closes": dice.choice(("position", "feed")),
         "unit": dice.choice(("mm", "°")), "shift": dice.choice((0.0, dice.uniform(-400, 400))),
         "phases": phases(dice, [law for law in MOVING if i != driven or law in SHAPED])}
        for i, name in enumerate(names)
    ]  # fmt: skip
    axes[driven] |= drive(dice, seed)
    data = {
        "template": "machine", "title": f"Machine {seed}", "laws": laws, "sizes": SIZES,
        "master": {"rate": dice.uniform(5, 400)}, "axes": axes,
        "selection": {"motors": [MOTOR], "reducers": [{"name": "R", "reduction": 5.0, "efficiency": 0.9}]},
    }  # fmt: skip
    made = validated(TEMPLATE, data, str)
    assert made.design.replaced == {}
    return made


MOTOR = {"name": "M", "inertia": 100.0, "rated_torque": 10.0, "peak_torque": 30.0, "max_speed": 3000.0}


def drive(dice, seed):
    """Feed rollers with parts, some of them geared, a force always and one in the way of the motion."""
    parts = [
        {"name": f"Part {i}", "count": float(dice.randint(0, 6)), "inertia": dice.uniform(0, 0.5),
         "shaft": dice.choice(("motor", "mechanism")), **teeth(dice)}
        for i in range(dice.randint(1, SIZES["rotors"]))
    ]  # fmt: skip
    resists = ("always", "moving")[seed // 3 % 2]
    window = {"start": 0.0, "stop": dice.choice((360.0, dice.uniform(10, 350))), "force": 300.0, "resists": resists}
    return {
        "unit": "mm", "rate": dice.choice((None, dice.uniform(5, 300))), "parts": parts,
        "mechanism": {
            "kind": "feed rollers", "roller_radius": dice.uniform(20, 500), "efficiency": dice.uniform(0.5, 1),
        },
        "load": {"force": dice.choice((0.0, dice.uniform(-900, 900))), "windows": [window]},
        "motor": {
            "inertia": dice.choice((0.0, dice.uniform(1e-4, 0.1))), "rated_torque": dice.uniform(1, 500),
            "peak_torque": dice.uniform(1, 1500), "max_speed": dice.uniform(100, 6000),
        },
        "reducer": {"ratio": dice.uniform(0.2, 50), "efficiency": dice.choice((1.0, dice.uniform(0.5, 1)))},
    }  # fmt: skip


@pytest.mark.parametrize("seed", range(60))
@pytest.mark.sample(5)
def test_pycel_agrees_with_the_engine_in_every_cell(seed):
    wrong, count = disagreeing(TEMPLATE, machine(seed))
    assert wrong == []
    assert count > 2000


def by_formualizer(written):
    draft = io.BytesIO()
    written.save(draft)
    filled = io.BytesIO(formualizer.recalculate_xlsx_bytes(draft.getvalue())["bytes"])
    opened = openpyxl.load_workbook(filled, data_only=True)
    return {
        (s.title, c.row, c.column): "" if c.value is None else c.value
        for s in opened
        for row in s.iter_rows()
        for c in row
    }


@pytest.mark.parametrize("seed", range(100, 103))
@pytest.mark.sample(1)
def test_formualizer_agrees_with_the_engine_in_every_cell(seed):
    assert disagreeing_in(TEMPLATE, machine(seed), by_formualizer)[0] == []


@settings(max_examples=4, derandomize=True)
@given(seed=integers(0, 10**9))
def test_machine_comes_back_from_its_book(seed):
    with tempfile.TemporaryDirectory() as folder:
        entered, path, again = machine(seed), Path(folder, "book.xlsx"), Path(folder, "again.xlsx")
        build(entered, path)
        back, notes = read_inputs(path)
        assert back == entered
        assert notes == []
        build(back, again)
        assert cmp(again, path, shallow=False)


@pytest.mark.parametrize("seed", range(300, 310))
def test_machine_comes_back_from_its_description(seed, tmp_path):
    path = tmp_path / "machine.toml"
    path.write_text(write_machine(machine(seed)), encoding="utf-8")
    assert read_machine(path) == machine(seed)
