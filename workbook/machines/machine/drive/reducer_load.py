"""The load of a reducer over a drive's cycle, whatever reducer and motor are: on the sheet of the drive.

With J all that turns with the motor, T = J i α + f S/i + T_nl d, f = 1/η where S drives the load and η where the load
drives it, d the direction: the squares of T are sums of means of α, S and d over the points of the cycle.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

from engine.selection.point_load import PointLoad
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Sheet
from workbook.machines.machine.drive import torques
from workbook.machines.machine.drive.entered import on_shaft
from workbook.machines.machine.drive.view import DriveView
from workbook.selection.pair_selection import NO_LIMIT, Shaft, load_figures, shaft_figures

CELLS = cell_tables(__file__)

DRIVES = '(([@pt.S]*[@pt.dir]>=0)+(@method="document")>0)'
BACK = '([@pt.S]*[@pt.dir]<0)*(@method="physical")'


def load_of(view: DriveView) -> PointLoad:
    """Return the engine's view of the load behind the reducer."""
    ratio = view.driven.reducer.ratio
    return PointLoad(view.load, view.speed / ratio, view.reducer_checks[0].value, behind_reducer(view) * ratio**2)


def behind_reducer(view: DriveView) -> float:
    """Return the inertia behind the reducer, at the motor (kg m²)."""
    return view.inertia - view.driven.mechanism.on_shaft(0)


def turns_of(view: DriveView) -> float:
    """Return the acceleration of the shaft behind the reducer over the one that the points have, φ̈ or ÿ."""
    return view.load.output_ratio if view.varies else view.driven.mechanism.ratio_from(1)


def means(sheet: Sheet, view: DriveView) -> None:
    """Declare the means over the cycle, and all else that depends on neither motor nor reducer."""
    cell = CELLS["means"].sharing(at_motor=view.driven.at_motor)
    free = "[@pt.free]" if view.brakes else '(1-([@pt.dir]=0)*(@holding="brake"))'
    between = "@is*" if view.driven.entered.stages else ""
    moved, turns = ("[@pt.al]", between) if view.varies else ("[@pt.a]", f"{between}@i2*")
    driving, driven = (f"[@pt.share]*{where}*{free}" for where in (DRIVES, BACK))
    figures = load_figures(load_of(view), view.scales.turning * view.load.output_ratio, view.scales.behind)
    parts = {
        "own": {"turns": turns, "moved": moved},
        "square": {"driving": driving},
        "square_back": {"driven": driven},
        "product": {"turns": turns, "driving": driving, "moved": moved},
        "product_back": {"turns": turns, "driven": driven, "moved": moved},
        "way": {},
        "way_turning": {"turns": turns, "moved": moved},
        "way_behind": {"driving": driving},
        "way_back": {"driven": driven},
        "speed": {},
    }
    cell.begin(sheet)
    sheet.rows(
        *(cell(f"@ask_{name}", figures[name][0], scale=figures[name][1], **of) for name, of in parts.items()),
        cell("@ask_turns", turns_of(view), turns=f"{turns}1" if view.varies or between else "@i2+0"),
        cell("@ask_inertia", figures["inertia"][0], inertia=torques.inertia(view.driven)),
        cell("@ask_beside", view.driven.beside_motor, on_shaft=on_shaft("motor")),
    )


def shaft_of(view: DriveView) -> Shaft:
    """Return the shaft behind the reducer of a drive, as the sheet Selection reads it."""
    d, motor, reducer = view.driven, view.driven.motor_used, view.driven.reducer
    load = load_of(view)
    turning = view.scales.turning * view.load.output_ratio
    behind = view.scales.behind
    rows = formulas_by_row(__file__, "as Selection reads it")
    formulas = dict(zip(rows["figure"], rows["reads"], strict=True))
    formulas |= {"brake": "0"} if view.brakes else {}
    values = {
        **load_figures(load, turning, behind),
        "cycles": view.cycles,
        "beside": d.beside_motor,
        "turns": turns_of(view),
        "brake": float(d.holding == "brake" and not view.brakes),
        "by_power": float(d.given.method == "physical"),
        "left": d.left,
        **dict(d.limits),
        "most_mass": d.limits.largest_mass or NO_LIMIT,
        "held_j": d.at_motor,
        "held_jm": motor.inertia,
        "held_i": reducer.ratio,
        "held_eta": reducer.efficiency,
        "held_no_load": reducer.no_load_torque,
        "held_row": motor.row,
        "held_gear": reducer.row,
        "held_hub": reducer.hub or NO_LIMIT,
        "held_room": (d.limits.largest_mass or NO_LIMIT) - reducer.known_mass,
    }
    figures = shaft_figures(f"drive{d.number}_", formulas, values)
    return Shaft(
        d.entered.name,
        d.number,
        f"=[axes.name.{d.number}]",
        f"drive{d.number}",
        view.rows,
        load,
        "ABS({})/@held_i",
        turning,
        behind,
        figures,
    )
