"""Unfinished designs: built, told by row and amount, verified without a finding, read back and built again the same."""

import copy
import tomllib

import openpyxl
import pytest
import tomli_w

from workbook.book.limits import EXPECTED, MESSAGES
from workbook.build import build, read_inputs
from workbook.errors import FAILS, InputError
from workbook.judging.batch import Target, exit_code, verify_one
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine, write_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing.archive import same_book

MOVED, FEED = ("axes", 1, "phases"), ("axes", 0)
ONLY = ("axes", 0, "phases")
TOOL = ("overlap", "tools", 0)
PARTS = "Drive MC01, Rotating parts: entries within limits"
PHASES = "Timing, Phases of axis 2: entries within limits"
UNEQUAL = [0.1, 0.2, 0.1, 0.2, 0.1, 0.2, 0.2]

CASES = {
    "machine": {
        "no phases": ([("axes", 1, "phases", [])], "Timing, Phases of axis 2: entries within limits",
                      "no row is filled"),
    },
    "cutting-machine": {
        "an overlap": ([(*MOVED, 1, "start", 60.0)], "Axis 2: phases follow without overlap",
                       "MC02 row 2 begins at 60°, 30° before row 1 ends"),
        "a phase that runs backwards": ([(*MOVED, 1, "stop", 60.0)], "Axis 2: every phase runs forward",
                                        "MC02 row 2 ends at 60°, 30° before it begins"),
        "a missing law": ([(*MOVED, 1, "law", None)], PHASES, "row 2, lift of a dwell or without a law: 20"),
        "a dwell with a lift": ([(*MOVED, 0, "lift", 5.0)], PHASES, "row 1, lift of a dwell or without a law: 5"),
        "a negative inertia": ([(*FEED, "parts", 0, "inertia", -1e-5)], PARTS,
                               "row 1, inertia of one: -1e-05; expected a number of at least 0"),
        "teeth of one gear": ([(*FEED, "parts", 1, "teeth_driven", None)], PARTS,
                              "row 2, teeth of one gear alone, of the driver: 90"),
        "half a curve": ([("selection", "motors", 0, "end_torque", 1.0)], None,
                         "row 1, half of the curve is empty: peak torque up to: empty"),
        "several": ([("master", "rate", 0.0), (*MOVED, 1, "start", 60.0), (*FEED, "mechanism", "roller_radius", -1.0)],
                    "Axis 2: phases follow without overlap",
                    "MC02 row 2 begins at 60°, 30° before row 1 ends"),
    },
    "motion-composer": {
        "durations that do not sum": ([("laws", "MTP", {"durations": UNEQUAL})],
                                      "MTP: the seven durations sum to 1", "they sum to 1.1; expected 1"),
        "a law that cannot stop": ([("laws", "MTP", {"durations": [0.5, 0.5, 0, 0, 0, 0, 0]})],
                                   "MTP: the law starts and stops", "stages 1 to 3, or 5 to 7, are all 0"),
        "an own law of 0.7": ([("laws", "OWN", {"pieces": [{"duration": 0.7}]})],
                              "OWN: the durations sum to 1", "they sum to 0.7; expected 1"),
        "a sine without frequency": ([("laws", "OWN", {"pieces": [{"duration": 1.0, "amplitude": 2.0}]})], None,
                                     "row 1, ω of a sine, expected more than 0: empty"),
        "a named law": ([("laws", "Soft 1.5", {"family": "MTP", "durations": UNEQUAL}),
                         (*ONLY, 0, "law", "Soft 1.5")],
                        "Soft 1.5: the seven durations sum to 1", "they sum to 1.1; expected 1"),
    },
    "flying-cutter": {
        "a product too short": ([("cutter", "product_length", 1.0)], "The products leave time to re-position",
                                "a product of 1 mm; expected at least 62.894684925 mm"),
        "half a tool": ([("cutter", "drum", "tools", 2.5)], "A drum has whole tools",
                        "2.5 tools; expected a whole number"),
        "tools in step for too long": ([("cutter", "drum", "tool_angle", 120.0)],
                                       "The angle in step is less than between the tools",
                                       "3 tools in step over 120° each take more than 360°"),
        "lengths that do not rise": ([("cutter", "lengths", "longest", 1.0)], "The range of product lengths rises",
                                     "from 150 mm to 1 mm; expected a longest above the shortest"),
        "nothing to move": ([("cutter", "load", "inertia", 0.0)], "The shaft has something to move",
                            "inertia and mass are 0; expected one of them above"),
        "a law that does not rest": ([("cutter", "law", "OWN"),
                                      ("laws", "OWN", {"pieces": [{"duration": 1.0, "c0": 2.0}]})],
                                     "The law speeds up once and slows down once",
                                     "the law OWN does not: see its sheet, or Laws"),
    },
    "indexing-overlap": {
        "a margin above the clearance": ([(*TOOL, "passage", "margin", 50.0)],
                                         "The margin is not more than the clearance",
                                         "a margin of 50 mm; expected at most 20 mm"),
        "no angle left": ([(*TOOL, "dwell", 300.0)], "The cycle leaves the tool an angle",
                          "-50° are left to a way; expected at least 0.01°"),
        "more than a turn": ([(*TOOL, "angle_in", 250.0)], "Way in, dwell and way out fit into the turn",
                             "way in, dwell and way out take 469.836915251°; expected at most 360°"),
        "a law that moves backwards": ([(*TOOL, "law_in", "OWN"), ("laws", "OWN", {"pieces": [
            {"duration": 0.5, "c0": -4.0}, {"duration": 0.5, "c0": 12.0}]})],
            "The laws never move backwards", "a law moves backwards: see its sheet, or Laws"),
    },
    "motion-laws": {
        "break points in disorder": ([("laws", "TVP", {"rise_end": 0.8, "fall_start": 0.2})],
                                     "TVP: the break points follow each other", "brakes from 0.2, before 0.8"),
    },
    "actuator-sizing": {
        "too hot": ([("axes", 0, "motor", "temperature", 200.0)], "Drive Slide: ambient temperature below the limit",
                    "200 °C; expected less than the limit, 175 °C"),
        "neither an inertia nor a size": ([("axes", 0, "parts", 0, "length", None)], None,
                                          "row 1, neither an inertia nor a cylinder's diameter, length and "
                                          "density: inertia: empty"),
        "both of them": ([("axes", 0, "parts", 0, "inertia", 1e-5)], None,
                         "row 1, both an inertia and a cylinder: inertia: 0.00001"),
        "no motor": ([("axes", 0, "motor", "inertia", None)], "Drive Slide: a motor is named or entered", ""),
        "a bore too wide": ([("axes", 0, "parts", [
            {"name": "x", "count": 1.0, "diameter": 3.0, "length": 1.0, "density": 1.0, "bore": 3.0,
             "shaft": "motor"}])], None, "row 1, bore, not less than the diameter: 3"),
        "a belt that pushes": ([("axes", 0, "mechanism", {"kind": "conveyor", "efficiency": 0.9,
                                                          "roller_diameter": 40.0, "belt_mass": -1.0})],
                               "Drive Slide: entries within limits",
                               "Mass of the belt: -1; expected a number of at least 0"),
    },
}  # fmt: skip
SLOW = ("machine", "cutting-machine", "actuator-sizing", "flying-cutter")
TRIED = [pytest.param(name, case, marks=[pytest.mark.nightly] if n % 3 or name in SLOW else [])
         for name, cases in CASES.items() for n, case in enumerate(cases)]  # fmt: skip
