"""The motor's limits in cells: entered, drawn in the plane of speed and torque, and held against a cycle.

The cycle's results stand in ``@rms``, ``@tmax``, ``@tmin`` (Nm), ``@speed`` and ``@mean`` (rpm).
"""

from __future__ import annotations

from engine.drivetrain.motor import CORNERS, Corners, Reserve
from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, check, constant
from workbook.book.sentence import NOTHING, Said, exceeding
from workbook.entries.units import RPM, shown

RATED = "@motor_rated"
RMS_POINT, PEAK, CONTINUOUS = "374151", "D55E00", "009E73"
"""colours in the plane of speed and torque"""


def limit_checks(reserve: Reserve, of: str, mends: Said = NOTHING) -> list[Quantity]:
    """Return the checks of RMS torque, peak torque and speed; ``mends`` says, behind what fails, what would mend it."""
    peak, fastest = "MAX(@tmax,0-@tmin)", [shown(n, RPM) for n in (reserve.speed.value, reserve.speed.limit)]
    return [
        check("@ok_rms", f"{of}: RMS torque within the rated torque", f"@rms<={RATED}", reserve.rms_torque.ok,
              says=exceeding("@rms", RATED, "Nm", reserve.rms_torque.value, reserve.rms_torque.limit).then(mends)),
        check("@ok_peak", f"{of}: peak torque within the motor's", f"{peak}<=@motor_peak", reserve.peak_torque.ok,
              says=exceeding(peak, "@motor_peak", "Nm", reserve.peak_torque.value, reserve.peak_torque.limit)
              .then(mends)),
        check("@ok_speed", f"{of}: speed within the motor's", "@speed<=@motor_nmax", reserve.speed.ok,
              says=exceeding("@speed", "@motor_nmax", "rpm", *fastest).then(mends)),
    ]  # fmt: skip


def limits_table(sheet: Sheet, corners: Corners, backward: str, falls: bool) -> None:
    """Declare the corners of the limits as the charts draw them; ``backward`` says whether the motor turns so too.

    Where the sheet knows motors whose peak torque ``falls``, it does by ``@fall`` (Nm/rpm) beyond ``@knee`` (rpm).
    """
    right, outer, up = zip(*CORNERS, strict=True)
    begins = "IF(@fall=0,@motor_nmax,@knee)" if falls else "@motor_nmax"
    peak = f"(@motor_peak-@fall*MAX(0,ABS([rpm])-{begins}))" if falls else "@motor_peak"
    sheet.table(
        "@limits", "Limits of the motor, as drawn in the charts", len(CORNERS),
        constant("side", "right side", "", "", list(right)),
        constant("outer", "at the largest speed", "", "", list(outer)),
        constant("up", "upper side", "", "", list(up)),
        calc("rpm", "speed", "n", "rpm",
             f"=IF([side]=1,1,IF({backward},0-1,0))*IF([outer]=1,@motor_nmax,{begins})", shown(corners.speed, RPM)),
        calc("peak", "peak torque", "T_max", "Nm", f"=[up]*{peak}", corners.peak),
        calc("rated", "continuous torque", "T_N", "Nm", f"=[up]*{RATED}", corners.rated),
    )  # fmt: skip


def rms_point(sheet: Sheet, speed: float, torque: float) -> None:
    """Declare the RMS torque (Nm) at the mean speed (rad/s) as the chart draws it."""
    sheet.table(
        "@point", "RMS point, as drawn in the chart", 1,
        calc("rpm", "mean speed", "n_mean", "rpm", "=@mean", [shown(speed, RPM)], scale=max(shown(speed, RPM), 1.0)),
        calc("torque", "RMS torque", "T_rms", "Nm", "=@rms", [torque], scale=max(torque, 1e-3)),
    )  # fmt: skip


def plane(speed: str, torque: str) -> Chart:
    """Return the chart of torque against speed, from these columns, and the RMS point, within the limits."""
    lines = (
        Series("cycle", speed, torque),
        Series("RMS point", "[@point.rpm]", "[@point.torque]", points=True, marker="diamond", color=RMS_POINT),
        Series("peak torque and speed", "[@limits.rpm]", "[@limits.peak]", dashed=True, color=PEAK),
        Series("rated torque", "[@limits.rpm]", "[@limits.rated]", dashed=True, color=CONTINUOUS),
    )
    return Chart(
        "Torque against speed of the motor", "motor speed n_m [rpm]", "motor torque T [Nm]", lines,
        "Speed and torque of the motor over one cycle, and its RMS torque at its mean speed: the point that has to lie "
        "within the continuous limit, the cycle within the peak limit",
    )  # fmt: skip
