"""What a drive's cycle asks for behind its reducer, whatever that and the motor are: on the sheet of the drive.

With J all that turns with the motor, T = J i α + f S/i + T_nl d, f = 1/η where S drives the load and η where the load
drives it, d the direction: the squares of T are sums of means of α, S and d over the points of the cycle.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

import numpy as np

from engine.selection.point_load import PointLoad
from workbook.book.declare import Sheet, calc
from workbook.machines.machine.drive import brake
from workbook.machines.machine.drive.entered import on_shaft
from workbook.machines.machine.drive.points import asks
from workbook.machines.machine.drive.view import DriveView
from workbook.selection.shaft import Figure, Shaft, figures

DRIVES = '(([@pt.S]*[@pt.dir]>=0)+(@method="document")>0)'
BACK = '([@pt.S]*[@pt.dir]<0)*(@method="physical")'


def load_of(view: DriveView) -> PointLoad:
    """Return the engine's view of what the cycle asks for."""
    ratio = view.driven.reducer.ratio
    inertia = (view.inertia - view.driven.mechanism.on_shaft(0)) * ratio**2
    return PointLoad(view.load, view.speed / ratio, view.reducer_checks[0].value, inertia)


def turning(view: DriveView) -> float:
    """Return how large the acceleration of the shaft grows (rad/s²)."""
    return max(float(np.abs(view.load.shaft_acceleration).max()), 1e-9)


def turns_of(view: DriveView) -> float:
    """Return the acceleration of the shaft behind the reducer over the one that the points have, φ̈ or ÿ."""
    return 1.0 if view.varies else view.driven.mechanism.ratio_from(1)


def means(sheet: Sheet, view: DriveView) -> None:
    """Declare the means over the cycle, and what else hangs on no motor and no reducer."""
    if not asks(view):
        return
    driven, load, alpha, behind = view.driven, load_of(view), turning(view), view.scales.behind
    own, mixed, mixed_back, square, square_back, *ways = load.squares

    free = "[@pt.free]" if brake.known(view) else '(1-([@pt.dir]=0)*(@holding="brake"))'
    column, by = ("al", "") if view.varies else ("a", "@i2*")

    def mean(where: str, one: str, by: str = "") -> str:
        return f"={by}SUMPRODUCT([@pt.share]*{where}*{free},[@pt.{one}],[@pt.S])"

    sheet.heading(
        "Workings: what Selection needs", "Of the shaft behind the reducer: α its acceleration, S its torque."
    )
    sheet.rows(
        calc("@ask_own", "Mean of α²", "⟨α²⟩", "rad²/s⁴",
             f"={by}{by}SUMPRODUCT([@pt.share],[@pt.{column}],[@pt.{column}])", own,
             scale=alpha**2),
        calc("@ask_square", "Mean of S² where it drives the load", "⟨S²⟩", "Nm²", mean(DRIVES, "S"), square,
             scale=behind**2),
        calc("@ask_square_back", "… where the load drives it", "", "Nm²", mean(BACK, "S"), square_back,
             scale=behind**2),
        calc("@ask_product", "Mean of α S where it drives the load", "⟨αS⟩", "W/s", mean(DRIVES, column, by), mixed,
             scale=alpha * behind),
        calc("@ask_product_back", "… where the load drives it", "", "W/s", mean(BACK, column, by), mixed_back,
             scale=alpha * behind),
        calc("@ask_way", "Share of the cycle in motion", "⟨d²⟩", "", "=SUMPRODUCT([@pt.share],[@pt.dir],[@pt.dir])",
             ways[0], source="d: 1 forward, −1 backward"),
        calc("@ask_way_turning", "Mean of α d", "⟨αd⟩", "rad/s²",
             f"={by}SUMPRODUCT([@pt.share],[@pt.{column}],[@pt.dir])", ways[1], scale=alpha),
        calc("@ask_way_behind", "Mean of S d where it drives the load", "⟨Sd⟩", "Nm", mean(DRIVES, "dir"), ways[2],
             scale=behind),
        calc("@ask_way_back", "… where the load drives it", "", "Nm", mean(BACK, "dir"), ways[3], scale=behind),
        calc("@ask_speed", "Largest speed", "ω", "rad/s", "=@speed*PI()/30/@i1", load.speed),
        calc("@ask_turns", "Acceleration of that shaft over the one that the points have", "", "",
             "=1" if view.varies else "=@i2+0", turns_of(view), source="the load's, of a constant ratio"),
        calc("@ask_inertia", "Inertia", "J", "kg m²", "=@j_shaft+0", load.inertia),
        calc("@ask_beside", "Inertia of parts on the motor's shaft", "", "kg m²", f"={on_shaft('motor')}",
             driven.beside_motor, scale=driven.at_motor),
    )  # fmt: skip