"""every third of those that are soon verified by day, and all by night"""
UNLIKE = ("", "no row is filled", "row 1, half of the curve is empty: peak torque up to: empty")
"""sentences of the cells that say otherwise what the entries' own rules say"""
SMALL = {"cycle": 12, "law": 10}


def small(name):
    """A committed description, with tables as small as they may be; of the machines only one has a drive."""
    data = tomllib.loads((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))
    data["sizes"] = data.get("sizes", {}) | SMALL
    if name == "machine":
        del data["selection"], data["power"]
        for axis in data["axes"]:
            for entry in ("mechanism", "load", "parts", "motor", "reducer"):
                axis.pop(entry, None)
    if name not in ("machine", "motion-composer", "indexing-overlap", "motion-laws"):
        few = read_machine(FOLDER / f"{name}.toml").selection.model_dump(exclude_none=True)
        data["selection"] = {entry: few[entry][:2] for entry in ("motors", "reducers")}
        data["sizes"] |= {"motors": 2, "reducers": 2, "cycle": 360}  # fewer samples do not tell the peak of the bus
    return data


def changed(data, changes):
    """A description with these entries; None takes one away."""
    data = copy.deepcopy(data)
    for *above, last, value in changes:
        entry = data
        for part in above:
            if isinstance(part, str) and part not in entry:
                entry[part] = {}
            entry = entry[part]
        if value is None:
            del entry[last]
        else:
            entry[last] = value
    return data


