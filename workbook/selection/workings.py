"""Workings of the Selection sheet: which rows the pair that is looked at is, its figures, and what is taken for 0."""

from __future__ import annotations

from typing import NamedTuple, get_args

from engine.choice.pairs import Criterion
from engine.choice.task import NOTHING
from workbook.book.declare import Sheet, calc, constant
from workbook.drive import losses
from workbook.entries.units import KG_CM2, PER_RPM, RPM, shown
from workbook.selection.view import PARTS, Choosing

OFF = -1.0  # left of the charts' edge: where what is not drawn lies


class PairFigures(NamedTuple):
    """The figures of a pair in the sheet's units, 0 where there is none or one is not given."""

    m: int = 0
    r: int = 0
    motor_inertia: float = 0.0
    reducer_inertia: float = 0.0
    inertia: float = 0.0
    ratio: float = 0.0
    efficiency: float = 0.0
    rated: float = 0.0
    peak: float = 0.0
    max_speed: float = 0.0
    knee: float = 0.0
    slope: float = 0.0
    speed_limit: float = 0.0
    torque_limit: float = 0.0


def figures_of_pair(view: Choosing) -> PairFigures:
    """Return the figures of the pair that is looked at."""
    pair = view.pair
    if pair is None:
        return PairFigures()
    m, r = pair.motor, pair.reducer
    motor, reducer = view.given.motors[m], view.given.reducers[r]
    return PairFigures(
        m + 1,
        r + 1,
        motor.inertia,
        reducer.inertia or 0.0,
        shown(pair.inertia, KG_CM2),
        pair.ratio,
        pair.efficiency,
        pair.rated_torque,
        motor.peak_torque,
        motor.max_speed,
        shown(float(view.motors.knee[m]), RPM),
        shown(float(view.motors.slope[m]), PER_RPM),
        reducer.max_speed or 0.0,
        reducer.max_torque or 0.0,
    )


def workings(sheet: Sheet, view: Choosing) -> None:
    """Declare which rows the pair is, its figures, and the constants of the method."""
    sheet.heading("Workings")
    rows_of_pair(sheet, view)
    figures_of_rows(sheet, figures_of_pair(view))
    constants(sheet, view)


def rows_of_pair(sheet: Sheet, view: Choosing) -> None:
    """Declare the criterion's number and the rows of the pair, the best or as named."""
    made = figures_of_pair(view)
    sheet.rows(
        calc("sel_no", "Number of the criterion", "", "",
             '=IF(sel_criterion="margin",1,IF(sel_criterion="inertia match",2,IF(sel_criterion="size",3,4)))',
             get_args(Criterion).index(view.given.criterion) + 1),
        calc("sel_m", "Row of the motor", "", "",
             ('=IF(sel_pair="best",IF([ranking.at.1]>0,INDEX([pairs.m],[ranking.at.1]),0),'
              "IF(ISNUMBER(MATCH(sel_motor,[motors.name],0)),MATCH(sel_motor,[motors.name],0),0))"),
             made.m, source="0: none"),
        calc("sel_r", "Row of the reducer", "", "",
             ('=IF(sel_pair="best",IF([ranking.at.1]>0,INDEX([pairs.r],[ranking.at.1]),0),'
              "IF(ISNUMBER(MATCH(sel_reducer,[reducers.name],0)),MATCH(sel_reducer,[reducers.name],0),0))"),
             made.r),
        calc("sel_found", "There is a pair", "", "",
             "=IF(AND(sel_m>0,sel_r>0),1,0)", int(made.m > 0), source="1 yes, 0 no"),
    )  # fmt: skip


def figures_of_rows(sheet: Sheet, made: PairFigures) -> None:
    """Declare the figures of the pair's motor and reducer, 0 without a pair."""
    sheet.rows(
        calc("sel_jm", "Inertia of the motor", "J_M", "kg cm²",
             "=IF(sel_found=1,INDEX([motors.inertia],sel_m),0)", made.motor_inertia),
        calc("sel_jt", "Inertia of the reducer at the motor's shaft", "J_T", "kg cm²",
             "=IF(sel_found=1,INDEX([reducers.inertia],sel_r),0)", made.reducer_inertia),
        calc("sel_j", "Both", "J_M + J_T", "kg cm²", "=sel_jm+sel_jt", made.inertia),
        calc("sel_tau", "Transmission ratio", "τ", "",
             "=IF(sel_found=1,INDEX([reducers.tau],sel_r),0)", made.ratio, source="ω_L/ω_M"),
        calc("sel_er", "Efficiency of the reducer", "η", "",
             "=IF(sel_found=1,INDEX([reducers.eta],sel_r),0)", made.efficiency),
        calc("sel_rated", "Rated torque of the motor", "T_M,N", "Nm",
             "=IF(sel_found=1,INDEX([motors.rated],sel_m),0)", made.rated),
        calc("sel_peak", "Peak torque of the motor", "T_M,max", "Nm",
             "=IF(sel_found=1,INDEX([motors.peak],sel_m),0)", made.peak),
        calc("sel_nmax", "Largest speed of the motor", "n_max", "rpm",
             "=IF(sel_found=1,INDEX([motors.nmax],sel_m),0)", made.max_speed),
        calc("sel_knee", "… up to which the peak torque holds", "n_1", "rpm",
             "=IF(sel_found=1,INDEX([motors.corner],sel_m),0)", made.knee),
        calc("sel_slope", "Fall of the peak torque beyond", "", "Nm/rpm",
             "=IF(sel_found=1,INDEX([motors.slope],sel_m),0)", made.slope),
        calc("sel_nlimit", "Largest input speed of the reducer", "", "rpm",
             "=IF(sel_found=1,IF(COUNT(INDEX([reducers.nmax],sel_r))=1,INDEX([reducers.nmax],sel_r),0),0)",
             made.speed_limit, source="0: not given"),
        calc("sel_tlimit", "Largest output torque of the reducer", "", "Nm",
             "=IF(sel_found=1,IF(COUNT(INDEX([reducers.tmax],sel_r))=1,INDEX([reducers.tmax],sel_r),0),0)",
             made.torque_limit, source="0: not given"),
    )  # fmt: skip


def constants(sheet: Sheet, view: Choosing) -> None:
    """Declare what scores are counted in, and what is so small that it is none."""
    sheet.rows(
        constant("sel_none", "A smaller acceleration, torque or speed is none", "", "SI",
                 NOTHING, format="0E+00", source="so small it comes from rounding"),
        calc("sel_unit", "Scores are counted in", "", "",
             "=IF(AND(sel_no>2,MAX([pairs.score])>0),MAX([pairs.score]),1)", view.counted_in,
             source="the largest mass or cost, else 1"),
        constant("sel_parts", "Parts of a unit in which scores are compared", "", "",
                 PARTS, format="0", source="equal to an engineer, equal in the ranking"),
        calc("sel_rows", "Rows of all pairs", "", "",
             "=COUNT([pairs.k])", view.rows, format="0", source="equals rank in their order there"),
        losses.standstill(),
        losses.nearly(),
        constant("sel_off", "Where charts hide what is not drawn", "", "",
                 OFF, format="0", source="left of their edge"),
    )  # fmt: skip
