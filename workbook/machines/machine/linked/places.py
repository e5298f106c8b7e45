"""The drive at a place of the motion in cells: position, ratio, force and torques, each by one formula."""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from engine.machine.places import Held, Worked
from workbook.book.declare import Quantity, calc
from workbook.machines.machine.linked import kinds
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.motion.sampled import derivative


def columns(view: PlacedWork, at: Worked, helds: list[Held], u: Array, mark: str = "") -> list[Quantity]:
    """Return the columns of a table that has the place ``u`` in a piece and the stretch ``st``; a mark ends names."""
    rows, base, hardest = view.one.pieces, view.base, view.driven.axis.hardest
    om, ph = (rows.at.of_piece(name, f"q{mark}") for name in ("om", "ph"))
    position = [
        calc(f"p{mark}", "position", "y", base, f"={derivative(rows, 0, mark)}", at.y,
             scale=view.driven.axis.motion.size(0)),
    ] if view.varies else []  # fmt: skip
    return [
        calc(f"q{mark}", "piece", "q", "", "=INDEX([@st.q],[st])", [view.number_of(one) for one in helds], format="0"),
        calc(f"x{mark}", "sine argument", "x", "rad", f"={om}*[u{mark}]+{ph}",
             [float(one.argument(place)) for one, place in zip(helds, u, strict=True)]),
        *position,
        calc(f"v{mark}", "velocity", "ẏ", f"{base}/s", f"=({derivative(rows, 1, mark)})*@omega", at.v,
             scale=view.driven.axis.fastest),
        calc(f"a{mark}", "acceleration", "ÿ", f"{base}/s²", f"=({derivative(rows, 2, mark)})*@omega^2", at.a,
             scale=hardest),
        *turned(view, at, (f"[v{mark}]", f"[a{mark}]"), np.array([one.within for one in helds]), mark),
    ]  # fmt: skip


def turned(
    view: PlacedWork, at: Worked, rates: tuple[str, str], within: Array, mark: str = ""
) -> list[Quantity]:  # fmt: skip
    """Return the columns of force and torques, from velocity and acceleration; of a ratio that changes, behind ``p``.

    ``within`` are positions in the middle of each place's stretch.
    """
    sizes, (v, a), viscous = view.driven.sizes, rates, view.driven.entered.load.viscous is not None
    g, h, turning, force, behind = (f"[{name}{mark}]" for name in ("g", "h", "turn", "F", "S"))
    g, change = (g, f"{h}*{v}^2+") if view.varies else ("@i2", "")
    rubs, rubbing = (f"+@viscous*{v}", "c ẏ + ") if viscous else ("", "")
    at_st = "INDEX([@st.{}],[st])".format
    last = f"IF({force}*{at_st('dir')}<0,@back2,1/@eta2)*{force}/{g}"
    first = f"IF({behind}*{at_st('dir')}<0,@back1,1/@eta1)*{behind}/@i1"
    return [
        *(kinds.of(view.driven).ratios(view.driven, at, within, mark) if view.varies else ()),
        calc(f"w{mark}", "speed of the shaft", "φ̇", "rad/s", f"={g}*{v}", at.rate, scale=view.rate,
             source="φ' ẏ"),
        calc(f"turn{mark}", "acceleration of the shaft", "φ̈", "rad/s²", f"={change}{g}*{a}", at.turning,
             scale=view.acceleration_of_shaft, source="φ'' ẏ² + φ' ÿ" if view.varies else "φ' ÿ"),
        calc(f"F{mark}", "at the load", "F", view.force, f"=@m*{a}{rubs}+{at_st('r')}", at.force, scale=sizes.force,
             source=f"m ÿ + {rubbing}what resists"),
        calc(f"S{mark}", "behind the reducer", "S", "Nm", f"={at_st('acts')}*({last}+@j1*{turning})", at.behind,
             scale=sizes.behind, source="f_2 F/φ' + J_1 φ̈"),
        calc(f"T{mark}", "torque of the motor", "T", "Nm", f"={at_st('acts')}*({first}+@j0*@i1*{turning})", at.torque,
             scale=sizes.torque, source="f_1 S/i_1 + J_0 i_1 φ̈"),
    ]  # fmt: skip


def stacked(each: list[Worked]) -> Worked:
    """Return the drive at the places of several, one after the other."""
    return Worked(*(np.concatenate(column) for column in zip(*each, strict=True)))
