"""What a motor does behind a reducer, as formulas: of J, i and η, from what the axis asks for."""

from __future__ import annotations

from workbook.selection.choosing import Choosing


def whole(view: Choosing, table: str) -> str:
    """Return the range of a table of all pairs."""
    return f"[@{table}1.v.first]:[@{table}{view.rooms[1]}.v.last]"


def torque_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the torques of a motor at the points of the cycle."""
    behind = f"[@points.driving]/{eta}+([@points.S]-[@points.driving])*{eta}"
    return f"{inertia}*{ratio}*[@points.al]+({behind})/{ratio}"


def peak_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the peak torque of a motor; no program takes ABS of an array in MAX alike."""
    return f"SUMPRODUCT(MAX(({torque_of(inertia, ratio, eta)})^2))^0.5"


def rms_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the RMS torque of a motor."""
    own = f"({inertia}*{ratio})^2*@own+2*{inertia}*(@product/{eta}+@product_back*{eta})"
    return f"SQRT(MAX(0,{own}+(@square/{eta}^2+@square_back*{eta}^2)/{ratio}^2))"
