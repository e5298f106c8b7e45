"""The layout of a machine's book by the defined names of a file: its axes, mechanisms, clearances and switches."""

from workbook.machines.machine.entries_beside import (
    FreePosition,
)

MARKS = {"mm": "mm", "°": "deg"}
CHOSEN = "sel_axis"
"""the name of the cell with the axis that the sheet Selection is for; a file with that name has the sheet"""


COMPARED = "timing_compared"
"""the name of the cell with the rate to compare at; a file with that name has columns of extremes there"""
clearance_name = "clear{}_{}_{}".format
"""names the cell of a clearance by its number and those of its axes, which a file has by it"""
pairs_name = "clear{}_pairs_used".format
"""names the cell that counts the pairs of a clearance's table: by it a file says that it has pairs"""
SOME_PAIRS = [FreePosition(at=0.0, free=0.0), FreePosition(at=1.0, free=0.0)]
switch_name = "switch{}_name".format
"""names the cell that tells what a switch is called: by it a file tells how many there are"""


def unit_name(number: int, unit: str) -> str:
    """Return the name of the cell with the unit of an axis; from the name alone a file's layout is known."""
    return f"axis{number}_{MARKS[unit]}"


def kind_name(number: int, kind: str) -> str:
    """Return the name of the cell with the mechanism of an axis; from the name alone a file's layout is known."""
    return f"drive{number}_{kind.replace(' ', '_').replace('-', '_')}"


def stop_name(number: int, end: str) -> str:
    """Return the name of the cell with the lower (``low``) or the upper stop (``high``) of an axis."""
    return f"axis{number}_stop_{end}"


def stage_name(number: int, stage: int) -> str:
    """Return the name of the cell with the ratio of a stage, from 0, of an axis; a file tells so how many it has."""
    return f"drive{number}_s{stage + 1}_ratio"
