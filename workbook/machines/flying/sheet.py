"""The Cutter sheet: what to enter, lengths and times, what the tool's shaft must do, charts and workings."""

from collections.abc import Sequence

from engine.flying.cut import LONGER, SAME_LENGTH
from engine.laws import Dwell
from engine.laws.points import fastest
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, entries_of, result
from workbook.book.sentence import amount
from workbook.fields.units import DEGREE, MM, PER_MINUTE, RPM, shown, si
from workbook.law_sheets.library import NamedLaw
from workbook.machines.flying.lengths import IS_DRUM, cases, waits
from workbook.machines.flying.view import LEAST_CV, CutterView, does
from workbook.motion.pieces import ROOM
from workbook.motion.requirements import ABOUT as CONTINUOUS
from workbook.motion.smooth import Joints

WAITS = waits("fly_length", "fly_beyond")
BELOW_CHARTS = 60  # the row from which the sheet is free in its whole width


def cutter_sheet(book: Book, machine: CutterView, joints: Joints, stroke: float, laws: Sequence[NamedLaw]) -> None:
    """Declare the sheet; ``stroke`` (m) is the tool's by the points of its drive."""
    sheet = book.sheet("Cutter", "The tool works at line speed, and makes up for the product's length in between.")
    entries(sheet, machine)
    sheet.heading("Results")
    cycle(sheet, machine)
    kinematics(sheet, machine, stroke)
    sheet.row += 1
    verdicts(sheet, machine, joints, stroke)
    charts(sheet)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    cases(sheet, machine)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(*geometry(machine), *superimposed(machine))
    sheet.row += 1
    sheet.table(
        "fastest", "Where each law is fastest: there a drum that slows down is slowest, and waits if it has to",
        len(laws),
        calc("law", "law", "", "", [f"=INDEX(law_code,{one.number})" for one in laws], [one.name for one in laws]),
        calc("at", "abscissa", "ξ_v", "", [one.own(one.page.fastest) for one in laws],
             [0.0 if isinstance(one.law, Dwell) else fastest(one.law) for one in laws]),
    )  # fmt: skip
    sheet.print_columns = 24


def entries(sheet: Sheet, machine: CutterView) -> None:
    """Declare what the engineer enters."""
    entry = entries_of(machine.given, "cutter")
    sheet.heading("Enter", "Product and line, the kind of machine with its own entries, load and limits of its shaft.")
    sheet.rows(
        entry("fly_length", "Product length", "L_p", "mm", "product_length", "one product a cycle"),
        entry("fly_line", "Line speed", "v_L", "m/min", "line_speed"),
        entry("fly_law", "Law of the superimposed motion", "", "", "law", "of those on the sheet Laws",
              choices="=law_code", align="center"),
        entry("fly_smooth", "What must be continuous", "", "", "smoothness", CONTINUOUS, align="center"),
        entry("fly_kind", "Kind of machine", "", "", "kind", "its tools go round, or its slide comes back",
              align="center"),
        entry("fly_tools", "Drum: number of tools", "Z", "", "drum.tools", format="0"),
        entry("fly_radius", "Drum: radius to the tool's edge", "R_t", "mm", "drum.radius"),
        entry("fly_angle", "Drum: angle in step with the line", "θ_T", "°", "drum.tool_angle", "synchronous angle"),
        entry("fly_beyond", "Drum: products longer than L_p,lim", "", "", "beyond",
              "it waits at standstill, or turns back", align="center"),
        entry("fly_saw", "Saw: length in step with the line", "L_T", "mm", "saw.tool_length"),
        entry("fly_lead", "Saw: travel of the slide a turn", "p", "mm", "saw.lead",
              "lead of the screw, or 2π times the pinion's radius"),
        entry("fly_room", "Saw: stroke that the slide has", "", "mm", "saw.stroke"),
        entry("fly_inertia", "Inertia at the shaft", "J", "kg cm²", "load.inertia", format="0.0#####"),
        entry("fly_mass", "Mass that moves with the tool", "m", "kg", "load.mass",
              "slide of a saw; jaws at the radius R_t"),
        entry("fly_torque", "Load torque against the line", "T_L", "Nm", "load.torque",
              "all the time; S5 neglects it beside the inertia"),
        entry("fly_rpm_max", "Largest speed of the shaft", "", "rpm", "limits.speed"),
        entry("fly_dw_max", "Largest acceleration of the shaft", "", "rad/s²", "limits.acceleration"),
    )  # fmt: skip


