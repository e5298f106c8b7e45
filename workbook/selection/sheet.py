"""The Selection sheet: motor and reducer from catalogues, by the seven steps of S5, for the load of any template."""

from __future__ import annotations

from typing import Any

import numpy as np

from engine.drivetrain import STANDSTILL
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.entries.units import RPM
from workbook.selection.curves import charts, curves
from workbook.selection.load import LoadCells
from workbook.selection.tables import catalogues, pairs, ranking
from workbook.selection.view import NONE, PLACES, STEP, Choosing

OFF = -1.0  # left of the charts' edge: where what is not drawn lies
LIMITS = (
    ("sel_ok_rms", "Selection: RMS torque within the motor's rated torque", "sel_rms<=sel_rated"),
    ("sel_ok_peak", "Selection: torque below the motor's curve at every speed", "sel_spare>=0,sel_speed<=sel_nmax"),
    ("sel_ok_speed", "Selection: speed within the motor's", "sel_speed<=sel_nmax"),
    ("sel_ok_input", "Selection: speed within the reducer's", "OR(sel_nlimit=0,sel_speed<=sel_nlimit)"),
    ("sel_ok_output", "Selection: torque within the reducer's", "OR(sel_tlimit=0,sel_tmax<=sel_tlimit)"),
)
"""Step 7: each check and its condition, in the order of :func:`engine.pairing.checks`."""


def selection_sheet(book: Book, load: LoadCells, view: Choosing) -> Sheet:
    """Declare the sheet."""
    sheet = book.sheet("Selection", "Motor and reducer from catalogues: what can do the task, and what suits it best.")
    entries(sheet, view)
    asked(sheet, load, view)
    outcome(sheet, view)
    ranking(sheet, view)
    charts(sheet, view)
    catalogues(sheet, view)
    book.column_names |= {"motor_name": ("motors", "name"), "reducer_name": ("reducers", "name")}
    workings(sheet, view)
    pairs(sheet, view)
    curves(sheet, load, view)
    sheet.print_columns = 20
    return sheet


def entries(sheet: Sheet, view: Choosing) -> None:
    """Declare the criterion, the pair to look at, and what is assumed before a reducer is known."""
    s = view.given
    sheet.heading(
        "What to enter",
        "The catalogues stand below: extend or replace them; each product says where its figures are from.",
    )
    sheet.rows(
        given("sel_criterion", "Rank the pairs by", "", "",
              s.criterion, "selection.criterion", source="S5, step 6; size is the mass, cost is as entered"),
        given("sel_pair", "Pair to look at", "", "",
              s.pair, "selection.pair", source="the best by that, or the one chosen in the next two rows"),
        given("sel_motor", "Motor, if chosen", "", "",
              s.motor, "selection.motor", choices="=motor_name", source="from the table of motors"),
        given("sel_reducer", "Reducer, if chosen", "", "",
              s.reducer, "selection.reducer", choices="=reducer_name", source="from the table of reducers"),
        given("sel_eta", "Efficiency before a reducer is known", "η", "",
              s.efficiency, "selection.efficiency", format="0.0##", source="in the ranges of τ only; 1: S5 as printed"),
        given("sel_factor", "Factor on the reducer's torque", "f", "",
              s.torque_factor, "selection.torque_factor", format="0.0##",
              source="for shocks or many cycles an hour, as its maker says"),
    )  # fmt: skip


