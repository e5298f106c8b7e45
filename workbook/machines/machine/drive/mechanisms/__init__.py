"""Each kind of mechanism on the sheet of a drive: entries, sizes, and its ratio at a position."""

from workbook.machines.machine.drive.mechanisms.slides import CRANK_SLIDER, ROCKER
from workbook.machines.machine.drive.mechanisms.table import TABLE

LINKAGES = {"crank-slider": CRANK_SLIDER, "rocker": ROCKER, "table": TABLE}
"""the pages of mechanisms whose ratio depends on the position"""
