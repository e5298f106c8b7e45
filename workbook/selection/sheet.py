"""The Selection sheet: motor and reducer from catalogues, by the seven steps of S5, for the load of any template."""

from __future__ import annotations

from workbook.book.declare import Book, Quantity, Sheet, calc, check, given, result
from workbook.book.rows import filled
from workbook.book.sentence import Said, amount, exceeding
from workbook.entries.units import RPM, shown
from workbook.selection.charts import charts
from workbook.selection.curves import curves
from workbook.selection.load import LoadCells
from workbook.selection.pairs import pairs, ranking
from workbook.selection.products import catalogues
from workbook.selection.view import Choosing
from workbook.selection.workings import workings

LIMITS = (
    ("sel_ok_rms", "Selection: RMS torque within the motor's rated torque", "sel_rms<=sel_rated"),
    ("sel_ok_peak", "Selection: torque below the motor's curve at every speed", "sel_spare>=0,sel_speed<=sel_nmax"),
    ("sel_ok_speed", "Selection: speed within the motor's", "sel_speed<=sel_nmax"),
    ("sel_ok_input", "Selection: speed within the reducer's", "OR(sel_nlimit=0,sel_speed<=sel_nlimit)"),
    ("sel_ok_output", "Selection: torque within the reducer's", "OR(sel_tlimit=0,sel_tmax<=sel_tlimit)"),
)
"""Step 7: each check and its condition, in the order of :meth:`engine.choice.Pair.checks`."""


def selection_sheet(book: Book, load: LoadCells, view: Choosing) -> Sheet:
    """Declare the sheet."""
    sheet = book.sheet("Selection", "Motor and reducer from catalogues: what can do the task, and what suits it best.")
    entries(sheet, view)
    asked(sheet, load, view)
    outcome(sheet, view)
    ranking(sheet, view)
    charts(sheet, view)
    sheet.not_printed_below()
    catalogues(sheet, view)
    with sheet.scoped("sel_"):
        workings(sheet, view)
        pairs(sheet, view)
        curves(sheet, load, view)
    sheet.print_columns = 20
    sheet.one_page = True
    return sheet