def asked(sheet: Sheet, load: LoadCells, view: Choosing) -> None:
    """Declare what the load asks for, at its own shaft."""
    a = view.asked
    sheet.heading("What the load asks for")
    sheet.rows(
        calc("sel_wrms", "RMS acceleration of the load", "ω̇_L,rms", "rad/s²",
             f"={load.acceleration_rms}", a.acceleration_rms, source="over the cycle", scale=view.acceleration_scale),
        calc("sel_trms", "RMS of the generalized load torque", "T*_L,rms", "Nm",
             f"={load.torque_rms}", a.torque_rms, source="T*_L = T_L + J_L ω̇_L"),
        calc("sel_mean", "Mean of their product", "", "Nm rad/s²",
             f"={load.power_rate_mean}", a.power_rate_mean, scale=max(view.acceleration_scale * a.torque_rms, 1e-3)),
        calc("sel_wmax", "Largest speed of the load", "ω_L,max", "rad/s", f"={load.max_speed}", a.max_speed),
        calc("sel_tmax", "Torque that the reducer must hold", "f T*_L,max", "Nm",
             f"=sel_factor*MAX(MAX({load.torque}),0-MIN({load.torque}))", view.torque_needed),
        calc("sel_moves", "The load accelerates, and has a torque", "", "",
             "=IF(MIN(sel_wrms,sel_trms,sel_wmax)>sel_none,1,0)", int(a.task is not None),
             source="1 yes, 0 no: then there is nothing to select"),
        result("sel_beta", "Load factor", "β", "Nm rad/s²",
               "=IF(sel_moves=1,2*(sel_wrms*sel_trms+sel_mean),0)", a.load_factor,
               source="2 (ω̇_rms T*_rms + mean); S5, eq. (15), step 2"),
    )  # fmt: skip


def outcome(sheet: Sheet, view: Choosing) -> None:
    """Declare the pair, what it does, and step 7's checks."""
    made = made_of(view)
    sheet.heading("What comes out")
    sheet.rows(
        result("sel_message", "In words", "", "", MESSAGE, message(view), align="left"),
        result("sel_motor_used", "Motor", "", "",
               '=IF(sel_found=1,INDEX([motors.name],sel_m),"none")', made["motor"], align="left"),
        result("sel_reducer_used", "Reducer", "", "",
               '=IF(sel_found=1,INDEX([reducers.name],sel_r),"none")', made["reducer"], align="left"),
        result("sel_usable", "Pairs that can do it", "", "",
               "=SUM([pairs.usable])", int(view.usable.sum()),
               source="steps 3 to 5, with each reducer's own η, inertia and limits"),
        result("sel_count", "… of these, ranked", "", "",
               "=SUM([pairs.counts])", len(view.ranking), source="those that have the figures that the criterion reads"),
        result("sel_rms", "RMS torque of the motor", "T_M,rms", "Nm",
               "=SQRT(SUM([pair_cycle.part])/([pair_cycle.time.last]-[pair_cycle.time.first]))", view.points.rms_torque,
               source="over the table; losses help to brake"),
        result("sel_margin", "Margin", "", "",
               "=IF(sel_rms>0,sel_rated/sel_rms,0)", made["margin"], source="T_M,N / T_M,rms"),
        result("sel_torque", "Peak torque of the motor", "T_M,max", "Nm",
               "=MAX(MAX([pair_cycle.torque]),0-MIN([pair_cycle.torque]))", view.points.peak_torque),
        result("sel_spare", "Least reserve below the motor's curve", "", "Nm",
               "=MIN([pair_cycle.spare])", made["spare"], source="peak torque at the speed of that instant less |T_M|",
               scale=max(made["peak"], 1e-3)),
        result("sel_speed", "Largest speed of the motor", "n_M", "rpm",
               "=MAX(MAX([pair_cycle.rpm]),0-MIN([pair_cycle.rpm]))", view.points.max_speed / RPM),
        result("sel_balance", "Ratio over the best ratio", "τ/τ_opt", "",
               "=IF(sel_moves*sel_found=1,sel_tau/SQRT(sel_j*sel_wrms*sel_er/sel_trms),0)", made["balance"],
               source="1: motor and load balanced, with the reducer's η and inertia"),
        result("sel_nojt", "Reducers whose inertia is not given", "", "",
               "=SUM([reducers.on])-COUNT([reducers.inertia])", sum(r.inertia is None for r in view.given.reducers),
               source="it counts as 0"),
    )  # fmt: skip
    sheet.checks(*verdicts(view))


