"""The Cutter sheet: what to enter, lengths and times, what the tool's shaft must do, charts and workings."""

from collections.abc import Sequence

from engine.flying.cut import Beyond
from engine.laws import Dwell
from engine.laws.points import fastest
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.book.sentence import amount
from workbook.entries.units import MM, PER_MINUTE, RPM, shown, si
from workbook.laws.library import NamedLaw
from workbook.machines.flying.lengths import IS_DRUM, lengths_columns
from workbook.machines.flying.view import CASES, Flying, does
from workbook.machines.flying.workings import workings
from workbook.motion.asked import ABOUT as CONTINUOUS
from workbook.motion.pieces import ROOM
from workbook.motion.smooth import Joints

BELOW_CHARTS = 60  # the row from which the sheet is free in its whole width
DOES = (
    f'=IF(AND({IS_DRUM},fly_beyond="standstill",fly_length>fly_limit),"waits",'
    'IF(fly_low<0-fly_near*fly_v,"reverses","keeps moving"))'
)


def cutter_sheet(book: Book, machine: Flying, joints: Joints, stroke: float, laws: Sequence[NamedLaw]) -> None:
    """Declare the sheet; ``stroke`` (m) is the tool's by the points of its drive."""
    sheet = book.sheet("Cutter", "The tool works at line speed, and makes up for the product's length in between.")
    entries(sheet, machine)
    sheet.heading("Results")
    cycle(sheet, machine)
    kinematics(sheet, machine, stroke)
    load(sheet, machine)
    sheet.row += 1
    verdicts(sheet, machine, joints, stroke)
    beside(sheet)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    cases(sheet, machine)
    strategies(sheet, machine)
    workings(sheet, machine)
    peaks(sheet, laws)
    sheet.print_columns = 24


def entries(sheet: Sheet, machine: Flying) -> None:
    """Declare what the engineer enters."""
    e = machine.given
    drum, saw, moved, limits = e.drum, e.saw, e.load, e.limits
    plain = {"format": "0.0##"}
    sheet.heading("Enter", "Product and line, the kind of machine with its own entries, load and limits of its shaft.")
    sheet.rows(
        given("fly_length", "Product length", "L_p", "mm",
              e.product_length, "cutter.product_length", **plain, source="one product a cycle"),
        given("fly_line", "Line speed", "v_L", "m/min", e.line_speed, "cutter.line_speed", **plain),
        given("fly_law", "Law of the superimposed motion", "", "",
              e.law, "cutter.law", choices="=law_code", align="center", source="of those on the sheet Laws"),
        given("fly_smooth", "What must be continuous", "", "",
              e.smoothness, "cutter.smoothness", align="center", source=CONTINUOUS),
        given("fly_kind", "Kind of machine", "", "",
              e.kind, "cutter.kind", align="center", source="its tools go round, or its slide comes back"),
        given("fly_tools", "Drum: number of tools", "Z", "", drum.tools, "cutter.drum.tools", format="0"),
        given("fly_radius", "Drum: radius to the tool's edge", "R_t", "mm", drum.radius, "cutter.drum.radius", **plain),
        given("fly_angle", "Drum: angle in step with the line", "θ_T", "°",
              drum.tool_angle, "cutter.drum.tool_angle", **plain, source="synchronous angle"),
        given("fly_beyond", "Drum: products longer than L_p,lim", "", "",
              e.beyond, "cutter.beyond", align="center", source="it waits at standstill, or turns back"),
        given("fly_saw", "Saw: length in step with the line", "L_T", "mm",
              saw.tool_length, "cutter.saw.tool_length", **plain),
        given("fly_lead", "Saw: travel of the slide a turn", "p", "mm",
              saw.lead, "cutter.saw.lead", **plain, source="lead of the screw, or 2π times the pinion's radius"),
        given("fly_room", "Saw: stroke that the slide has", "", "mm", saw.stroke, "cutter.saw.stroke", **plain),
        given("fly_inertia", "Inertia at the shaft", "J", "kg cm²",
              moved.inertia, "cutter.load.inertia", format="0.0#####"),
        given("fly_mass", "Mass that moves with the tool", "m", "kg",
              moved.mass, "cutter.load.mass", **plain, source="slide of a saw; jaws at the radius R_t"),
        given("fly_torque", "Load torque against the line", "T_L", "Nm",
              moved.torque, "cutter.load.torque", **plain, source="all the time; S5 neglects it beside the inertia"),
        given("fly_rpm_max", "Largest speed of the shaft", "", "rpm", limits.speed, "cutter.limits.speed", **plain),
        given("fly_dw_max", "Largest acceleration of the shaft", "", "rad/s²",
              limits.acceleration, "cutter.limits.acceleration", **plain),
    )  # fmt: skip


