"""What a drive's cycle asks for behind its reducer, whatever that and the motor are: on the sheet of the drive.

With J all that turns with the motor, T = J i α + f S/i, f = 1/η where S drives the load and η where the load drives it:
the squares of T are sums of five means of α and S, and its peaks are at ends of stretches for every pair.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

from __future__ import annotations

from operator import methodcaller
from typing import NamedTuple

from engine.machine.bent import Away, away
from engine.machine.grid import Asked, Behind
from engine.machine.node_load import NodeLoad
from engine.machine.places import WEIGHTS, Held, Worked
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import total
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.stretches import BEHIND, LOST, ORDER, integral

FIRST, SECOND = (("1", "z0", "p1"),), (("2", "p1", "p2"), ("3", "p2", "z4"))
"""where the torque behind the reducer has the sign of what resists, and where it has the other"""


def asks(view: Stretched) -> bool:
    """Return whether the book has a sheet Selection, for which the sheet of a drive tells all this."""
    return view.one.machine.machine.selection.axis is not None


def load_of(view: Stretched) -> Asked:
    """Return the engine's view of what the cycle asks for."""
    demand = view.driven.demand
    if not isinstance(view, PlacedWork):
        return Behind(demand.course)
    return NodeLoad(demand, view.driven.inertia, sections(view))


def sections(view: PlacedWork) -> list[tuple[Held, Worked, float]]:
    """Return the drive at the nodes of each section, and how wide that is."""
    each = zip(view.placed, view.worked, view.widths, strict=True)
    return [(held, worked, width) for (held, _), worked, width in each]


def scales_of(view: Stretched) -> Away:
    """Return what the integrals are measured by."""
    sizes = view.driven.sizes
    if isinstance(view, PlacedWork):
        return away(sizes.behind, view.acceleration_of_shaft, 1.0)
    return away(sizes.behind, sizes.acceleration, view.driven.mechanism.ratio_from(1))


def columns(view: Stretched) -> list[Quantity]:
    """Return the columns of the stretches: ∫S² and ∫αS on both sides of where S turns round, ∫α², and the fastest."""
    if not asks(view):
        return []
    scale, ends = scales_of(view), [f"ABS({view.velocity(u)})" for u in ("[ub]", "[ue]")]
    turns = f"AND(MIN([yb],[ye])<0-{LOST},MAX([yb],[ye])>{LOST})"
    columns = []
    for n, lines in ((1, FIRST), (2, SECOND)):
        part = ORDER[lines[0][1]], ORDER[lines[-1][2]]
        where = f"on line{'s' if n > 1 else ''} {' and '.join(line for line, _, _ in lines)}"
        columns += [
            calc(f"bs{n}", f"∫S² {where}", "", "", over(view, lines, "{torque}^2"),
                 view.counted(methodcaller("behind", "square", part, scale.square)), scale=scale.square),
            calc(f"bp{n}", f"∫αS {where}", "", "", over(view, lines, "(0-[sign]*@i2*{y})*{torque}"),
                 view.counted(methodcaller("behind", "product", part, scale.product)), scale=scale.product),
        ]  # fmt: skip
    return [
        *columns,
        calc("bq", "∫α²", "", "", integral(view, "", "z0", "z4", "(@i2*{y})^2"),
             view.counted(lambda p: p.turned(scale.turned)), scale=scale.turned),
        calc("vm", "no faster than", "|y'|", "", f"=IF({turns},@vmax,MAX({','.join(ends)}))",
             view.of(lambda p: p.fastest_here), source="in the stretch"),
    ]  # fmt: skip


def over(view: Stretched, lines: tuple[tuple[str, str, str], ...], inner: str) -> str:
    """Return the formula of an integral over lines of the torque behind the reducer, in the direction of motion."""
    terms = []
    for line, low, high in lines:
        terms.append(integral(view, "", low, high, inner.replace("{torque}", BEHIND[line])).removeprefix("="))
    return f"={'+'.join(terms)}"