MESSAGE = (
    '=IF(sel_moves=0,"the load does not accelerate, or has no torque: there is nothing to select",'
    'IF(sel_pair="chosen",IF(sel_found=1,"your own pair","choose a motor and a reducer of the tables"),'
    'IF(sel_count>0,"the best of the pairs that can do it",'
    'IF(sel_usable>0,"no usable pair has the figures for this criterion: choose another one",'
    'IF(COUNTIF([motors.verdict],"yes")=0,"no motor will do: each is too weak or too slow for this load",'
    '"no reducer goes with the motors that could do it")))))'
)


def message(view: Choosing) -> str:
    """Return in words what came out."""
    if view.ranges is None:
        return "the load does not accelerate, or has no torque: there is nothing to select"
    if view.given.pair == "chosen":
        return "your own pair"
    if len(view.ranking):
        return "the best of the pairs that can do it"
    if view.usable.any():
        return "no usable pair has the figures for this criterion: choose another one"
    if not view.ranges.accepted.any():
        return "no motor will do: each is too weak or too slow for this load"
    return "no reducer goes with the motors that could do it"


def verdicts(view: Choosing) -> list[Quantity]:
    """Return the check that there is a pair, and step 7's; without a pair all fail."""
    found = view.checks
    held = [c.ok for c in found] or [False] * len(LIMITS)
    return [check("sel_ok", "Selection: a motor and a reducer are found", "sel_found*sel_moves=1",
                  bool(found) and view.asked.task is not None)] + [
        check(name, label, f"AND(sel_found=1,{condition})", ok)
        for (name, label, condition), ok in zip(LIMITS, held, strict=True)
    ]  # fmt: skip


def made_of(view: Choosing) -> dict[str, Any]:
    """Return what the chosen pair is made of and does; 0 and 'none' without one."""
    if view.chosen is None:
        return dict.fromkeys(("jm", "jt", "tau", "eta", "rated", "peak", "nmax", "knee", "slope", "nlimit", "tlimit", "margin", "spare", "balance"), 0.0) | {"m": 0, "r": 0, "motor": "none", "reducer": "none"}  # fmt: skip
    m, r = view.chosen
    motor, reducer, rms = view.given.motors[m], view.given.reducers[r], view.points.rms_torque
    inertia, tau = motor.inertia + (reducer.inertia or 0.0), float(view.reducers.ratio[r])
    balance = 0.0
    if view.asked.task:
        wanted = reducer.efficiency / view.asked.torque_rms * view.asked.acceleration_rms
        balance = tau / float(np.sqrt(inertia * wanted))
    knee = motor.max_speed if motor.full_torque_to is None else motor.full_torque_to
    falls = 0.0 if motor.end_torque is None else (motor.end_torque - motor.peak_torque) / (motor.max_speed - knee)
    available = view.curve.at(view.points.speed)
    return {
        "m": m + 1, "r": r + 1, "motor": motor.name, "reducer": reducer.name,
        "jm": motor.inertia, "jt": reducer.inertia or 0.0, "tau": tau, "eta": reducer.efficiency,
        "rated": motor.rated_torque, "peak": motor.peak_torque, "nmax": motor.max_speed, "knee": knee, "slope": falls,
        "nlimit": reducer.max_speed or 0.0, "tlimit": reducer.max_torque or 0.0,
        "margin": motor.rated_torque / rms if rms else 0.0, "balance": balance,
        "spare": float((available - np.abs(view.points.torque)).min()),
    }  # fmt: skip


