"""What a drive's cycle asks for behind its reducer, whatever that and the motor are: on the sheet of the drive.

With J all that turns with the motor, T = J i α + f S/i, f = 1/η where S drives the load and η where the load drives it:
the squares of T are sums of five means of α and S, over the points of the cycle.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from engine.machine.point_load import PointLoad
from workbook.book.declare import Sheet, calc
from workbook.machines.machine.drive.points import asks
from workbook.machines.machine.drive.view import DriveView

DRIVES = '(([@pt.S]*[@pt.dir]>=0)+(@method="document")>0)'
BACK = '([@pt.S]*[@pt.dir]<0)*(@method="physical")'
FREE = '(1-([@pt.dir]=0)*(@holding="brake"))'
"""0 where a brake holds the motor's shaft"""


class Scales(NamedTuple):
    """How large α grows (rad/s²), and the means ⟨α²⟩, ⟨αS⟩ and ⟨S²⟩."""

    alpha: float
    turned: float
    product: float
    square: float


def load_of(view: DriveView) -> PointLoad:
    """Return the engine's view of what the cycle asks for."""
    ratio = view.driven.reducer.ratio
    inertia = (view.inertia - view.driven.mechanism.on_shaft(0)) * ratio**2
    return PointLoad(view.load, view.speed / ratio, view.reducer_checks[0].value, inertia)


def scales_of(view: DriveView) -> Scales:
    """Return how large the means are."""
    alpha, behind = max(float(np.abs(view.load.turning).max()), 1e-9), view.scales.behind
    return Scales(alpha, alpha**2, alpha * behind, behind**2)


def means(sheet: Sheet, view: DriveView) -> None:
    """Declare the five means over the cycle, and what else hangs on no motor and no reducer."""
    if not asks(view):
        return
    driven, scale, load = view.driven, scales_of(view), load_of(view)
    own, mixed, mixed_back, square, square_back = load.squares

    def mean(where: str, one: str) -> str:
        return f"=SUMPRODUCT([@pt.share]*{where}*{FREE},[@pt.{one}],[@pt.S])"

    sheet.heading(
        "Workings: what Selection needs", "Of the shaft behind the reducer: α its acceleration, S its torque."
    )
    sheet.rows(
        calc("@ask_own", "Mean of α²", "⟨α²⟩", "rad²/s⁴", "=SUMPRODUCT([@pt.share],[@pt.al],[@pt.al])", own,
             scale=scale.turned),
        calc("@ask_square", "Mean of S² where it drives the load", "⟨S²⟩", "Nm²", mean(DRIVES, "S"), square,
             scale=scale.square),
        calc("@ask_square_back", "… where the load drives it", "", "Nm²", mean(BACK, "S"), square_back,
             scale=scale.square),
        calc("@ask_product", "Mean of α S where it drives the load", "⟨αS⟩", "W/s", mean(DRIVES, "al"), mixed,
             scale=scale.product),
        calc("@ask_product_back", "… where the load drives it", "", "W/s", mean(BACK, "al"), mixed_back,
             scale=scale.product),
        calc("@ask_speed", "Largest speed", "ω", "rad/s", "=@speed*PI()/30/@i1", load.speed),
        calc("@ask_inertia", "Inertia", "J", "kg m²", "=@j_shaft+0", load.inertia),
        calc("@ask_beside", "Inertia of parts on the motor's shaft", "", "kg m²", "=@j0-@jm-@j_reducer",
             driven.beside_motor, scale=driven.at_motor),
    )  # fmt: skip
