"""The workings of a drive's sheet: the chain in S1's terms, and peaks over the cycle.

A peak is the largest at a point, or where the parabola through that and its neighbours has its top: there the drive is
worked out once more. Where a piece's acceleration only rises or only falls, torques of a constant ratio are largest at
a point itself.
"""

from engine.drive.chain import held_factor
from engine.drive.mechanisms.by_angle import Arm
from engine.drive.quadrature import STANDSTILL
from engine.laws.points import POINTS
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.fields.units import DEGREE, shown
from workbook.machines.machine.drive import brake, stages
from workbook.machines.machine.drive.entered import on_shaft
from workbook.machines.machine.drive.view import PEAK_UNITS, PEAKED, DriveView
from workbook.machines.machine.mechanism import BELTED, SCREWS


def losses(view: DriveView) -> list[Quantity]:
    """Return the rows of the factors of losses: where the load drives, and at rest; of a constant ratio by force."""
    driven = view.driven
    reducer, *_, mechanism = driven.mechanism.stages
    document = driven.given.method == "document"
    back = 1.0 / mechanism.efficiency if document else driven.back_efficiency
    held = 1.0 / mechanism.efficiency if document else held_factor(mechanism.efficiency, driven.back_efficiency)
    entered = "2-1/@eta2" if driven.given.kind in SCREWS else "@eta2"  # where none is
    base, i2 = driven.axis.base, mechanism.ratio
    force, unit = ("N", "m") if base == "m" else ("Nm", "")
    by_force = [] if view.varies else [
        calc("@out2", f"Output torque of the reducer for 1 {force} at the load", "", unit, "=1/@eta2/@i2",
             1.0 / mechanism.efficiency / i2, "1/(η_2 i_2)"),
        calc("@in2", "the same, load driving", "", unit, "=@back2/@i2", back / i2, scale=1.0 / i2),
        calc("@held2", "the same, at standstill", "", unit, "=@hold2/@i2", held / i2),
        calc("@j1i2", f"Output torque of the reducer for 1 {base}/s², of parts", "", f"Nm s²/{base}", "=@j1*@i2",
             driven.mechanism.on_shaft(driven.mechanism.last - 1) * i2, "J_p i_2"),
        calc("@j0i", f"Motor torque for 1 {base}/s², of its own inertia", "", f"Nm s²/{base}", "=@j0*@i",
             driven.at_motor * driven.mechanism.ratio, "J_0 i"),
    ]  # fmt: skip
    return [
        calc("@out1", "Motor torque for 1 Nm behind the reducer", "", "", "=1/@eta1/@i1",
             1.0 / reducer.efficiency / reducer.ratio, "1/(η i)"),
        calc("@in1", "the same, load driving", "", "", '=IF(@method="document",1/@eta1,@eta1)/@i1',
             (1.0 / reducer.efficiency if document else reducer.efficiency) / reducer.ratio,
             "η/i; by S4 1/(η i), as where it is driven"),
        calc("@brake", "A brake holds it at rest", "", "", '=IF(@holding="brake",1,0)', int(driven.holding == "brake"),
             "1 yes, 0 no", format="0"),
        *(brake.workings(view) if view.brakes else ()),
        calc("@back2", "Loss factor of the mechanism, load driving", "f_2", "",
             f'=IF(@method="document",1/@eta2,IF(@eta2_back="",{entered},@eta2_back))', back,
             "0 or less: self-locking, driven down by the motor", scale=1.0),
        calc("@hold2", "Loss factor of the mechanism at standstill", "f_2", "", "=IF(@back2<=0,0,1/@eta2)", held,
             "1/η_2 as if the motor drove; 0: self-locking"),
        *by_force,
    ]  # fmt: skip


def by_travel(view: DriveView) -> str:
    """Return the end of a formula that is multiplied by the load's largest travel over the shaft's angle."""
    if view.slides:
        return "*MAX(MAX([@pt.dx]),0-MIN([@pt.dx]))"
    return "/MIN([@pt.g])" if view.varies else "/@i2"