def written(data, path):
    path.write_text(tomli_w.dumps(data), encoding="utf-8")
    return path


@pytest.mark.parametrize(("name", "case"), TRIED)
@pytest.mark.sample(1)
def test_out_in_and_through(name, case, tmp_path):
    changes, check, sentence = CASES[name][case]
    machine = read_machine(written(changed(small(name), changes), tmp_path / "machine.toml"))
    messages = [fault.message for fault in machine.design.faults]
    assert [line.partition(": ")[2] for line in build(machine, tmp_path / "book.xlsx")] == messages
    assert sentence in UNLIKE or any(message in sentence or sentence in message for message in messages), messages
    outcome = verify_one(Target(tmp_path / "book.xlsx", named=True), ["pycel"])
    assert (outcome.reason, outcome.report and outcome.report.findings) == ("", [])
    assert exit_code([outcome]) == FAILS
    report = outcome.report
    told = [c for c in report.failing if c.what == check] if check else report.failing
    assert [c for c in told if c.found == "FAIL" and c.says.endswith(sentence)]
    assert report.compared + report.unfinished == report.declared
    back, notes = read_inputs(tmp_path / "book.xlsx")
    assert (back, notes) == (machine, [])
    build(back, tmp_path / "again.xlsx")
    assert same_book(tmp_path / "book.xlsx", tmp_path / "again.xlsx")
    (tmp_path / "again.toml").write_text(write_machine(back), encoding="utf-8")
    assert read_machine(tmp_path / "again.toml") == machine


EDITED = {
    "machine": [("axis2", "start", 1, 95.0), ("timing_rate", None, 0, -200.0)],
    "cutting-machine": [("axis2", "start", 1, 60.0), ("drive1_parts", "driven", 1, None)],
    "motion-composer": [("axis1", "stop", 1, None), ("TVP_av", None, 0, 1.5)],
    "flying-cutter": [("fly_length", None, 0, 1.0), ("fly_inertia", None, 0, -1.0)],
    "indexing-overlap": [("tool1_dwell", None, 0, 300.0), ("overlap_rate", None, 0, None)],
    "actuator-sizing": [
        ("drive1_eta2", None, 0, 1.3),
        ("drive1_winding", None, 0, 20.0),
        ("drive1_parts", "bore", 0, 20.0),
        ("drive1_parts", "inertia", 0, 1e-5),
    ],
    "motion-laws": [("TVP_av", None, 0, 1.5), ("CIC_share", None, 0, 1.0)],
}


PASTED = [pytest.param(name, edit, marks=[pytest.mark.nightly] if name in SLOW else [])
          for name, edits in EDITED.items() for edit in edits]  # fmt: skip