def cycle(sheet: Sheet, machine: CutterView) -> None:
    """Declare the case and the cycle's times and lengths."""
    cut, tool = machine.cut, machine.tool
    sheet.rows(
        result("fly_rate", "Products", "", "1/min", "=60/fly_tc", shown(cut.rate, PER_MINUTE)),
        result("fly_case", "The tool re-positions", "", "", '=IF(fly_h=0,"in step",IF(fly_h>0,"faster","slower"))',
               ("faster", "in step", "slower", "slower")[machine.case - 1],
               "faster or slower than the line, by the sign of h", align="center"),
        result("fly_does", "While it does, it", "", "",
               f'=IF({WAITS},"waits",IF(fly_low<0-fly_near*fly_v,"reverses","keeps moving"))', does(cut),
               "keeps moving, waits at standstill, or reverses", align="center"),
        result("fly_h", "Dynamic displacement", "h", "mm",
               "=IF(ABS(fly_l0-fly_length)<=fly_near*fly_l0,0,fly_l0-fly_length)", shown(cut.displacement, MM),
               "S5: h = L_0 − L_p; 0 of a product as long as L_0"),
        result("fly_l0", "Design length", "L_0", "mm", "=RADIANS(fly_pitch)*fly_r", shown(tool.design_length, MM),
               "S5: θ_0 R_t; a saw has none"),
        result("fly_limit", "Longest product without standstill", "L_p,lim", "mm",
               f"=IF({IS_DRUM},(fly_cv*fly_l0-fly_lt)/(fly_cv-1),0)", machine.limit,
               "S5: (C_v L_0 − L_T)/(C_v − 1); 0: a saw always reverses"),
        result("fly_tc", "Cycle time", "t_C", "s", "=fly_length/1000/fly_v", cut.cycle_time, "S5, eq. (4): L_p/v_L"),
        result("fly_tt", "of it at work", "t_T", "s", "=fly_lt/1000/fly_v", cut.tool_time, "S5: L_T/v_L"),
        result("fly_tr", "for re-positioning", "t_R", "s",
               "=(fly_length-fly_lt)/1000/fly_v", cut.repositioning_time, "S5: t_C − t_T"),
        result("fly_wait", "of that at standstill", "t_W", "s", "=fly_tr-fly_tm", cut.waiting_time),
    )  # fmt: skip