def means(sheet: Sheet, view: Stretched) -> None:
    """Declare the five means over the cycle, and what else hangs on no motor and no reducer."""
    if not asks(view):
        return
    driven, scale = view.driven, scales_of(view)
    load = load_of(view)
    own, mixed, mixed_back, square, square_back = load.squares
    asked = node_sums() if isinstance(view, PlacedWork) else sums()
    inertia = "@j1+@m/MAX([@sec.topg])^2" if isinstance(view, PlacedWork) and view.varies else "@j1+@m/@i2^2"
    sheet.heading(
        "Workings: what Selection needs", "Of the shaft behind the reducer: α its acceleration, S its torque."
    )
    sheet.rows(
        calc("@ask_own", "Mean of α²", "⟨α²⟩", "rad²/s⁴", f"={asked.own}/(2*PI())", own, scale=scale.turned),
        calc("@ask_square", "Mean of S² where it drives the load", "⟨S²⟩", "Nm²", driving(asked.square), square,
             scale=scale.square),
        calc("@ask_square_back", "… where the load drives it", "", "Nm²", driven_by_load(asked.square), square_back,
             scale=scale.square),
        calc("@ask_product", "Mean of α S where it drives the load", "⟨αS⟩", "W/s", driving(asked.product), mixed,
             scale=scale.product),
        calc("@ask_product_back", "… where the load drives it", "", "W/s", driven_by_load(asked.product), mixed_back,
             scale=scale.product),
        calc("@ask_speed", "Largest speed", "ω", "rad/s", "=@speed*PI()/30/@i1", load.speed),
        calc("@ask_inertia", "Inertia", "J", "kg m²", f"={inertia}", load.inertia),
        calc("@ask_beside", "Inertia of parts on the motor's shaft", "", "kg m²", "=@j0-@jm-@j_reducer",
             driven.beside_motor, scale=driven.at_motor),
    )  # fmt: skip


class Asks(NamedTuple):
    """Sums over the sheet of a drive: ∫α²; ∫S² and ∫αS, each where S drives the load and where the load drives it."""

    own: str
    square: tuple[str, str]
    product: tuple[str, str]


def sums() -> Asks:
    """Return them of the stretches of a drive of constant ratio."""
    held = "SUMPRODUCT([@st.on]*([@st.dir]=0)*([@st.ue]-[@st.ub])*([@st.hold]*@eta1*@i1)^2)"

    def of(mark: str, same: str, other: str) -> str:
        return "+".join(f"SUMPRODUCT([@st.{mark}{n}]*([@st.sign]{sign}0))" for n, sign in ((1, same), (2, other)))

    square, product = ((of(mark, ">", "<"), of(mark, "<", ">")) for mark in ("bs", "bp"))
    return Asks(total("@st.bq"), (f"{square[0]}+{held}", square[1]), product)


def node_sums() -> Asks:
    """Return them of the nodes of a drive that is worked out place by place."""

    def of(one: str, other: str) -> str:
        return f"SUMPRODUCT([@pl.wide],{one}*{other})"

    sides, alpha = ("([@pl.S]-[@pl.back])", "[@pl.back]"), "[@pl.turn]"
    (drives, back), product = (of(one, one) for one in sides), tuple(of(alpha, one) for one in sides)
    return Asks(of(alpha, alpha), (drives, back), (product[0], product[1]))


def driving(sides: tuple[str, str]) -> str:
    """Return the mean where S drives the load: by the document's losses, all of it."""
    return f'=({sides[0]}+IF(@method="document",{sides[1]},0))/(2*PI())'


def driven_by_load(sides: tuple[str, str]) -> str:
    """Return the mean where the load drives it."""
    return f'=IF(@method="document",0,({sides[1]})/(2*PI()))'


def node_columns(view: PlacedWork) -> list[Quantity]:
    """Return the columns of the nodes: what each counts in an integral, and the torque with which the load drives."""
    if not asks(view):
        return []
    nodes = [WEIGHTS.tolist() for _ in view.placed]
    load = NodeLoad(view.driven.demand, view.driven.inertia, sections(view))
    wide = "INDEX([@sec.on],[sec])*(INDEX([@sec.ue],[sec])-INDEX([@sec.ub],[sec]))/2"
    return [
        constant("weight", "weight", "", "", [weight for each in nodes for weight in each]),
        calc("wide", "counts", "", "rad", f"={wide}*[weight]", load.wide, scale=1.0),
        calc("back", "where the load drives", "S", "Nm", "=IF([S]*INDEX([@st.dir],[st])<0,[S],0)", load.back,
             scale=view.driven.sizes.behind),
    ]  # fmt: skip