@pytest.mark.parametrize(("name", "edit"), PASTED)
@pytest.mark.sample(1)
def test_what_is_pasted_into_a_book(name, edit, tmp_path):
    """No validation holds it back: the sheet, verify, inputs and regenerate take it alike."""
    machine = read_machine(written(small(name), tmp_path / "machine.toml"))
    build(machine, tmp_path / "book.xlsx")
    block, column, row, value = edit
    place = TEMPLATES[machine.template].declare(machine).blocks[block]
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    book[place.sheet.title].cell(place.row + row, place.columns[column or block]).value = value
    book.save(tmp_path / "edited.xlsx")
    report = verify(tmp_path / "edited.xlsx")
    assert (report.findings, report.holds) == ([], False)
    assert report.unfinished
    assert any(c.found == "FAIL" and c.says for c in report.failing)
    found, _ = read_inputs(tmp_path / "edited.xlsx")
    assert len(found.design.replaced) >= 1
    build(found, tmp_path / "new.xlsx")
    assert (verify(tmp_path / "new.xlsx").findings, read_inputs(tmp_path / "new.xlsx")[0]) == ([], found)


def test_empty_cells_have_no_value(tmp_path):
    """A cell that is unfinished keeps its formula and is saved without a value; no cell has an error value."""
    machine = read_machine(written(changed(small("cutting-machine"), [("master", "rate", 0.0)]), tmp_path / "m.toml"))
    build(machine, tmp_path / "book.xlsx")
    declared = TEMPLATES["machine"].declare(machine)
    formulas = openpyxl.load_workbook(tmp_path / "book.xlsx")
    values = openpyxl.load_workbook(tmp_path / "book.xlsx", data_only=True)
    unfinished = [c for c in declared.cells() if c.quantity.formula is not None and c.expected is None]
    assert len(unfinished) > 50
    for cell in unfinished:
        title = cell.block.sheet.title
        held = values[title].cell(cell.row, cell.column)
        assert held.value is None or held.hyperlink  # in place of no value openpyxl gives where a link leads
        assert formulas[title].cell(cell.row, cell.column).value == cell.content


def test_faults_that_follow_from_a_missing_entry_are_not_named(tmp_path):
    """Another part's are: all that is wrong with a design is told at once."""
    changes = [(*MOVED, 1, "stop", None), ("axes", 2, "phases", 1, "start", 5.0), ("master", "rate", 0.0)]
    machine = read_machine(written(changed(small("cutting-machine"), changes), tmp_path / "m.toml"))
    named = ["master.rate", "axes.1.phases.1.stop", "axes.2.phases.1.start"]
    assert [fault.key for fault in machine.design.faults] == named


@pytest.mark.parametrize(
    ("changes", "line"),
    [
        ([(*MOVED, 1, "start", 60.0), (*MOVED, 1, "law", "MPT")], "law"),
        ([("axes", [])], "axes"),
        ([("axes", 1, "shift", 1e300)], "found 1e+300; expected a number of at most 1e+12 in size"),
        ([("axes", 0, "shift", 4e-320)], "found 3.99996e-320; expected 0, or at least 1e-30 in size"),
        ([(*MOVED, 1, "lift", -1e-300)], "found -1e-300; expected 0, or at least 1e-30 in size"),
        ([("master", "rate", 1e-13)], "and of at least 1e-12 if it is more than 0"),
        ([("sizes", "cycle", 1)], "sizes.cycle"),
    ],
)
def test_structure_and_type_refuse_in_one_line(changes, line, tmp_path):
    with pytest.raises(InputError) as refused:
        read_machine(written(changed(small("cutting-machine"), changes), tmp_path / "machine.toml"))
    (told,) = refused.value.lines
    assert line in told


@pytest.mark.parametrize("name", TEMPLATES)
def test_every_check_says_where_and_by_how_much(name):
    template = TEMPLATES[name]
    book = template.declare(read_machine(template.description))
    assert [q.name for _, q in book.checks if not q.says] == []
    blocks = {block.name for block in book.blocks.values() for q in block.quantities
              if q.role == "input" and book.limit(q.key, q.upper_limit) is not None}  # fmt: skip
    messages = (EXPECTED, MESSAGES)
    assert blocks <= {name.removesuffix(end) for name in book.blocks for end in messages if name.endswith(end)}
