"""CODESYS SoftMotion in Structured Text: points of SMC_CAMXYVA, a table of pairs, switches of MC_CAMSWITCH_TR."""

from math import ceil, log2

import numpy as np

from workbook.controllers.table import Table
from workbook.controllers.target import Tappets, Target, Track, facts_of, tracks_of_rows
from workbook.controllers.texts import by_group, pairs, points, require_count

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
    times = list(zip(*(column.tolist() for column in by_group(text, SWITCHED)), strict=True))
    require_count(text, "NoOfSwitches", len(times))
    return tracks_of_rows(text, times)


TAPPETS = Tappets(**facts_of("codesys switches"), read=read_switches)
TARGETS = (
    Target(
        **facts_of("codesys"),
        read=lambda text: points(text, by_group(text, FIELDS), "nElements"),
        tappets=TAPPETS,
    ),
    Target(
        **facts_of("codesys-table"),
        read=lambda text: points(text, pairs(text, "Table := [", "]]"), "nElements"),
    ),
)