def kinematics(sheet: Sheet, machine: CutterView, stroke: float) -> None:
    """Declare speeds, accelerations and travel, and what the motor and its reducer are chosen by."""
    cut, (low, high), task = machine.cut, machine.cut.speed_range, machine.task(machine.cut)
    slowest, fastest = (shown(v / machine.tool.radius, RPM) for v in cut.speed_range)
    per, limits = "*1000/fly_r", machine.given.limits
    line_max = cut.fastest_line(si(limits.speed, RPM), limits.acceleration)
    sheet.rows(
        result("fly_dv", "Change of the tool's speed", "Δv_max", "m/s",
               "=fly_cv*fly_h1/1000/fly_tm", cut.speed_change, "S5, eq. (10): C_v h/t_R"),
        result("fly_domega", "of its shaft", "Δω_max", "rad/s", f"=fly_dv{per}", cut.speed_change / machine.tool.radius,
               "S5, eq. (11): Δv_max/R_t"),
        result("fly_low", "Lowest speed of the tool", "v_min", "m/s",
               "=MIN(fly_v,fly_v+fly_dv)", low, "below 0: against the line"),
        result("fly_high", "Highest speed of the tool", "v_max", "m/s", "=MAX(fly_v,fly_v+fly_dv)", high),
        result("fly_rpm_low", "Lowest speed of the shaft", "n_min", "rpm", f"=fly_low{per}*60/(2*PI())", slowest),
        result("fly_rpm_high", "Highest speed of the shaft", "n_max", "rpm", f"=fly_high{per}*60/(2*PI())", fastest),
        result("fly_a", "Peak acceleration of the tool", "a_max", "m/s²", "=fly_ca*ABS(fly_h1)/1000/fly_tm^2",
               cut.max_acceleration, "S5: C_a h/t_R²"),
        result("fly_dw", "of its shaft", "ω̇_max", "rad/s²", f"=fly_a{per}", cut.max_angular_acceleration,
               "S5, eq. (12): a_max/R_t"),
        result("fly_a_rms", "RMS acceleration of the tool", "a_rms", "m/s²",
               "=fly_ca_rms*ABS(fly_h1)/1000/fly_tm^2*SQRT(fly_tm/fly_tc)", cut.rms_acceleration,
               "S5: C_a,rms h/t_R² √(t_R/t_C), over the cycle"),
        result("fly_dw_rms", "of its shaft", "ω̇_rms", "rad/s²", f"=fly_a_rms{per}", cut.rms_angular_acceleration,
               "S5, eq. (13): a_rms/R_t"),
        result("fly_stroke", "Stroke of the tool in a cycle", "", "mm",
               "=(MAX([drive_pt.y])-MIN([drive_pt.y]))*1000", shown(stroke, MM),
               "furthest less nearest: travel of a saw's slide"),
        result("fly_line_max", "Highest line speed within the limits", "v_L", "m/min",
               "=fly_line*IF(fly_dw>0,MIN(fly_rpm_max/fly_n,SQRT(fly_dw_max/fly_dw)),fly_rpm_max/fly_n)",
               shown(line_max, PER_MINUTE), "speed grows with v_L, acceleration with v_L²"),
        result("fly_w_max", "Highest speed of the shaft, either way", "ω_L,max", "rad/s",
               "=MAX(ABS(fly_low),ABS(fly_high))*1000/fly_r", cut.max_angular_speed),
        result("fly_n", "in revolutions", "n_L,max", "rpm",
               "=fly_w_max*60/(2*PI())", shown(cut.max_angular_speed, RPM)),
        result("fly_torque_rms", "RMS of the generalized load torque", "T*_L,rms", "Nm",
               "=SQRT(fly_torque^2+(fly_j*fly_dw_rms)^2)", task.torque_rms,
               "S5: T*_L = T_L + J_L ω̇_L; the mean of ω̇_L is 0"),
        result("fly_mean", "Mean of acceleration times torque", "(ω̇ T*)_mean", "W/s",
               "=fly_j*fly_dw_rms^2", task.power_rate_mean, "T_L drops out over a cycle"),
        result("fly_beta", "Load factor", "β", "W/s", "=2*(fly_dw_rms*fly_torque_rms+fly_mean)", task.load_factor,
               "S5, eq. (15); 4 J_L ω̇²_rms without T_L (17), (19)"),
    )  # fmt: skip


def verdicts(sheet: Sheet, machine: CutterView, joints: Joints, by_points: float) -> None:
    """Declare the checks."""
    cut, limits = machine.cut, machine.given.limits
    fastest, hardest = shown(cut.max_angular_speed, RPM), cut.max_angular_acceleration
    stroke = 0.0 if machine.is_drum else shown(by_points, MM)
    near = "*(1+check_zero)"
    law = (
        "AND(INDEX(law_wrong,fly_no)<check_zero,INDEX(law_v_low,fly_no)>=0-check_zero,"
        "MAX(fly_ends,fly_misses)<check_zero,fly_cv>=fly_least_cv)"
    )
    sheet.checks(
        check("fly_ok_speed", "The shaft's speed is allowed", f"fly_n<=fly_rpm_max{near}", fastest <= limits.speed,
              says=amount("fly_n-fly_rpm_max", fastest - limits.speed, "", " rpm too much")),
        check("fly_ok_acceleration", "The shaft's acceleration is allowed", f"fly_dw<=fly_dw_max{near}",
              hardest <= limits.acceleration,
              says=amount("fly_dw-fly_dw_max", hardest - limits.acceleration, "", " rad/s² too much")),
        check("fly_ok_stroke", "The slide has the stroke that the saw needs",
              f"OR({IS_DRUM},fly_stroke<=fly_room{near})", machine.is_drum or stroke <= machine.given.saw.stroke,
              "a drum needs none",
              says=amount("fly_stroke-fly_room", stroke - machine.given.saw.stroke, "", " mm too much")),
        joints.check("fly_ok_smooth", "The tool moves as smoothly as asked"),
        check("fly_ok_length", "The products leave time to re-position",
              "MIN(fly_length,fly_short)>=fly_lt*fly_longer*(1-check_zero)", True, "L_p > L_T", ":length",
              '"a product of "&ROUND(IF(fly_length<fly_lt*fly_longer,fly_length,fly_short),9)'
              '&" mm; expected at least "&ROUND(fly_lt*fly_longer,9)&" mm"'),
        check("fly_ok_tools", "A drum has whole tools", f"OR(NOT({IS_DRUM}),fly_tools=INT(fly_tools))", True, "",
              "cutter:whole", 'ROUND(fly_tools,9)&" tools; expected a whole number"'),
        check("fly_ok_load", "The shaft has something to move", "OR(fly_inertia>0,fly_mass>0)", True, "",
              "cutter.load:heavy", '"inertia and mass are 0; expected one of them above"'),
        check("fly_ok_range", "The range of product lengths rises", "fly_long>fly_short", True, "",
              "cutter.lengths:ordered",
              '"from "&ROUND(fly_short,9)&" mm to "&ROUND(fly_long,9)&" mm; expected a longest above the shortest"'),
        check("fly_ok_pieces", "The table of pieces has room for all", "fly_pieces<=MAX([tool_pieces.r])", True, ROOM,
              says='fly_pieces&" pieces, and room for "&MAX([tool_pieces.r])'),
        check("fly_ok_angle", "The angle in step is less than between the tools",
              f"OR(NOT({IS_DRUM}),fly_angle*fly_tools<360)", True, "θ_T < θ_0", "cutter:angle",
              'ROUND(fly_tools,9)&" tools in step over "&ROUND(fly_angle,9)&"° each take more than 360°"'),
        check("fly_ok_law", "The law speeds up once and slows down once", law, True,
              "from rest to rest; S5, 'Motion law parameters'", ":law",
              '"the law "&fly_law&" does not: see its sheet, or Laws"'),
    )  # fmt: skip


