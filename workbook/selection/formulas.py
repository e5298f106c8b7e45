"""What a motor does behind a reducer, as formulas: of J, i and η, from what the axis asks for."""

from __future__ import annotations

from typing import Any

from workbook.selection.choosing import Choosing

MIXED = "@product/{eta}+@product_back*{eta}+{i}*{own}*@way_turning"
"""the mean of ω̇ S, of the shaft's acceleration and the load's torque before the reducer's losses, with its own"""
SQUARE = "(@square/{eta}^2+@square_back*{eta}^2)/{i}^2+2*{own}*(@way_behind/{eta}+@way_back*{eta})/{i}+{own}^2*@way"
"""the mean square of the load's torque at the motor, with the reducer's own"""


def whole(view: Choosing, table: str) -> str:
    """Return the range of a table of all pairs."""
    return f"[@{table}1.v.first]:[@{table}{view.rooms[1]}.v.last]"


def through(ratio: Any, efficiency: Any) -> tuple[Any, Any]:
    """Return what a reducer makes of a torque behind it at the motor: 1/(η i) of one that drives, else η/i."""
    return 1.0 / (efficiency * ratio), efficiency / ratio


def torque_of(inertia: str, ratio: str, out: str, back: str, own: str) -> str:
    """Return the formula of the torques of a motor at the points of the cycle; ``out`` is 1/(η i), ``back`` η/i."""
    return f"{inertia}*{ratio}*@al+{out}*@driving+{back}*@driven+{own}*@dir"


def peak_of(inertia: str, ratio: str, out: str, back: str, own: str) -> str:
    """Return the formula of the peak torque of a motor; no program takes ABS of an array in MAX alike."""
    return f"SUMPRODUCT(MAX(({torque_of(inertia, ratio, out, back, own)})^2))^0.5"


def rms_of(inertia: str, ratio: str, mixed: str, square: str) -> str:
    """Return the formula of the RMS torque of a motor: √((J i)² ω̇_rms² + 2 J mean(ω̇ S') + mean(S'²)/i²)."""
    return f"SQRT(MAX(0,({inertia}*{ratio})^2*@own+2*{inertia}*{mixed}+{square}))"
