"""The motor's limits in cells: entered, drawn in the plane of speed and torque, and held against a cycle.

The cycle's results stand in ``@rms``, ``@tmax``, ``@tmin`` (Nm), ``@speed`` and ``@mean`` (rpm).
"""

from engine.drive.motor import CORNERS, LimitCorners, Motor, Reserve
from workbook.book.cell_tables import CellTable, cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import NOTHING, CheckSentence, amount
from workbook.fields.units import RPM, shown

CELLS = cell_tables(__file__)

# colours of the RMS torque, and of limits, in charts
RMS_POINT, PEAK, CONTINUOUS = "374151", "991B1B", "6B7280"


def limit_checks(reserve: Reserve, of: str, mends: CheckSentence = NOTHING) -> list[Quantity]:
    """Return the checks of RMS torque, peak torque and speed; ``mends`` says, behind what fails, what would mend it."""
    cell = CELLS["limit_checks"].sharing(of=of)
    sizes = {"@ok_rms": 1.0, "@ok_peak": 1.0, "@ok_speed": RPM}
    return [
        cell.limit(name, shown(check.value, size), shown(check.limit, size), mends)
        for (name, size), check in zip(sizes.items(), reserve, strict=True)
    ]


def inertia_check(of: str, cell: str, limit: str, ratio: float, most: float, then: CheckSentence = NOTHING) -> Quantity:
    """Return the check of the inertia ratio; ``then`` is what it says besides."""
    return CELLS["inertia_check"](
        "@ok_inertia",
        ratio <= most,
        of=of,
        cell=cell,
        allowed=limit,
        says=amount(cell, ratio, "the load has ", " times the motor's inertia").then(then),
    )


def pair_checks(
    of: str, shaft: float, hub: float, mass: float, most: float, limit: str = "@largest_mass"
) -> list[Quantity]:
    """Return the checks of a motor's shaft in its reducer's hub (mm), and of their mass (kg); a limit of 0 is none."""
    cell = CELLS["pair_checks"].sharing(of=of, allowed=limit)
    return [cell.limit("@ok_shaft", shaft, hub), cell.limit("@ok_mass", mass, most)]


def below_curve(of: str, falls: float, spare: float, mends: CheckSentence = NOTHING) -> Quantity:
    """Return the check that the torque stays below a curve that falls (Nm s), of which so much is to spare (Nm)."""
    cell = CELLS["below_curve"]
    says = amount("0-@spare", -spare, "", " Nm more than the motor has at its speed").then(mends)
    return cell("@ok_curve", not falls or spare >= 0.0, of=of, says=says)


def within_reducer(of: str, torque: str, most: str) -> CellTable:
    """Return the table of the checks of a reducer's limits, with the cells of its output torque and of its limit."""
    return CELLS["within_reducer"].sharing(of=of, torque=torque, most=most)


def continuous(motor: Motor, mean_speed: float) -> Quantity:
    """Return the result of what the motor can give all the time at the mean speed of the cycle (rad/s)."""
    cell = CELLS["continuous"]
    return cell("@continuous", float(motor.continuous(mean_speed)), continuous_at=continuous_at("@mean"))


def continuous_at(speed: str) -> str:
    """Return the formula of the continuous torque of the motor in use at a speed (rpm)."""
    return f"MAX(@motor_rated,@motor_stall-(@motor_stall-@motor_rated)*{speed}/@motor_nn)"


def limits_table(sheet: Sheet, corners: LimitCorners, backward: str, falls: bool) -> None:
    """Declare the corners of the limits as the charts draw them; ``backward`` says whether the motor turns so too.

    Where the sheet knows motors whose peak torque ``falls``, it does by ``@fall`` (Nm/rpm) beyond ``@knee`` (rpm).
    """
    side, which, up = zip(*CORNERS, strict=True)
    begins = "IF(@fall=0,@motor_nmax,MIN(@knee,@motor_nmax))" if falls else "@motor_nmax"
    first, second = shown(corners.bends, RPM)
    sheet.rows(
        CELLS["limits_table"]("@bend1", first, begins=begins), CELLS["limits_table"]("@bend2", second, begins=begins)
    )
    peak = f"(@motor_peak-@fall*MAX(0,ABS([rpm])-{begins}))" if falls else "@motor_peak"
    CELLS["limits"].place(
        sheet,
        CELLS["limits"]("side", list(side)),
        CELLS["limits"]("which", list(which)),
        CELLS["limits"]("up", list(up)),
        CELLS["limits"]("rpm", shown(corners.speed, RPM), backward=backward),
        CELLS["limits"]("peak", corners.peak, peak=peak),
        CELLS["limits"]("rated", corners.continuous, continuous_at=continuous_at("ABS([rpm])")),
    )


def rms_point(sheet: Sheet, speed: float, torque: float) -> None:
    """Declare the RMS torque (Nm) at the mean speed (rad/s) as the chart draws it."""
    cell = CELLS["point"]
    cell.place(
        sheet,
        cell("rpm", [shown(speed, RPM)], scale=max(shown(speed, RPM), 1.0)),
        cell("torque", [torque], scale=max(torque, 1e-3)),
    )


def plane(speed: str, torque: str, *more: Series, ink: str = "", title: str = "") -> Chart:
    """Return the chart of torque against speed, from these columns, and the RMS point, within the limits.

    With a ``title`` that says what the lines are, they have no names beside them.
    """
    lines = (
        Series("cycle", speed, torque, color=ink),
        *more,
        Series("RMS point", "[@point.rpm]", "[@point.torque]", points=True, marker="diamond", color=RMS_POINT),
        Series("peak torque and speed", "[@limits.rpm]", "[@limits.peak]", dashed=True, color=PEAK),
        Series("continuous torque", "[@limits.rpm]", "[@limits.rated]", dashed=True, color=CONTINUOUS),
    )
    return Chart(
        title or "Torque against speed of the motor",
        "motor speed n_m [rpm]",
        "motor torque T [Nm]",
        lines,
        "Speed and torque of the motor over one cycle, and its RMS torque at its mean speed: the point that has to lie "
        "within the continuous limit, the cycle within the peak limit",
        legend=not title,
    )