def geometry(machine: CutterView) -> list[Quantity]:
    """Return angles and lengths in step with the line and of the re-positioning, and what the law is by figures."""
    tool, law = machine.tool, machine.law.coefficients
    lengths = (tool.design_length, tool.tool_length, tool.repositioning_length)
    pitch, sync, back = (shown(tool.angle(length), DEGREE) for length in lengths)
    return [
        calc("fly_v", "Line speed", "v_L", "m/s", "=fly_line/60", machine.line),
        calc("fly_r", "Travel of the tool a radian of its shaft", "R_t", "mm",
             f"=IF({IS_DRUM},fly_radius,fly_lead/(2*PI()))", shown(tool.radius, MM),
             "the drum's radius; p/2π of a slide"),
        calc("fly_pitch", "Angle between the tools", "θ_0", "°",
             f"=IF({IS_DRUM},360/fly_tools,0)", pitch, "S5: 2π/Z; 0 of a saw"),
        calc("fly_sync", "Angle in step with the line", "θ_T", "°",
             f"=IF({IS_DRUM},fly_angle,DEGREES(fly_saw/fly_r))", sync),
        calc("fly_back", "Angle of the re-positioning", "θ_R", "°", "=fly_pitch-fly_sync", back, "S5: θ_0 − θ_T"),
        calc("fly_lt", "Tool length", "L_T", "mm",
             "=RADIANS(fly_sync)*fly_r", shown(tool.tool_length, MM), "S5: θ_T R_t"),
        calc("fly_lr", "Length of the re-positioning", "L_R", "mm", "=fly_l0-fly_lt",
             shown(tool.repositioning_length, MM), "S5: L_0 − L_T; a saw goes back by L_T"),
        calc("fly_j", "Inertia of the load at the shaft", "J_L", "kg m²",
             "=fly_inertia/10000+fly_mass*(fly_r/1000)^2", machine.load.inertia, "J + m R_t²"),
        calc("fly_no", "Number of the law", "", "", "=MATCH(fly_law,law_code,0)", machine.number, format="0"),
        calc("fly_ends", "Velocity of the law at its ends", "", "",
             "=MAX(ABS(INDEX(law_v0,fly_no)),ABS(INDEX(law_v1,fly_no)))",
             max(abs(machine.law.start.v), abs(machine.law.end.v)), "0: from rest to rest", scale=1.0),
        calc("fly_misses", "How far the law's end is from 1", "", "",
             "=ABS(INDEX(law_s1,fly_no)-1)", abs(machine.law.end.s - 1.0), scale=1.0),
        calc("fly_cv", "Coefficient of velocity", "C_v", "", "=INDEX(law_cv,fly_no)", law.cv),
        calc("fly_ca", "Coefficient of acceleration", "C_a", "",
             "=MAX(INDEX(law_ca_max,fly_no),0-INDEX(law_ca_min,fly_no))", law.ca),
        calc("fly_ca_rms", "Coefficient of RMS acceleration", "C_a,rms", "", "=INDEX(law_ca_rms,fly_no)", law.ca_rms),
    ]  # fmt: skip