def cycle(sheet: Sheet, machine: Flying) -> None:
    """Declare the case and the cycle's times and lengths."""
    cut, tool, scale = machine.cut, machine.tool, shown(machine.scales.length, MM)
    case = '=IF(fly_h=0,"in step",IF(fly_h>0,"faster","slower"))'
    sheet.rows(
        result("fly_rate", "Products", "", "1/min", "=60/fly_tc", shown(cut.rate, PER_MINUTE)),
        result("fly_case", "The tool re-positions", "", "",
               case, CASES[cut.case], align="center", source="faster or slower than the line, by the sign of h"),
        result("fly_does", "While it does, it", "", "",
               DOES, does(cut), align="center", source="keeps moving, waits at standstill, or reverses"),
        result("fly_h", "Dynamic displacement", "h", "mm",
               "=IF(ABS(fly_l0-fly_length)<=fly_near*fly_l0,0,fly_l0-fly_length)", shown(cut.displacement, MM),
               scale=scale, source="S5: h = L_0 − L_p; 0 of a product as long as L_0"),
        result("fly_l0", "Design length", "L_0", "mm", "=RADIANS(fly_pitch)*fly_r", shown(tool.design_length, MM),
               scale=scale, source="S5: θ_0 R_t; a saw has none"),
        result("fly_limit", "Longest product without standstill", "L_p,lim", "mm",
               f"=IF({IS_DRUM},(fly_cv*fly_l0-fly_lt)/(fly_cv-1),0)", machine.limit, scale=scale,
               source="S5: (C_v L_0 − L_T)/(C_v − 1); 0: a saw always reverses"),
        result("fly_tc", "Cycle time", "t_C", "s",
               "=fly_length/1000/fly_v", cut.cycle_time, source="S5, eq. (4): L_p/v_L"),
        result("fly_tt", "of it at work", "t_T", "s",
               "=fly_lt/1000/fly_v", cut.tool_time, scale=cut.cycle_time, source="S5: L_T/v_L"),
        result("fly_tr", "for re-positioning", "t_R", "s",
               "=(fly_length-fly_lt)/1000/fly_v", cut.repositioning_time, source="S5: t_C − t_T"),
        result("fly_wait", "of that at standstill", "t_W", "s",
               "=fly_tr-fly_tm", cut.waiting_time, scale=cut.cycle_time),
    )  # fmt: skip


def kinematics(sheet: Sheet, machine: Flying, stroke: float) -> None:
    """Declare speeds, accelerations and travel."""
    cut, s = machine.cut, machine.scales
    mm, rpm = shown(s.length, MM), shown(s.angular_speed, RPM)
    low, high = cut.speed_range
    slowest, fastest = (shown(v / machine.tool.radius, RPM) for v in cut.speed_range)
    per, limits = "*1000/fly_r", machine.given.limits
    line_max = cut.fastest_line(si(limits.speed, RPM), limits.acceleration)
    sheet.rows(
        result("fly_dv", "Change of the tool's speed", "Δv_max", "m/s",
               "=fly_cv*fly_h1/1000/fly_tm", cut.speed_change, scale=s.speed, source="S5, eq. (10): C_v h/t_R"),
        result("fly_domega", "of its shaft", "Δω_max", "rad/s", f"=fly_dv{per}", cut.speed_change / machine.tool.radius,
               scale=s.angular_speed, source="S5, eq. (11): Δv_max/R_t"),
        result("fly_low", "Lowest speed of the tool", "v_min", "m/s",
               "=MIN(fly_v,fly_v+fly_dv)", low, scale=s.speed, source="below 0: against the line"),
        result("fly_high", "Highest speed of the tool", "v_max", "m/s", "=MAX(fly_v,fly_v+fly_dv)", high,
        scale=s.speed),
        result("fly_rpm_low", "Lowest speed of the shaft", "n_min", "rpm",
               f"=fly_low{per}*60/(2*PI())", slowest, scale=rpm),
        result("fly_rpm_high", "Highest speed of the shaft", "n_max", "rpm",
               f"=fly_high{per}*60/(2*PI())", fastest, scale=rpm),
        result("fly_a", "Peak acceleration of the tool", "a_max", "m/s²", "=fly_ca*ABS(fly_h1)/1000/fly_tm^2",
               cut.max_acceleration, scale=s.acceleration, source="S5: C_a h/t_R²"),
        result("fly_dw", "of its shaft", "ω̇_max", "rad/s²", f"=fly_a{per}", cut.max_angular_acceleration,
               scale=s.angular_acceleration, source="S5, eq. (12): a_max/R_t"),
        result("fly_a_rms", "RMS acceleration of the tool", "a_rms", "m/s²",
               "=fly_ca_rms*ABS(fly_h1)/1000/fly_tm^2*SQRT(fly_tm/fly_tc)", cut.rms_acceleration, scale=s.acceleration,
               source="S5: C_a,rms h/t_R² √(t_R/t_C), over the cycle"),
        result("fly_dw_rms", "of its shaft", "ω̇_rms", "rad/s²", f"=fly_a_rms{per}", cut.rms_angular_acceleration,
               scale=s.angular_acceleration, source="S5, eq. (13): a_rms/R_t"),
        result("fly_stroke", "Stroke of the tool in a cycle", "", "mm",
               "=(MAX([drive_pt.far])-MIN([drive_pt.far]))*1000", shown(stroke, MM),
               scale=mm, source="furthest less nearest, to 0.1 %: travel of a saw's slide"),
        result("fly_line_max", "Highest line speed within the limits", "v_L", "m/min",
               "=fly_line*IF(fly_dw>0,MIN(fly_rpm_max/fly_n,SQRT(fly_dw_max/fly_dw)),fly_rpm_max/fly_n)",
               shown(line_max, PER_MINUTE), source="speed grows with v_L, acceleration with v_L²"),
    )  # fmt: skip


