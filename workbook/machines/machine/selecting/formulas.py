"""What a motor does behind a reducer, as formulas: of J, i and η, from what the axis asks for."""

from __future__ import annotations

from collections.abc import Sequence

from workbook.machines.machine.selecting.view import Choosing


def whole(view: Choosing, table: str) -> str:
    """Return the range of a table of all pairs."""
    return f"[@{table}1.v.first]:[@{table}{view.rooms[1]}.v.last]"


def torque_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the torques of a motor at the ends of all stretches."""
    return f"{inertia}*{ratio}*[@points.a]+[@points.driving]/({eta}*{ratio})+[@points.driven]*{eta}/{ratio}"


def largest(what: str, more: str = "") -> str:
    """Return the formula of the largest size of an array; programs take an array in MAX only within an array's sum."""
    one = "*([@points.k]=1)"
    plus, minus = (f"{sign}{more}" if more else "" for sign in "+-")
    return f"MAX(SUMPRODUCT(MAX({what}{plus}){one}),0-SUMPRODUCT(MIN({what}{minus}){one}))"


def peak_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the peak torque of a motor."""
    return largest(torque_of(inertia, ratio, eta))


def spare_of(curve: Sequence[str], asked_peak: str, gears: Sequence[str]) -> str:
    """Return the formula of what is left at least below a motor's curve."""
    (peak, knee, fall), (inertia, ratio, eta) = curve, gears
    with_speed = largest(torque_of(inertia, ratio, eta), f"{fall}*{ratio}*30/PI()*[@points.w]")
    return f"MIN({peak}-{asked_peak},{peak}+{fall}*{knee}-{with_speed})"


def rms_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the RMS torque of a motor."""
    own = f"({inertia}*{ratio})^2*@own+2*{inertia}*(@product/{eta}+@product_back*{eta})"
    return f"SQRT(MAX(0,{own}+(@square/{eta}^2+@square_back*{eta}^2)/{ratio}^2))"
