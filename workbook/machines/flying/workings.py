"""The workings of the Cutter sheet: the way from the entries to the motion, as S5 goes it."""

from engine.flying.cut import SAME_LENGTH
from engine.flying.tool import LONGER
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.entries.units import DEGREE, MM, shown
from workbook.machines.flying.check import LEAST_CV
from workbook.machines.flying.lengths import IS_DRUM
from workbook.machines.flying.view import Flying


def workings(sheet: Sheet, machine: Flying) -> None:
    """Declare the way from the entries to the motion, as S5 goes it."""
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(*geometry(machine), *of_the_law(machine), *superimposed(machine))


def geometry(machine: Flying) -> list[Quantity]:
    """Return angles and lengths in step with the line and of the re-positioning."""
    tool, mm, turn = machine.tool, shown(machine.scales.length, MM), 360.0
    lengths = (tool.design_length, tool.tool_length, tool.repositioning_length)
    pitch, sync, back = (shown(tool.angle(length), DEGREE) for length in lengths)
    return [
        calc("fly_v", "Line speed", "v_L", "m/s", "=fly_line/60", machine.line),
        calc("fly_r", "Travel of the tool a radian of its shaft", "R_t", "mm",
             f"=IF({IS_DRUM},fly_radius,fly_lead/(2*PI()))", shown(tool.radius, MM),
             source="the drum's radius; p/2π of a slide"),
        calc("fly_pitch", "Angle between the tools", "θ_0", "°",
             f"=IF({IS_DRUM},360/fly_tools,0)", pitch, scale=turn, source="S5: 2π/Z; 0 of a saw"),
        calc("fly_sync", "Angle in step with the line", "θ_T", "°",
             f"=IF({IS_DRUM},fly_angle,DEGREES(fly_saw/fly_r))", sync, scale=turn),
        calc("fly_back", "Angle of the re-positioning", "θ_R", "°",
             "=fly_pitch-fly_sync", back, scale=turn, source="S5: θ_0 − θ_T"),
        calc("fly_lt", "Tool length", "L_T", "mm",
             "=RADIANS(fly_sync)*fly_r", shown(tool.tool_length, MM), scale=mm, source="S5: θ_T R_t"),
        calc("fly_lr", "Length of the re-positioning", "L_R", "mm", "=fly_l0-fly_lt",
             shown(tool.repositioning_length, MM), scale=mm, source="S5: L_0 − L_T; a saw goes back by L_T"),
        calc("fly_j", "Inertia of the load at the shaft", "J_L", "kg m²",
             "=fly_inertia/10000+fly_mass*(fly_r/1000)^2", machine.load.inertia, source="J + m R_t²"),
    ]  # fmt: skip


def of_the_law(machine: Flying) -> list[Quantity]:
    """Return the law's number, its ends and its coefficients."""
    law, number = machine.law.coefficients, machine.number
    return [
        calc("fly_no", "Number of the law", "", "", "=MATCH(fly_law,law_code,0)", number, format="0"),
        calc("fly_ends", "Velocity of the law at its ends", "", "",
             "=MAX(ABS(INDEX(law_v0,fly_no)),ABS(INDEX(law_v1,fly_no)))",
             max(abs(machine.law.start.v), abs(machine.law.end.v)), scale=1.0, source="0: from rest to rest"),
        calc("fly_misses", "How far the law's end is from 1", "", "",
             "=ABS(INDEX(law_s1,fly_no)-1)", abs(machine.law.end.s - 1.0), scale=1.0),
        calc("fly_cv", "Coefficient of velocity", "C_v", "", "=INDEX(law_cv,fly_no)", law.cv),
        calc("fly_ca", "Coefficient of acceleration", "C_a", "",
             "=MAX(INDEX(law_ca_max,fly_no),0-INDEX(law_ca_min,fly_no))", law.ca),
        calc("fly_ca_rms", "Coefficient of RMS acceleration", "C_a,rms", "", "=INDEX(law_ca_rms,fly_no)", law.ca_rms),
    ]  # fmt: skip


def superimposed(machine: Flying) -> list[Quantity]:
    """Return the motion on top of the line's: its case, time and displacement, and where the drum waits."""
    cut, mm = machine.cut, shown(machine.scales.length, MM)
    return [
        calc("fly_row", "Case by product length", "", "",
             "=IF(fly_h=0,2,IF(fly_h>0,1,IF(fly_low<=fly_near*fly_v,4,3)))", machine.case,
             format="0", source="row of the cases above"),
        calc("fly_waits", "Whether the drum waits", "", "",
             f'=IF(AND({IS_DRUM},fly_beyond="standstill",fly_length>fly_limit),1,0)', float(cut.waits), format="0",
             source="at standstill for part of the cycle"),
        calc("fly_tm", "Time of the superimposed motion", "t_m", "s",
             "=IF(fly_waits=1,fly_cv/(fly_cv-1)*fly_lr/1000/fly_v,fly_tr)", cut.moving_time,
             source="t_R; with a wait, so that v_min = 0"),
        calc("fly_h1", "Displacement by the law", "h", "mm", "=IF(fly_waits=1,0-fly_v*1000*fly_tm/fly_cv,fly_h)",
             shown(cut.superimposed, MM), scale=mm, source="L_0 − L_p; with a wait, −v_L t_m/C_v"),
        calc("fly_peak", "Where the law is fastest", "ξ_v", "", "=INDEX([fastest.at],fly_no)", cut.fastest),
        calc("fly_stop", "When the drum comes to a standstill", "", "s",
             "=IF(fly_waits=1,fly_peak*fly_tm,fly_tr)", cut.wait[0], scale=cut.cycle_time, source="t_R: not at all"),
        constant("fly_near", "Equality tolerance", "ε", "",
                 SAME_LENGTH, format="0E+00", source="of a length, a speed, a share of the law"),
        constant("fly_longer", "Shortest product, in tool lengths", "", "", LONGER, format="0.000"),
        constant("fly_least_cv", "Least coefficient of velocity", "", "",
                 LEAST_CV, format="0.000", source="with less, no drum comes to a standstill"),
    ]  # fmt: skip