def inertias(view: DriveView, sizes: list[Quantity]) -> list[Quantity]:
    """Return the rows of the moved mass or inertia, the sizes of the mechanism, and the inertias on both shafts."""
    driven, m, travels = view.driven, view.driven.mechanism, view.driven.travels
    own = m.on_shaft(m.last - 1)
    moved = "=@mass+0" if travels else "=@inertia/10000"
    if driven.given.kind in BELTED:
        moved = "=@mass+@belt_mass"
    square, largest = "m/φ'²", ", the largest" if driven.train.inertia_varies else ""
    return [
        calc("@m", f"Moved {'mass' if travels else 'inertia'}", "m" if travels else "J", "kg" if travels else "kg m²",
             moved, m.on_shaft(m.last)),
        *sizes,
        calc("@tau", "Ratio of the reducer as S1 has it", "τ", "", "=1/@i1", 1.0 / m.stages[0].ratio,
             "mechanism over motor"),
        calc("@j0", "Inertia on the motor's shaft, motor included", "J_0", "kg m²",
             f"=@jm+@j_reducer+{on_shaft('motor')}", driven.at_motor, "motor, reducer, parts"),
        calc("@j1", "Inertia of parts on the mechanism's shaft", "J_p", "kg m²",
             f"={on_shaft('mechanism')}{stages.own(driven)}", own),
        calc("@j_shaft", "Inertia at the mechanism's shaft", "J_tot", "kg m²", f"=@j1+@m{by_travel(view)}^2",
             own + m.on_shaft(m.last) * view.travel**2,
             f"J_p + {'m (dx/dψ)²' if view.slides else square}{largest}"),
    ]  # fmt: skip


def resisting(view: DriveView) -> list[Quantity]:
    """Return the rows of the constant load force and of friction."""
    load, size, travels = view.driven.load, view.scales, view.driven.travels
    force = "N" if travels else "Nm"
    steady = "=@force+@mass*gravity*SIN(RADIANS(@slope))" if travels else "=@torque+0"
    on_bed = getattr(view.driven.given, "belt_on_bed", None) is not None
    pressing, words = ("(@mass+@belt_on_bed)", "(m + m_bed)") if on_bed else ("@mass", "m")
    equation = f"μ {words} g cos γ" if travels else ""
    rubbing = f"=@friction*{pressing}*gravity*ABS(COS(RADIANS(@slope)))" if travels else "=@friction_torque+0"
    return [
        calc("@steady", "Constant load force", "", force, steady, load.torque, "F + m g sin γ" if travels else "",
             scale=size.force),
        calc("@cr", "Constant torque at the mechanism's shaft", "C_r", "Nm", f"=@steady{by_travel(view)}",
             load.torque * view.travel, "F_r/φ', F_r R of rollers", scale=size.behind),
        calc("@rub", "Friction", "", force, rubbing, load.friction, equation, scale=size.force),
    ]  # fmt: skip


def workings(sheet: Sheet, view: DriveView, sizes: list[Quantity]) -> None:
    """Declare ratios, inertias, losses and resisting forces, in S1's terms."""
    driven, one, axis = view.driven, view.tables, view.driven.axis
    still = STANDSTILL * driven.max_geometric_velocity * axis.speed
    sheet.heading(
        "Workings: the chain",
        "S1: C_m = J_m/τ ω̇ + τ (C_r + J_tot ω̇), τ = 1/i_1 and ω̇ of the mechanism's shaft; with losses τ over η_1.",
    )
    sheet.rows(
        constant("@built", "Axis, named when the book was built", "", "", driven.entered.called,
                 "the sheet and its checks keep this name", align="left"),
        calc("@faster", "Rate of the drive over the machine's", "", "", "=@rate/timing_rate",
             shown(axis.speed, one.axis.speed)),
        calc("@omega", f"{one.machine.over.speed} at its rate", "ω", "rad/s", "=omega*@faster", axis.speed),
        *inertias(view, sizes), *losses(view), *(stages.workings(view) if driven.entered.stages else ()),
        *resisting(view),
        calc("@vmax", "Greatest geometric velocity", "y'max", "", f"=MAX([axis{driven.number}.y1])",
             driven.max_geometric_velocity),
        calc("@amax", "Greatest acceleration", "ÿ", f"{axis.base}/s²", f"=[axes.a.{driven.number}]*@faster^2",
             axis.max_acceleration),
        calc("@still", "Standstill: speeds up to", "", f"{axis.base}/s", "=check_zero*@vmax*@omega", still,
             format="0E+00", scale=max(still, 1e-12)),
        *([calc("@arm", "Arm: torque of its weight, level", "m_a g r_a", "Nm", "=@arm_mass*gravity*@arm_radius/1000",
                driven.by_angle.moment)] if isinstance(driven.by_angle, Arm) else []),
    )  # fmt: skip


