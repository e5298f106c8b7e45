"""The Cycle sheet: tool, shaft and load over one cycle, from the end of one cut to the end of the next."""

from __future__ import annotations

from workbook.book.declare import Book, calc, constant, result
from workbook.entries.units import DEGREE, MM, RPM, shown
from workbook.laws import sampling
from workbook.machines.flying.view import Flying

PART = "=IF([t]>=fly_tr-fly_eps,3,IF(AND([t]>fly_stop+fly_eps,[t]<fly_stop+fly_wait-fly_eps),2,1))"


def cycle_sheet(book: Book, machine: Flying, pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    cut, at, shaft, t, scale = machine.cut, machine.samples, machine.shaft, machine.times, machine.scales
    part, waited, xi = cut.state(t)
    number, mm = pieces.number(machine.law), shown(scale.length, MM)
    law = dict(zip("sva", machine.law.evaluate(xi), strict=False))
    sheet.row += 1
    sheet.table(
        "cycle", f"Tool, shaft and load at {len(t) - 1} equal steps", len(t),
        calc("t", "time", "t", "s", "=[k]*fly_tc/[cycle.k.last]", t, format="0.0000", scale=cut.cycle_time),
        result("s", "position of the tool", "s", "mm",
               "=(fly_v*([t]-[waited]))*1000+fly_h1*[sl]", shown(at.position, MM), scale=mm,
               source="v_L (t − t_waited) + h s"),
        result("v", "its speed", "v", "m/s",
               "=CHOOSE([part],fly_v+fly_h1/1000/fly_tm*[vl],0,fly_v)", at.speed, scale=scale.speed,
               source="v_L + h v/t_m"),
        result("a", "its acceleration", "a", "m/s²",
               "=IF([part]=1,fly_h1/1000/fly_tm^2*[al],0)", at.acceleration, scale=scale.acceleration,
               source="h a/t_m²"),
        result("n", "speed of the shaft", "n", "rpm",
               "=[w]*60/(2*PI())", shown(shaft.speed, RPM), scale=shown(scale.angular_speed, RPM)),
        result("w", "speed of the shaft", "ω_L", "rad/s",
               "=[v]*1000/fly_r", shaft.speed, scale=scale.angular_speed, source="v/R_t"),
        result("dw", "its acceleration", "ω̇_L", "rad/s²",
               "=[a]*1000/fly_r", shaft.acceleration, scale=scale.angular_acceleration, source="a/R_t"),
        result("torque", "generalized load torque", "T*_L", "Nm",
               "=fly_torque+fly_j*[dw]", machine.torque, scale=scale.torque, source="T_L + J_L ω̇_L"),
        result("angle", "angle of the shaft", "θ", "°",
               "=DEGREES([s]/fly_r)", shown(shaft.angle, DEGREE), scale=shown(scale.angle, DEGREE),
               source="s/R_t"),
        calc("product", "position of the product", "", "mm",
             "=fly_v*[t]*1000", shown(cut.product_position(t), MM), scale=mm, source="v_L t"),
        calc("line", "line speed", "v_L", "m/s", "=fly_v", machine.line),
        constant("k", "sample", "k", "", list(range(len(t)))),
        calc("part", "part of the cycle", "", "", PART, part, format="0", source="1 moves, 2 waits, 3 works"),
        calc("waited", "has waited", "", "s", "=MIN(fly_wait,MAX(0,[t]-fly_stop))", waited, scale=cut.cycle_time),
        calc("xi", "abscissa of the law", "ξ", "", "=MIN(1,([t]-[waited])/fly_tm)", xi, source="(t − t_waited)/t_m"),
        *pieces.finding("fly_no", "xi", pieces.locate(number, xi), "l"),
        *pieces.columns(law, "sva", "l"),
    )  # fmt: skip