def load(sheet: Sheet, machine: Flying) -> None:
    """Declare what the motor and its reducer are chosen by, at the tool's shaft."""
    cut, s, task = machine.cut, machine.scales, machine.task(machine.cut)
    sheet.rows(
        result("fly_w_max", "Highest speed of the shaft, either way", "ω_L,max", "rad/s",
               "=MAX(ABS(fly_low),ABS(fly_high))*1000/fly_r", cut.max_angular_speed),
        result("fly_n", "in revolutions", "n_L,max", "rpm",
               "=fly_w_max*60/(2*PI())", shown(cut.max_angular_speed, RPM)),
        result("fly_torque_rms", "RMS of the generalized load torque", "T*_L,rms", "Nm",
               "=SQRT(fly_torque^2+(fly_j*fly_dw_rms)^2)", task.torque_rms, scale=s.torque,
               source="S5: T*_L = T_L + J_L ω̇_L; the mean of ω̇_L is 0"),
        result("fly_mean", "Mean of acceleration times torque", "(ω̇ T*)_mean", "W/s",
               "=fly_j*fly_dw_rms^2", task.power_rate_mean, scale=s.power_rate, source="T_L drops out over a cycle"),
        result("fly_beta", "Load factor", "β", "W/s", "=2*(fly_dw_rms*fly_torque_rms+fly_mean)", task.load_factor,
               scale=s.power_rate, source="S5, eq. (15); 4 J_L ω̇²_rms without T_L (17), (19)"),
    )  # fmt: skip


SHORT = "ROUND(IF(fly_length<fly_lt*fly_longer,fly_length,fly_short),9)"
RANGE = '"from "&ROUND(fly_short,9)&" mm to "&ROUND(fly_long,9)&" mm; expected a longest above the shortest"'
PIECES = 'fly_pieces&" pieces, and room for "&MAX([tool_pieces.r])'
IN_STEP = 'ROUND(fly_tools,9)&" tools in step over "&ROUND(fly_angle,9)&"° each take more than 360°"'


def verdicts(sheet: Sheet, machine: Flying, joints: Joints, by_points: float) -> None:
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
              f'"a product of "&{SHORT}&" mm; expected at least "&ROUND(fly_lt*fly_longer,9)&" mm"'),
        check("fly_ok_tools", "A drum has whole tools", f"OR(NOT({IS_DRUM}),fly_tools=INT(fly_tools))", True, "",
              "cutter:whole", 'ROUND(fly_tools,9)&" tools; expected a whole number"'),
        check("fly_ok_load", "The shaft has something to move", "OR(fly_inertia>0,fly_mass>0)", True, "",
              "cutter.load:heavy", '"inertia and mass are 0; expected one of them above"'),
        check("fly_ok_range", "The range of product lengths rises", "fly_long>fly_short", True, "",
              "cutter.lengths:ordered", RANGE),
        check("fly_ok_pieces", "The table of pieces has room for all", "fly_pieces<=MAX([tool_pieces.r])", True, ROOM,
              says=PIECES),
        check("fly_ok_angle", "The angle in step is less than between the tools",
              f"OR(NOT({IS_DRUM}),fly_angle*fly_tools<360)", True, "θ_T < θ_0", "cutter:angle", IN_STEP),
        check("fly_ok_law", "The law speeds up once and slows down once", law, True,
              "from rest to rest; S5, 'Motion law parameters'", ":law",
              '"the law "&fly_law&" does not: see its sheet, or Laws"'),
    )  # fmt: skip