def workings(sheet: Sheet, view: Choosing) -> None:
    """Declare which rows the pair is, and its figures."""
    made = made_of(view)
    words = ["margin", "inertia match", "size", "cost"]
    listed = ",".join(f'IF(sel_criterion="{word}",{i}' for i, word in enumerate(words[:-1], 1))

    def of(table: str, column: str, row: str) -> str:
        return f"=IF(sel_found=1,INDEX([{table}.{column}],{row}),0)"

    def best(column: str) -> str:
        return f"IF([ranking.at.1]>0,INDEX([pairs.{column}],[ranking.at.1]),0)"

    def named(cell: str, table: str) -> str:
        return f"IF(ISNUMBER(MATCH({cell},[{table}.name],0)),MATCH({cell},[{table}.name],0),0)"

    sheet.heading("Workings")
    sheet.rows(
        calc("sel_no", "Number of the criterion", "", "",
             f"={listed},{len(words)}" + ")" * (len(words) - 1), words.index(view.given.criterion) + 1),
        calc("sel_m", "Row of the motor", "", "",
             f'=IF(sel_pair="best",{best("m")},{named("sel_motor", "motors")})', made["m"], source="0: none"),
        calc("sel_r", "Row of the reducer", "", "",
             f'=IF(sel_pair="best",{best("r")},{named("sel_reducer", "reducers")})', made["r"]),
        calc("sel_found", "There is a pair", "", "",
             "=IF(AND(sel_m>0,sel_r>0),1,0)", int(made["m"] > 0), source="1 yes, 0 no"),
        calc("sel_jm", "Inertia of the motor", "J_M", "kg m²", of("motors", "inertia", "sel_m"), made["jm"]),
        calc("sel_jt", "Inertia of the reducer at the motor's shaft", "J_T", "kg m²",
             of("reducers", "inertia", "sel_r"), made["jt"]),
        calc("sel_j", "Both", "J_M + J_T", "kg m²", "=sel_jm+sel_jt", made["jm"] + made["jt"]),
        calc("sel_tau", "Transmission ratio", "τ", "", of("reducers", "tau", "sel_r"), made["tau"], source="ω_L/ω_M"),
        calc("sel_er", "Efficiency of the reducer", "η", "", of("reducers", "eta", "sel_r"), made["eta"]),
        calc("sel_rated", "Rated torque of the motor", "T_M,N", "Nm", of("motors", "rated", "sel_m"), made["rated"]),
        calc("sel_peak", "Peak torque of the motor", "T_M,max", "Nm", of("motors", "peak", "sel_m"), made["peak"]),
        calc("sel_nmax", "Largest speed of the motor", "n_max", "rpm", of("motors", "nmax", "sel_m"), made["nmax"]),
        calc("sel_knee", "… up to which the peak torque holds", "n_1", "rpm",
             of("motors", "corner", "sel_m"), made["knee"]),
        calc("sel_slope", "Fall of the peak torque beyond", "", "Nm/rpm",
             of("motors", "slope", "sel_m"), made["slope"]),
        calc("sel_nlimit", "Largest input speed of the reducer", "", "rpm",
             "=IF(sel_found=1,IF(COUNT(INDEX([reducers.nmax],sel_r))=1,INDEX([reducers.nmax],sel_r),0),0)",
             made["nlimit"], source="0: not given"),
        calc("sel_tlimit", "Largest output torque of the reducer", "", "Nm",
             "=IF(sel_found=1,IF(COUNT(INDEX([reducers.tmax],sel_r))=1,INDEX([reducers.tmax],sel_r),0),0)",
             made["tlimit"], source="0: not given"),
        constant("sel_none", "A smaller acceleration, torque or speed is none", "", "SI",
                 NONE, format="0E+00", source="so small it comes from rounding"),
        calc("sel_unit", "Scores are counted in", "", "",
             "=IF(AND(sel_no>2,MAX([pairs.score])>0),MAX([pairs.score]),1)", view.unit(view.ranking),
             source="the largest mass or cost, else 1"),
        constant("sel_places", "Decimals in which scores are compared", "", "",
                 PLACES, format="0", source="equal to an engineer, equal in the ranking"),
        constant("sel_step", "By which a pair ranks behind an equal one above it", "", "", STEP, format="0E+00"),
        constant("sel_still", "Slower than this counts as standing", "ω_0", "rad/s",
                 STANDSTILL, format="0E+00", source="at the load's shaft"),
        constant("sel_returned", "A load that gives back less counts as driven", "P_0", "W",
                 1e-6, format="0E+00", source="at the load's shaft; rounding never decides the losses"),
        constant("sel_off", "Where charts hide what is not drawn", "", "",
                 OFF, format="0", source="left of their edge"),
    )  # fmt: skip