def entries(sheet: Sheet, view: Choosing) -> None:
    """Declare the criterion, the pair to look at, and what is assumed before a reducer is known."""
    s = view.given
    sheet.heading(
        "Enter",
        "The catalogues stand below: extend or replace them; each product says where its figures are from.",
    )
    sheet.rows(
        given("sel_criterion", "Rank the pairs by", "", "",
              s.criterion, "selection.criterion", source="S5, step 6; size is the mass, cost is as entered"),
        given("sel_pair", "Pair shown", "", "",
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
    task, sizes = view.task, view.sizes
    sheet.heading("What the load asks for")
    sheet.rows(
        calc("sel_wrms", "RMS acceleration of the load", "ω̇_L,rms", "rad/s²",
             f"={load.acceleration_rms}", task.acceleration_rms,
             source="over the cycle", scale=sizes.acceleration_rms),
        calc("sel_trms", "RMS of the generalized load torque", "T*_L,rms", "Nm",
             f"={load.torque_rms}", task.torque_rms, source="T*_L = T_L + J_L ω̇_L"),
        calc("sel_mean", "Mean of their product", "", "W/s",
             f"={load.power_rate_mean}", task.power_rate_mean, scale=max(sizes.power_rate_mean, 1e-3)),
        calc("sel_wmax", "Largest speed of the load", "ω_L,max", "rad/s", f"={load.max_speed}", task.max_speed),
        calc("sel_tmax", "Torque that the reducer must hold", "f T*_L,max", "Nm",
             f"=sel_factor*MAX(MAX({load.torque}),0-MIN({load.torque}))", view.torque_needed),
        calc("sel_moves", "The load accelerates, and has a torque", "", "",
             "=IF(MIN(sel_wrms,sel_trms,sel_wmax)>sel_none,1,0)", int(task.moves),
             source="1 yes, 0 no: then there is nothing to select"),
        result("sel_beta", "Load factor", "β", "W/s",
               "=IF(sel_moves=1,2*(sel_wrms*sel_trms+sel_mean),0)", view.load_factor,
               source="2 (ω̇_rms T*_rms + mean); S5, eq. (15), step 2"),
    )  # fmt: skip


def outcome(sheet: Sheet, view: Choosing) -> None:
    """Declare the pair, what it does, and step 7's checks."""
    pair, points = view.pair, view.points
    sheet.heading("Results")
    sheet.rows(
        result("sel_message", "In words", "", "", MESSAGE, message(view), align="left"),
        result("sel_motor_used", "Motor", "", "",
               '=IF(sel_found=1,INDEX([motors.name],sel_m),"none")',
               view.motors.names[pair.motor] if pair else "none", align="left"),
        result("sel_reducer_used", "Reducer", "", "",
               '=IF(sel_found=1,INDEX([reducers.name],sel_r),"none")',
               view.reducers.names[pair.reducer] if pair else "none", align="left"),
        result("sel_usable", "Pairs that can do it", "", "",
               "=SUM([pairs.usable])", int(view.usable.sum()),
               source="steps 3 to 5, with each reducer's own η, inertia and limits"),
        result("sel_count", "… of these, ranked", "", "",
               "=SUM([pairs.counts])", len(view.ranking),
               source="those that have the figures that the criterion reads"),
        result("sel_rms", "RMS torque of the motor", "T_M,rms", "Nm",
               "=SQRT(SUM([pair_cycle.part])/([pair_cycle.time.last]-[pair_cycle.time.first]))", points.rms_torque,
               source="over the table; losses help to brake"),
        result("sel_margin", "Margin", "", "",
               "=IF(sel_rms>0,sel_rated/sel_rms,0)", pair.margin(points) if pair else 0.0, source="T_M,N / T_M,rms"),
        result("sel_torque", "Peak torque of the motor", "T_M,max", "Nm",
               "=MAX(MAX([pair_cycle.torque]),0-MIN([pair_cycle.torque]))", points.peak_torque),
        result("sel_spare", "Least reserve below the motor's curve", "", "Nm",
               "=MIN([pair_cycle.spare])", float(view.reserve.min()),
               source="peak torque at the speed of that instant less |T_M|", scale=peak_size(view)),
        result("sel_speed", "Largest speed of the motor", "n_M", "rpm",
               "=MAX(MAX([pair_cycle.rpm]),0-MIN([pair_cycle.rpm]))", shown(points.max_speed, RPM)),
        result("sel_balance", "Ratio over the best ratio", "τ/τ_opt", "",
               "=IF(sel_moves*sel_found=1,sel_tau/SQRT(sel_j/10000*sel_wrms*sel_er/sel_trms),0)",
               pair.balance(view.task) if pair and view.task.moves else 0.0,
               source="1: motor and load balanced, with the reducer's η and inertia"),
        result("sel_nojt", "Reducers whose inertia is not given", "", "",
               "=SUM([reducers.on])-COUNT([reducers.inertia])", sum(r.inertia is None for r in view.given.reducers),
               source="it counts as 0"),
    )  # fmt: skip
    sheet.checks(*verdicts(view))


def peak_size(view: Choosing) -> float:
    """Return the motor's peak torque (Nm): a reserve near 0 is the difference of two such."""
    return max(float(view.motors.peak_torque[view.pair.motor]) if view.pair else 0.0, 1e-3)


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
    if not view.task.moves:
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
    held = [c.ok for c in found] or filled([], len(LIMITS), False)
    there = bool(found) and view.task.moves
    return [check("sel_ok", "Selection: a motor and a reducer are found", "sel_found*sel_moves=1", there,
                  says=Said("sel_message", message(view)))] + [
        check(name, label, f"AND(sel_found=1,{condition})", ok, says=says)
        for (name, label, condition), ok, says in zip(LIMITS, held, beyond(view), strict=True)
    ]  # fmt: skip


def beyond(view: Choosing) -> list[Said]:
    """Return what step 7's checks say where they do not hold."""
    if view.checks:
        rms, _, speed, entered, torque = [(c.value, c.limit) for c in view.checks]
        least = float(view.reserve.min())
    else:
        rms = speed = entered = torque = (0.0, 0.0)
        least = 0.0
    told = (
        exceeding("sel_rms", "sel_rated", "Nm", *rms),
        amount("sel_spare", least, "", " Nm are left below the curve"),
        exceeding("sel_speed", "sel_nmax", "rpm", *(shown(n, RPM) for n in speed)),
        exceeding("sel_speed", "sel_nlimit", "rpm", *(shown(n, RPM) for n in entered)),
        exceeding("sel_tmax", "sel_tlimit", "Nm", *torque),
    )
    return [Said(f'IF(sel_found=1,{one.says},"{NO_PAIR}")', one.said if view.checks else NO_PAIR) for one in told]


NO_PAIR = "there is no motor with a reducer"