def superimposed(machine: CutterView) -> list[Quantity]:
    """Return the motion on top of the line's: its case, time and displacement, and where the drum waits."""
    cut = machine.cut
    return [
        calc("fly_row", "Case by product length", "", "",
             "=IF(fly_h=0,2,IF(fly_h>0,1,IF(fly_low<=fly_near*fly_v,4,3)))", machine.case, "row of the cases above",
             format="0"),
        calc("fly_waits", "Whether the drum waits", "", "",
             f"=IF({WAITS},1,0)", float(cut.waits), "at standstill for part of the cycle", format="0"),
        calc("fly_tm", "Time of the superimposed motion", "t_m", "s",
             "=IF(fly_waits=1,fly_cv/(fly_cv-1)*fly_lr/1000/fly_v,fly_tr)", cut.moving_time,
             "t_R; with a wait, so that v_min = 0"),
        calc("fly_h1", "Displacement by the law", "h", "mm", "=IF(fly_waits=1,0-fly_v*1000*fly_tm/fly_cv,fly_h)",
             shown(cut.superimposed, MM), "L_0 − L_p; with a wait, −v_L t_m/C_v"),
        calc("fly_peak", "Where the law is fastest", "ξ_v", "", "=INDEX([fastest.at],fly_no)", cut.fastest),
        calc("fly_stop", "When the drum comes to a standstill", "", "s",
             "=IF(fly_waits=1,fly_peak*fly_tm,fly_tr)", cut.wait[0], "t_R: not at all"),
        constant("fly_near", "Equality tolerance", "ε", "",
                 SAME_LENGTH, "of a length, a speed, a share of the law", format="0E+00"),
        constant("fly_longer", "Shortest product, in tool lengths", "", "", LONGER, format="0.000"),
        constant("fly_least_cv", "Least coefficient of velocity", "", "",
                 LEAST_CV, "with less, no drum comes to a standstill", format="0.000"),
    ]  # fmt: skip


def charts(sheet: Sheet) -> None:
    """Place the tool's motion, and right of it the load of its shaft, beside what is entered and what comes out."""
    time, length = "time t [s]", "product length L_p [mm]"

    def chart(column: int, row: int, title: str, x: str, y: str, about: str, *lines: tuple[str, str, str]) -> None:
        drawn = tuple(Series(name, f"[{t}]", f"[{f}]", dashed=k > 0) for k, (name, t, f) in enumerate(lines))
        sheet.chart(Chart(title, x, y, drawn, about), column=column, row=row, width=7, height=18)

    chart(11, 5, "Speed of the tool over a cycle", time, "speed [m/s]",
          "Speed of the tool over one cycle, with the line speed that it works at", ("tool", "cycle.t", "cycle.v"),
          ("line", "cycle.t", "cycle.line"))  # fmt: skip
    chart(11, 24, "Position of the tool and of the product", time, "position [mm]",
          "Position of the tool along its path over one cycle, with the product's", ("tool", "cycle.t", "cycle.s"),
          ("product", "cycle.t", "cycle.product"))  # fmt: skip
    chart(11, 43, "Acceleration of the tool over a cycle", time, "acceleration [m/s²]",
          "Acceleration of the tool over one cycle", ("tool", "cycle.t", "cycle.a"))  # fmt: skip
    chart(18, 5, "Generalized load torque at the shaft", time, "T*_L [Nm]",
          "Load torque and inertia torque at the tool's shaft over one cycle",
          ("T*_L = T_L + J_L ω̇_L", "cycle.t", "cycle.torque"))  # fmt: skip
    chart(18, 24, "Torque against speed of the shaft", "n [rpm]", "T*_L [Nm]",
          "Generalized load torque against the speed of the tool's shaft over one cycle",
          ("one cycle", "cycle.n", "cycle.torque"))  # fmt: skip
    chart(18, 43, "Load factor against product length", length, "β [W/s]",
          "Load factor over the product length at this line speed, with the product entered marked",
          ("load factor", "lengths.length", "lengths.beta"),
          ("product entered", "length_line.x", "length_line.beta"))  # fmt: skip
