"""A machine without a master shaft: its cycle and all places over it in s; the same machine told in degrees."""

import copy
import random

import numpy as np
import pytest
import tomli_w

from tests.tiers import by_day, nights
from tests.workbook.cells import computed
from tests.workbook.edit import enter
from tests.workbook.machines.in_seconds import convert_to_seconds
from workbook.build import build, read_inputs
from workbook.entries.design import as_entered
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.machines.machine.entries_beside import Cycle
from workbook.reading.descriptions import counted_from_1, make_machine, read_machine
from workbook.templates import TEMPLATES
from workbook.writing.archive import same_book

MACHINE = TEMPLATES["machine"]
SMALL = {"cycle": 12, "law": 4, "phases": 3}
OUT, BACK = {"start": 0.05, "stop": 0.095, "lift": 20.0, "law": "MTP"}, {
    "start": 0.2, "stop": 0.29, "lift": -20.0, "law": "CIC"
}  # fmt: skip
DRIVE = {
    "mechanism": {"kind": "lead screw", "lead": 20.0, "efficiency": 0.8},
    "load": {"mass": 30.0, "friction": 0.05, "windows": [{"start": 0.28, "stop": 0.07, "force": 40.0}]},
    "motor": {"inertia": 10.0, "rated_torque": 500.0, "peak_torque": 1500.0, "max_speed": 30000.0},
}


def axis(name="MC02", *phases, **more):
    return {"name": name, "group": "Pressing", "phases": copy.deepcopy(list(phases or (OUT, BACK)))} | more


def told(*axes, cycle=0.3, **more):
    """A description in seconds."""
    data = {"template": "machine", "title": "In seconds", "master": {"cycle": cycle}, "sizes": SMALL}
    return data | {"axes": list(axes or [axis()])} | more


def machine(*axes, **more):
    return make_machine(MACHINE, told(*axes, **more), counted_from_1)


def small(name):
    """A committed machine with small tables, told in degrees."""
    given = read_machine(MACHINE.description.with_name(f"{name}.toml"))
    data = given.model_dump()
    data["sizes"] |= {"cycle": 12, "law": 4}
    return type(given).model_validate(data)


ENTRIES = {"timing_cycle", "timing_rate_entries", "timing_rate_entries_says", "timing_rate_expected"}
PLACES = {("bus", "theta"), *((f"axis{k}", "ms") for k in range(1, 10))}
"""columns that a book in seconds has under another name: its places are times, and its durations in s"""
SENTENCES = ("says", "about_verdict", "listed", "longer")
"""ends of the names of cells with sentences: of places, and of how many checks there are"""
TOLD = ("_order_place", "_order_size", "_order_unit", "_order_jump")
"""ends of the names of cells that tell a jump in the units of the cycle"""


def figures(book):
    """What the engine has for each formula cell of a book, by block, column and row, with the peak of the column."""
    found = {}
    for name, block in book.blocks.items():
        for q in block.quantities:
            if q.formula is not None and not name.startswith(("checks", "stamp")):  # sums of what is entered
                values = np.atleast_1d(np.array(q.value, dtype=object)).tolist()
                numbers = [abs(x) for x in values if isinstance(x, int | float)]
                peak = max([*numbers, q.scale or 0.0]) or 1.0
                found |= {(name, q.name, i): (q.unit, x, peak) for i, x in enumerate(values)}
    return found


def require_same(given):
    """A machine gives the same results in degrees and in seconds, but for places, which are told in other units."""
    one, other = (figures(MACHINE.declare(m)) for m in (given, convert_to_seconds(given)))
    assert {at[0] for at in set(one) - set(other) if at[:2] not in PLACES} <= ENTRIES
    moved = {at[:2] for at in set(one) & set(other) if one[at][0] != other[at][0]}
    far = []
    for at in (at for at in set(one) & set(other) if not at[1].endswith(TOLD)):
        unit, value, peak = one[at]
        unit_too, value_too, _ = other[at]
        if isinstance(value, str):
            far += [at] if value != value_too and at[:2] not in moved and not at[1].endswith(SENTENCES) else []
        elif unit == unit_too and abs(value - value_too) > 1e-9 * peak:
            far.append(at)
    assert far == []
    return moved, one


@pytest.mark.parametrize("name", ["machine", "machine-linkages"])
def test_the_same_machine_in_degrees_and_in_seconds_gives_the_same(name):
    data = small(name).model_dump()
    data["master"]["rate"] = 137.3
    given = type(small(name)).model_validate(data)
    moved, found = require_same(given)
    columns = {column.removeprefix("drive1_").removeprefix("drive2_") for _, column in moved}
    assert columns <= {"at", "early", "moved", "needed", "place", "time", "x1", "x2"}
    assert {"drive1_rms", "power_mains", "axis1_position"} < {name for name, *_ in found}
    assert name != "machine" or {"bus_mains_peak", "sel_best"} & {name for name, *_ in found}


