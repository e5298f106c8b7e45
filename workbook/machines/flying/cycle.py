"""The Cycle sheet: tool, shaft and load over one cycle, from the end of one cut to the end of the next."""

from __future__ import annotations

import numpy as np

from workbook.book.declare import Book, calc, constant, result
from workbook.entries.units import MM, RPM
from workbook.laws import sampling
from workbook.laws.stack import CODES
from workbook.machines.flying.view import NEAR, Flying

PART = "=IF([t]>=fly_tr-fly_eps,3,IF(AND([t]>fly_stop+fly_eps,[t]<fly_stop+fly_wait-fly_eps),2,1))"


def cycle_sheet(book: Book, machine: Flying, pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    cut, at, t, s = machine.cut, machine.samples, machine.times, machine.scales
    near = cut.cycle_time * NEAR
    begin, end = cut.wait
    waited = np.clip(t - begin, 0.0, cut.waiting_time)
    xi = np.clip((t - waited) / cut.moving_time, 0.0, 1.0)
    waiting = (t > begin + near) & (t < end - near)
    part = np.where(t >= cut.repositioning_time - near, 3, np.where(waiting, 2, 1))
    number, r = CODES.index(machine.given.law) + 1, machine.tool.radius
    law = dict(zip("sva", machine.law.evaluate(xi), strict=False))
    torque = machine.load.torque + machine.load.inertia * at.acceleration / r
    sheet.row += 1
    sheet.table(
        "cycle", f"Tool, shaft and load at {len(t) - 1} equal steps", len(t),
        calc("t", "time", "t", "s", "=[k]*fly_tc/[cycle.k.last]", t, format="0.0000", scale=cut.cycle_time),
        result("s", "position of the tool", "s", "mm",
               "=(fly_v*([t]-[waited]))*1000+fly_h1*[sl]", at.position / MM, scale=s["mm"],
               source="v_L (t − t_waited) + h s"),
        result("v", "its speed", "v", "m/s",
               "=CHOOSE([part],fly_v+fly_h1/1000/fly_tm*[vl],0,fly_v)", at.speed, scale=s["v"], source="v_L + h v/t_m"),
        result("a", "its acceleration", "a", "m/s²",
               "=IF([part]=1,fly_h1/1000/fly_tm^2*[al],0)", at.acceleration, scale=s["a"], source="h a/t_m²"),
        result("n", "speed of the shaft", "n", "rpm", "=[w]*60/(2*PI())", at.speed / r / RPM, scale=s["w"] / RPM),
        result("w", "speed of the shaft", "ω_L", "rad/s",
               "=[v]*1000/fly_r", at.speed / r, scale=s["w"], source="v/R_t"),
        result("dw", "its acceleration", "ω̇_L", "rad/s²",
               "=[a]*1000/fly_r", at.acceleration / r, scale=s["dw"], source="a/R_t"),
        result("torque", "generalized load torque", "T*_L", "Nm",
               "=fly_torque+fly_j*[dw]", torque, scale=s["torque"], source="T_L + J_L ω̇_L"),
        result("angle", "angle of the shaft", "θ", "°",
               "=DEGREES([s]/fly_r)", np.degrees(at.position / r), scale=float(np.degrees(s["mm"] * MM / r)),
               source="s/R_t"),
        calc("product", "position of the product", "", "mm",
             "=fly_v*[t]*1000", machine.line * t / MM, scale=s["mm"], source="v_L t"),
        calc("line", "line speed", "v_L", "m/s", "=fly_v", machine.line),
        constant("k", "sample", "k", "", list(range(len(t)))),
        calc("part", "part of the cycle", "", "", PART, part, format="0", source="1 moves, 2 waits, 3 works"),
        calc("waited", "has waited", "", "s", "=MIN(fly_wait,MAX(0,[t]-fly_stop))", waited, scale=cut.cycle_time),
        calc("xi", "abscissa of the law", "ξ", "", "=MIN(1,([t]-[waited])/fly_tm)", xi, source="(t − t_waited)/t_m"),
        *sampling.finding("fly_no", "xi", pieces.locate(number, xi), "l"),
        *sampling.columns(law, "sva", "l"),
    )  # fmt: skip