BEYOND = "[sign]*([s0]-[s1])<=0,[sign]*([s0]*(2*[a]+[b])-[s1]*[a])<0,[sign]*([s1]*([a]+2*[b])-[s0]*[b])>0"
"""where the parabola's top is not between the neighbours: points on a line that tie with the largest"""
ABOUT = (
    "w at the largest point, w_0 and w_1 at its neighbours, Δ_0 and Δ_1 degrees away: the top of the parabola is "
    "(s_0 Δ_1 + s_1 Δ_0)/2(s_0 − s_1) degrees behind the point, s_0 and s_1 the slopes on both sides."
)


def top(name: str, end: str = "high") -> str:
    """Return the reference to a peak: of the column T, S, P or n, its ``high`` or its ``low``."""
    row = 2 * "TSPn".index(name) + (1 if end == "high" else 2)
    return f"[@tops.top.{row}]"


def peaks_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the peaks, a row for the highest and one for the lowest of each quantity."""
    points, sizes, last = view.points, view.scales, view.rows * POINTS
    words = {"T": ("torque of the motor", sizes.torque), "S": ("output torque of the reducer", sizes.behind),
             "P": ("power of the motor", sizes.power), "n": ("speed of the motor", sizes.rpm)}  # fmt: skip
    each, found = list(view.peaks), list(view.peaks.values())
    size = max(words[name][1] for name, _ in each)
    signs = [sign for _, sign in each]

    def of(formula: str) -> list[str]:
        return [formula.replace("{y}", f"[@pt.{column}]") for column, _ in each]

    neighbours = [
        [shown(sign * value, PEAK_UNITS[name]) for value in one.values]
        for (name, sign), one in zip(each, found, strict=True)
    ]
    gaps = [[shown(one.before, DEGREE) for one in found], [shown(one.after, DEGREE) for one in found]]
    slopes = [
        [(n[k + 1] - n[k]) / gap if gap else 0.0 for n, gap in zip(neighbours, gaps[k], strict=True)] for k in (0, 1)
    ]
    inner = "AND(INDEX([@pt.s],[at])>0,INDEX([@pt.s],[at])<1)"
    size_of = "MAX(MAX({y}),0-MIN({y}))"
    sheet.heading("Workings: peaks", ABOUT)
    sheet.table(
        "@peaks", "Peaks over the cycle", len(each),
        constant("what", "quantity", "", "",
                 [f"{words[name][0]}, {'highest' if sign > 0 else 'lowest'}" for name, sign in each], align="left"),
        constant("sign", "highest (1), lowest (−1)", "", "", signs, format="0"),
        calc("most", "largest at a point", "", "", of("=IF([sign]=1,MAX({y}),0-MIN({y}))"),
             [shown(float((sign * PEAKED[name](points)).max()), PEAK_UNITS[name]) for name, sign in each], scale=size),
        calc("at", "the first such point", "", "",
             of(f"={last + 1}-SUMPRODUCT(MAX(([sign]*{{y}}>=[most]-check_zero*{size_of})*({last + 1}-[@pt.k])))"),
             [one.at + 1 for one in found], "to a rounding", format="0"),
        calc("y0", "before it", "w_0", "", of("=INDEX({y},MAX([at]-1,1))"), [n[0] for n in neighbours], scale=size),
        calc("y", "there", "w", "", of("=INDEX({y},[at])"), [n[1] for n in neighbours], scale=size),
        calc("y1", "after it", "w_1", "", of(f"=INDEX({{y}},MIN([at]+1,{last}))"), [n[2] for n in neighbours],
             scale=size),
        calc("a", "to the point before", "Δ_0", "°",
             f"=IF({inner},INDEX([@pt.theta],[at])-INDEX([@pt.theta],[at]-1),0)", gaps[0], "0 at an end", scale=360.0),
        calc("b", "to the point after", "Δ_1", "°", f"=IF({inner},INDEX([@pt.theta],[at]+1)-INDEX([@pt.theta],[at]),0)",
             gaps[1], scale=360.0),
        calc("s0", "slope before", "s_0", "", "=IF([a]>0,([y]-[y0])/[a],0)", slopes[0], scale=size),
        calc("s1", "slope after", "s_1", "", "=IF([b]>0,([y1]-[y])/[b],0)", slopes[1], scale=size),
        calc("place", "top of the parabola at", "θ", "°",
             f"=INDEX([@pt.theta],[at])+IF([a]=0,0,IF(OR({BEYOND}),0,([s0]*[b]+[s1]*[a])/2/([s0]-[s1])))",
             shown(view.at_peaks.load.x.ravel(), DEGREE).tolist(), scale=360.0, format="0.0##"),
    )  # fmt: skip
