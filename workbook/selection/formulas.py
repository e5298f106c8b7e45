"""What a motor does behind a reducer, as formulas: of J, i and η, from what the axis asks for."""

from __future__ import annotations

from workbook.selection.choosing import Choosing

MIXED = "@product/{eta}+@product_back*{eta}"
"""the mean of α S, of the shaft's acceleration and the load's torque before the reducer's losses"""
SQUARE = "(@square/{eta}^2+@square_back*{eta}^2)/{i}^2"
"""the mean square of the load's torque at the motor"""


def whole(view: Choosing, table: str) -> str:
    """Return the range of a table of all pairs."""
    return f"[@{table}1.v.first]:[@{table}{view.rooms[1]}.v.last]"


def torque_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the torques of a motor at the points of the cycle."""
    return f"{inertia}*{ratio}*@al+(@driving/{eta}+(@S-@driving)*{eta})/{ratio}"


def peak_of(inertia: str, ratio: str, eta: str) -> str:
    """Return the formula of the peak torque of a motor; no program takes ABS of an array in MAX alike."""
    return f"SUMPRODUCT(MAX(({torque_of(inertia, ratio, eta)})^2))^0.5"


def rms_of(inertia: str, ratio: str, mixed: str, square: str) -> str:
    """Return the formula of the RMS torque of a motor: √((J i)² α_rms² + 2 J mean(α S') + mean(S'²)/i²)."""
    return f"SQRT(MAX(0,({inertia}*{ratio})^2*@own+2*{inertia}*{mixed}+{square}))"
