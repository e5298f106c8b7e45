"""Every pair of motor and reducer on the Selection sheet, and the best of them in order (S5, steps 5 to 7)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbook.book.declare import Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.entries.units import KG_CM2, shown
from workbook.selection.products import BLANK, FINE, SMALL, WHOLE
from workbook.selection.view import Choosing

BEST = 10  # rows of the ranking


def ranking(sheet: Sheet, view: Choosing) -> None:
    """Declare the best pairs, in order."""
    found = view.ranking
    m, r = found.motor[:BEST], found.reducer[:BEST]
    motor_names = [view.motors.names[i] for i in m]
    reducer_names = [view.reducers.names[j] for j in r]
    sheet.row += 1
    sheet.table(
        "ranking", "The best pairs (S5, step 6)", BEST,
        result("motor", "motor", "", "",
               '=IF([at]>0,INDEX([motors.name],INDEX([pairs.m],[at])),"–")',
               filled(motor_names, BEST, "–"), align="left"),
        constant("place", "place", "", "", list(range(1, BEST + 1))),
        calc("at", "row among the pairs", "", "",
             "=IF([place]<=sel_count,MATCH(SMALL([pairs.order],[place]),[pairs.order],0),0)",
             filled(view.row(found)[:BEST], BEST, 0), format=WHOLE),
        calc("i", "reduction", "i", "",
             "=IF([at]>0,INDEX([reducers.i],INDEX([pairs.r],[at])),0)",
             filled(view.reducers.reduction[r], BEST), format=BLANK),
        result("rms", "RMS torque", "T_rms", "Nm",
               "=IF([at]>0,INDEX([pairs.rms],[at]),0)",
               filled(found.rms_torque[:BEST], BEST), format=BLANK),
        result("margin", "margin", "", "",
               "=IF([at]>0,INDEX([motors.rated],INDEX([pairs.m],[at]))/[rms],0)",
               filled(found.margin[:BEST], BEST), format=BLANK),
        result("match", "off the best ratio by", "", "",
               ("=IF([at]>0,EXP(ABS(LN(INDEX([reducers.match],INDEX([pairs.r],MAX([at],1)))"
                "/INDEX([pairs.total],MAX([at],1))))/2),0)"),
               filled(found.mismatch[:BEST], BEST), format=BLANK),
        calc("score", "score, the lowest best", "", "",
             "=IF([at]>0,INDEX([pairs.score],[at]),0)",
             filled(found.score[:BEST], BEST), format=FINE),
        result("reducer", "reducer", "", "",
               '=IF([at]>0,INDEX([reducers.name],INDEX([pairs.r],[at])),"–")',
               filled(reducer_names, BEST, "–"), align="left"),
        blank="[at]=0",
    )  # fmt: skip


def pairs(sheet: Sheet, view: Choosing) -> None:
    """Declare every pair: RMS torque with the reducer's η and inertia, whether it is usable, what it is sorted by."""
    motor, reducer = (places.ravel() for places in np.indices(view.rooms))
    moving = np.full(view.inertia.shape, view.task.moves)
    ranked = spread(view, view.ranked.astype(int))
    keys = [key if counts else "–" for key, counts in zip(spread(view, view.keys), ranked, strict=True)]
    sheet.heading("Every pair")
    sheet.table(
        "pairs", "Pairs in the order of the tables", len(motor),
        constant("k", "pair", "", "", list(range(1, len(motor) + 1))),
        constant("m", "motor", "", "", (motor + 1).tolist()),
        constant("r", "reducer", "", "", (reducer + 1).tolist()),
        calc("total", "inertia", "J", "kg cm²",
             ("=IF(INDEX([motors.on],[m])*INDEX([reducers.on],[r])*sel_moves=1,"
              "INDEX([motors.inertia],[m])+INDEX([reducers.inertia],[r]),0)"),
             spread(view, np.where(moving, shown(view.inertia, KG_CM2), 0.0)), source="J_M + J_T", format=SMALL),
        result("rms", "RMS torque", "T_rms", "Nm",
               ("=IF([total]>0,SQRT(MAX(0,INDEX([reducers.load],[r])^2+([total]/10000*INDEX([reducers.acc],[r]))^2"
                "+[total]/10000*INDEX([reducers.cross],[r]))),0)"),
               spread(view, np.where(moving, view.rms, 0.0)),
               source="√((τ T*/η)² + (J ω̇/τ)² + 2 J (ω̇T*)/η)", format=BLANK),
        result("usable", "usable", "", "",
               ("=IF([total]*INDEX([reducers.fits],[r])>0,IF(AND([rms]<=INDEX([motors.rated],[m]),"
                "INDEX([reducers.speed],[r])<=INDEX([motors.nmax],[m])),1,0),0)"),
               spread(view, view.usable.astype(int)), source="torques and speeds", format=WHOLE),
        calc("counts", "ranked", "", "",
             "=[usable]*INDEX([motors.has],[m])*INDEX([reducers.has],[r])",
             ranked, source="has the figures", format=WHOLE),
        result("score", "score, the lowest best", "", "",
               ("=IF([counts]=1,CHOOSE(sel_no,[rms]/INDEX([motors.rated],[m]),"
                "EXP(ABS(LN(INDEX([reducers.match],[r])/[total]))/2),"
                "INDEX([motors.figure],[m])+INDEX([reducers.figure],[r]),"
                "INDEX([motors.figure],[m])+INDEX([reducers.figure],[r])),0)"),
               spread(view, view.scores), source="by the criterion", format=FINE),
        calc("order", "sorted by", "", "",
             '=IF([counts]=1,ROUND([score]/sel_unit*sel_parts,0)*sel_rows+[k],"–")',
             keys, source="score, then row", format="General"),
    )  # fmt: skip


def spread(view: Choosing, table: NDArray[Any]) -> list[Any]:
    """Return a figure of each pair as one column, 0 where a row of a table is spare."""
    whole = np.zeros(view.rooms, dtype=table.dtype)
    whole[: table.shape[0], : table.shape[1]] = table
    return list(whole.ravel().tolist())
