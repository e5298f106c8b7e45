"""The page of a drive: results at the same addresses whatever the drive, each quantity once, legible in print."""

import re
from collections import defaultdict
from functools import cache

import pytest

from tests.mutation.machines import machines
from tests.workbook.machines.test_machine_drives import LOSSY, ROCKER, SHORT, TABLE, TOOTHED, arm, linked, press, small
from tests.workbook.machines.test_machine_stages import SCREW, WORM
from workbook.build import committed_descriptions
from workbook.machines.machine.drive.front_page import COLUMNS, GROUPS, NAMED, REST, RIGHT, SAYS
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.writing import layout, style
from workbook.writing.layout import PossibleTexts, widths

BRAKE = {"torque": 120.0, "closing": 20.0, "opening": 60.0}
LEAST = 7.0  # points of a text on paper
AXES = {
    "screw": SCREW,
    "crank": linked(**LOSSY),
    "rocker": linked(*SHORT, mechanism=ROCKER),
    "points": linked(mechanism=TABLE),
    "press": press(),
    "arm": arm(),
}
DRIVEN = [
    machine
    for machine in map(read_machine, committed_descriptions())
    if any(axis.motor for axis in getattr(machine, "axes", ()))
]


@cache
def longest(kind):
    """The sheet of a drive with all that it may have: a brake, two stages, viscous friction, a motor's curve."""
    axis = AXES[kind] | {"stages": [TOOTHED, WORM]}
    motor = axis["motor"] | {"holding": "brake", "brake": BRAKE}
    machine = small(axis | {"motor": motor, "load": axis.get("load", {}) | {"viscous": 3.0}})
    falling = machine.selection.model_copy(update={"falling": True})
    (sheet,) = pages(machine.model_copy(update={"selection": falling}))
    return sheet


def pages(machine):
    """The sheets of drives of a machine."""
    book = TEMPLATES[machine.template].declare(machine)
    return [sheet for sheet in book.sheets if sheet.page_end]


@cache
def every_page():
    """The sheets of the drives of all templates, and the longest."""
    return [*(page for machine in DRIVEN for page in pages(machine)), *map(longest, AXES)]


def cell(block):
    """The name of a cell without the number of its drive."""
    return re.sub("^drive[0-9]+_", "@", block.name)


def moved(sheets):
    """Cells of the right that have several addresses."""
    found = defaultdict(set)
    for block in (block for sheet in sheets for block in sheet.blocks if RIGHT <= block.column <= SAYS):
        if cell(block) in NAMED:
            found[cell(block)].add((block.row, block.column))
    assert len(found) > 40
    return {name: places for name, places in found.items() if len(places) > 1}


def test_a_result_has_one_address_on_the_sheets_of_all_drives():
    assert moved(every_page()) == {}


@pytest.mark.nightly
def test_a_result_has_one_address_on_the_sheets_of_random_machines():
    drawn = [other for machine in DRIVEN for other in machines(machine, -(-100 // len(DRIVEN)), machine.title)]
    assert len(drawn) >= 100
    assert moved(page for machine in drawn for page in pages(machine)) == {}


def test_no_quantity_stands_twice_on_the_page():
    """Of motor and reducer each row has what is entered, catalogued and in use; no other row has the same label."""
    for group in GROUPS:
        labels = [row.get("row") for row in group.rows]
        assert len(set(labels)) == len(labels)
    cells = [name for group in GROUPS for row in group.rows for head, name in row.items() if head in COLUMNS]
    assert len(set(cells)) == len(cells)
    for group in GROUPS[:2]:
        assert all({"entered", "catalogue", "in use"} <= row.keys() for row in group.rows[1:])


@pytest.mark.parametrize("kind", AXES)
def test_each_page_of_the_longest_drive_is_legible_in_print_and_has_all_entries(kind):
    sheet = longest(kind)
    wide = widths(sheet, PossibleTexts(sheet.book))
    scale = int(100 * layout.pages(sheet, sheet.print_rows, sheet.print_columns, wide, sheet.heights).scale) / 100
    assert scale * min(float(look.font.sz) for look in (*style.ROLES.values(), *style.TEXTS.values())) >= LEAST
    assert {"@brake_torque", "@s2_friction", "@viscous", "@winding"} <= {cell(block) for block in sheet.blocks}


def test_the_page_names_no_cell_that_no_drive_has():
    """A typing mistake in front_page.md would leave a row out in silence."""
    assert NAMED - {cell(block) for page in every_page() for block in page.blocks} == {REST}
