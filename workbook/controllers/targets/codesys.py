"""CODESYS SoftMotion in Structured Text: points of SMC_CAMXYVA, a table of pairs, switches of MC_CAMSWITCH_TR."""

from math import ceil, log2

import numpy as np

from workbook.controllers.table import LOCAL, SPLINES, Table
from workbook.controllers.target import Tappets, Target, Track, by_template, tracks_of_rows
from workbook.controllers.texts import grouped, pairs, points, require_count

FIELDS = ("dX", "dY", "dV", "dA")
EDGES = ("fEditorMaster", "fEditorSlave", "fTableMaster", "fTableSlave")
LIMITS = [f"{edge}{which}" for edge in EDGES for which in ("Min", "Max")]
SWITCHED = ("TrackNumber", "FirstOnPosition", "LastOnPosition")


def ends(table: Table) -> list[float]:
    """Return ends that REAL holds exactly, of x and y, alike for editor and table: nothing is scaled."""
    reached = [
        (places.min(), 2.0 ** ceil(log2(max(1.0, float(np.abs(places).max()))))) for places in (table.x, table.y)
    ]
    return [end for low, reach in reached for end in (-reach if low < 0.0 else 0.0, reach)] * 2


def read_switches(text: str) -> list[Track]:
    """Return the tracks of a Structured Text."""
    times = list(zip(*(column.tolist() for column in grouped(text, SWITCHED)), strict=True))
    require_count(text, "NoOfSwitches", len(times))
    return tracks_of_rows(text, times)


TAPPETS = Tappets(
    "codesys switches",
    "MC_CAMSWITCH_TR for MC_DigitalCamSwitch",
    by_template("codesys-switches.st"),
    read_switches,
    tracks=32,
)

TARGETS = (
    Target("codesys", "CODESYS SoftMotion, SMC_CAMXYVA in Structured Text", ".st", ("x", "y", "y'", "y''"),
           ("quintics",), by_template("codesys.st"), lambda text: points(text, grouped(text, FIELDS), "nElements"),
           points=(2, 32_767), tappets=TAPPETS),
    Target("codesys-table", "CODESYS SoftMotion, table of pairs, cubic, in Structured Text", ".st", ("x", "y"),
           (*SPLINES, LOCAL), by_template("codesys-table.st", limits=LIMITS, ends=ends),
           lambda text: points(text, pairs(text, "Table := [", "]]"), "nElements"),
           points=(4, 32_767)),
)  # fmt: skip