def test_out_in_and_through(tmp_path):
    """From build to verify, inputs and regenerate."""
    given = machine(axis(shift=0.01), axis("X", OUT, closes="feed"), switches=[{"name": "V", "on": [[0.25, 0.02]]}])
    build(given, tmp_path / "book.xlsx")
    report = verify(tmp_path / "book.xlsx")
    assert report.findings == []
    back, notes = read_inputs(tmp_path / "book.xlsx")
    assert (back, notes) == (given, [])
    assert isinstance(back.master, Cycle)
    build(back, tmp_path / "again.xlsx")
    assert same_book(tmp_path / "book.xlsx", tmp_path / "again.xlsx")
    (tmp_path / "again.toml").write_text(tomli_w.dumps(as_entered(back)), encoding="utf-8")
    assert read_machine(tmp_path / "again.toml") == given


def test_instants_that_coincide_but_for_rounding_do():
    edge = 0.1 + 0.2  # 0.30000000000000004
    given = machine(axis("A", {**OUT, "start": 0.1 + 0.1 + 0.1 - 0.1, "stop": edge}, closes="feed"), cycle=0.3)
    assert given.design.faults == ()
    assert computed(MACHINE, given)("overall") == "OK"


LATE, EARLY = {**BACK, "stop": 0.31}, {**BACK, "start": 0.09}
WINDOW = {"load": {"mass": 1.0, "windows": [{"start": 0.1, "stop": 0.32, "force": 40.0}]}}
CASES = {
    "an overlap": (told(axis("MC02", OUT, EARLY)), "MC02 row 2 begins at 0.09 s, 0.005 s before row 1 ends"),
    "beyond the cycle": (told(axis("MC02", OUT, LATE)), "MC02 row 2 goes to 0.31 s, 0.01 s beyond the cycle"),
    "a force beyond it": (told(axis(**DRIVE | WINDOW)),
                          "MC02 process force 1 goes to 0.32 s, 0.02 s beyond the cycle"),
    "a time beyond it": (told(switches=[{"name": "V", "on": [[0.01, 0.02], [0.05, 0.5]]}]),
                         "V time 2 goes to 0.5 s, 0.2 s beyond the cycle"),
    "a jump": (told(axis("A", {"start": 0.1, "stop": 0.2, "lift": 10.0, "law": "CUB"}, closes="feed")),
               "A at 0.1 s: acceleration jumps by 6 m/s²"),
    "no cycle": (told(cycle=0.0), "0; expected a number greater than 0"),
    "a negative cycle": (told(cycle=-12.0), "-12; expected a number greater than 0"),
}  # fmt: skip


@pytest.mark.parametrize("case", by_day(CASES, "an overlap"))
def test_what_does_not_do_is_told_by_row_and_amount(case, tmp_path):
    data, said = CASES[case]
    (tmp_path / "machine.toml").write_text(tomli_w.dumps(data), encoding="utf-8")
    given = read_machine(tmp_path / "machine.toml")
    lines = build(given, tmp_path / "book.xlsx")
    assert any(line.endswith(f": {said}") for line in lines), lines
    report = verify(tmp_path / "book.xlsx")
    assert report.findings == []
    assert any(check.found == "FAIL" and check.says.endswith(said) for check in report.failing)
    back, notes = read_inputs(tmp_path / "book.xlsx")
    assert (back, notes) == (given, [])


CHANGED = [(0.25, "row 2 goes to 0.29 s, 0.04 s beyond the cycle"), (None, "Time of a cycle: empty")]


@pytest.mark.parametrize(("value", "said"), CHANGED)
@pytest.mark.sample(1)
def test_a_shorter_cycle_in_the_book_fails_and_comes_back(value, said, tmp_path):
    """The engineer changes the time on the sheet: what ends behind it FAILs; an empty cell is told."""
    given = machine()
    build(given, tmp_path / "book.xlsx")
    enter(tmp_path / "book.xlsx", tmp_path / "edited.xlsx", {"timing_cycle": value})
    report = verify(tmp_path / "edited.xlsx")
    assert report.findings == []
    assert any(said in check.says for check in report.failing)
    found, _ = read_inputs(tmp_path / "edited.xlsx")
    assert as_entered(found)["master"] == {"unit": "s"} | ({"cycle": value} if value else {})


def test_both_a_rate_and_a_cycle_are_refused_in_a_line():
    data = told()
    data["master"]["rate"] = 200.0
    with pytest.raises(InputError, match=r"^master\.rate: entered beside cycle; expected one of them"):
        make_machine(MACHINE, data, counted_from_1)


@pytest.mark.parametrize("number", [0, *nights(6)])
def test_random_machines_are_the_same_in_seconds(number):
    """A variation of the committed machine, all of it another, told both ways."""
    variants = MACHINE.variants(small("machine"))
    given = variants[random.Random(number).randrange(len(variants))]
    require_same(given)