def shaft_of(view: DriveView) -> Shaft:
    """Return the shaft behind the reducer of a drive, as the sheet Selection reads it."""
    d, load = view.driven, load_of(view)
    return Shaft(d.entered.name, d.number, f"=[axes.name.{d.number}]", f"drive{d.number}", view.rows, load,
                 "ABS({})/@held_i", turning(view), view.scales.behind, figures_of(view, load))  # fmt: skip


def figures_of(view: DriveView, load: PointLoad) -> list[Figure]:
    """Return what the sheet of a drive has of the shaft behind its reducer, and of its motor."""
    d, alpha, behind, torque = view.driven, turning(view), view.scales.behind, view.scales.torque
    own, mixed, mixed_back, square, square_back, *ways = load.squares
    top, motor = view.reserve.peak_torque.value, d.motor_used
    spare, left = "@motor_peak-MAX(@tmax,0-@tmin)", d.motor.peak_torque - top
    rest = ("0", 0.0) if brake.known(view) else ('(@holding="brake")', float(d.holding == "brake"))
    if view.knows_falling:
        spare, left = "@spare", view.spare
    return figures(f"drive{d.number}_", {
        "own": ("@ask_own", own, alpha**2), "square": ("@ask_square", square, behind**2),
        "square_back": ("@ask_square_back", square_back, behind**2), "product": ("@ask_product", mixed, alpha * behind),
        "product_back": ("@ask_product_back", mixed_back, alpha * behind), "way": ("@ask_way", ways[0]),
        "way_turning": ("@ask_way_turning", ways[1], alpha), "way_behind": ("@ask_way_behind", ways[2], behind),
        "way_back": ("@ask_way_back", ways[3], behind), "speed": ("@ask_speed", load.speed),
        "mean": ("@mean*PI()/30/@i1", load.mean_speed), "smax": ("@smax", load.torque, behind),
        "smean": ("@smean", view.reducer_checks[1].value, behind), "cycles": ("@cycles", view.cycles),
        "inertia": ("@ask_inertia", load.inertia),
        "beside": ("@ask_beside", d.beside_motor), "brake": rest,
        "by_power": ('(@method="physical")', float(d.given.method == "physical")), "left": ("@derate", d.left),
        "held_j": ("@j0", d.at_motor), "held_jm": ("@jm", motor.inertia), "held_i": ("@i1", d.reducer.ratio),
        "held_eta": ("@eta1", d.reducer.efficiency), "held_no_load": ("@no_load", d.reducer.no_load_torque),
        "held_rated": ("@continuous", view.reserve.rms_torque.limit), "held_peak": ("@motor_peak", motor.peak_torque),
        "held_top": ("MAX(@tmax,0-@tmin)", top, torque), "held_spare": (spare, left, torque),
        "held_nmax": ("@motor_nmax", motor.max_speed), "held_row": ("@motor_row", motor.row),
        "held_gear": ("@reducer_row", d.reducer.row), "turns": ("@ask_turns", turns_of(view)),
    })  # fmt: skip