def cases(sheet: Sheet, machine: Flying) -> None:
    """Declare the cases that the product length decides between."""
    e, limit, mm = machine.given, machine.limit, shown(machine.scales.length, MM)
    tool, whole = shown(machine.tool.tool_length, MM), shown(machine.tool.design_length, MM)
    sheet.heading(
        "The cases by product length", "S5, 'Variable length cut'; a saw has no design length, and always reverses."
    )
    sheet.table(
        "cases", "From one length to the next", 4,
        constant("case", "re-positioning", "", "",
                 ["faster than the line", "in step with the line", "slower than the line", "waits, or reverses"],
                 align="left"),
        calc("low", "longer than", "", "mm", ["=MIN(fly_lt,fly_l0)", "=fly_l0", "=fly_l0", "=MAX(fly_lt,fly_limit)"],
             [min(tool, whole), whole, whole, max(tool, limit)], scale=mm),
        calc("high", "up to", "", "mm", ["=fly_l0", "=fly_l0", "=fly_limit", "=MAX(fly_long,fly_length)"],
             [whole, whole, limit, max(e.lengths.longest, e.product_length)], scale=mm),
        result("here", "the product", "", "", '=IF([k]=fly_row,"is here","-")',
               ["is here" if k == machine.case else "-" for k in range(1, 5)], align="center"),
        constant("k", "row", "k", "", [1, 2, 3, 4]),
    )  # fmt: skip


def strategies(sheet: Sheet, machine: Flying) -> None:
    """Declare both ways with a product that is too long to keep moving."""
    ways: tuple[Beyond, ...] = ("standstill", "reversal")
    cuts = [machine.of(machine.given.product_length, way) for way in ways]
    sheet.heading(
        "Standstill or reversal", "What this product asks for either way; the same unless it is longer than L_p,lim."
    )
    sheet.table(
        "strategies", "Both ways with products longer than L_p,lim", 2,
        constant("way", "way", "", "", list(ways)),
        *lengths_columns(machine, cuts, "fly_length", "[way]"),
    )  # fmt: skip


def peaks(sheet: Sheet, laws: Sequence[NamedLaw]) -> None:
    """Declare where each law is fastest."""
    sheet.row += 1
    sheet.table(
        "fastest", "Where each law is fastest: there a drum that slows down is slowest, and waits if it has to",
        len(laws),
        calc("law", "law", "", "", [f"=INDEX(law_code,{one.number})" for one in laws], [one.name for one in laws]),
        calc("at", "abscissa", "ξ_v", "", [one.own(one.page.fastest) for one in laws],
             [0.0 if isinstance(one.law, Dwell) else fastest(one.law) for one in laws]),
    )  # fmt: skip


def over_time(title: str, y: str, about: str, *lines: tuple[str, str, bool]) -> Chart:
    """Return a chart of columns of the cycle's table over time; each line has a name, a column, and may be dashed."""
    series = tuple(Series(name, "[cycle.t]", f"[cycle.{column}]", dashed=dashed) for name, column, dashed in lines)
    return Chart(title, "time t [s]", y, series, about)


def beside(sheet: Sheet) -> None:
    """Place the tool's motion, and right of it the load of its shaft, beside what is entered and what comes out."""
    tool = (
        over_time("Speed of the tool over a cycle", "speed [m/s]",
                  "Speed of the tool over one cycle, with the line speed that it works at", ("tool", "v", False),
                  ("line", "line", True)),
        over_time("Position of the tool and of the product", "position [mm]",
                  "Position of the tool along its path over one cycle, with the product's", ("tool", "s", False),
                  ("product", "product", True)),
        over_time("Acceleration of the tool over a cycle", "acceleration [m/s²]",
                  "Acceleration of the tool over one cycle", ("tool", "a", False)),
    )  # fmt: skip
    shaft = (
        over_time("Generalized load torque at the shaft", "T*_L [Nm]",
                  "Load torque and inertia torque at the tool's shaft over one cycle",
                  ("T*_L = T_L + J_L ω̇_L", "torque", False)),
        Chart("Torque against speed of the shaft", "n [rpm]", "T*_L [Nm]", (Series("one cycle", "[cycle.n]",
            "[cycle.torque]"),),
              "Generalized load torque against the speed of the tool's shaft over one cycle"),
        Chart("Load factor against product length", "product length L_p [mm]", "β [W/s]", (
              Series("load factor", "[lengths.length]", "[lengths.beta]"),
              Series("product entered", "[length_line.x]", "[length_line.beta]", dashed=True)),
              "Load factor over the product length at this line speed, with the product entered marked"),
    )  # fmt: skip
    for column, charts in ((11, tool), (18, shaft)):
        for row, chart in zip((5, 24, 43), charts, strict=True):
            sheet.chart(chart, column=column, row=row, width=7, height=18)
