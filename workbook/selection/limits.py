"""The limits that every drive keeps to, in cells: where they are entered, what each is called."""

from collections.abc import Iterator

from workbook.book.declare import Quantity, given
from workbook.selection.entries import Limits

LIMITS = (
    ("rms_reserve", "Least reserve of RMS torque", "", "continuous torque at the mean speed / T_rms"),
    ("peak_reserve", "Least reserve of peak torque", "", "motor's peak torque / largest torque; of its curve too"),
    ("speed_reserve", "Least reserve of speed", "", "motor's largest speed / largest speed"),
    ("inertia_ratio", "Largest inertia ratio", "", "inertia at the motor / the motor's"),
    ("torque_factor", "Factor on the reducer's torque", "K_A", "for shocks or many cycles an hour, as its maker says"),
)  # fmt: skip
"""of each limit its entry, what it is called, its symbol and a note"""


def limit_cells(limits: Limits) -> Iterator[Quantity]:
    """Yield the rows in which the limits of all drives are entered."""
    for name, words, symbol, source in LIMITS:
        yield given(f"limits_{name}", words, symbol, "", getattr(limits, name), f"limits.{name}", format="0.0##",
                    source=source)  # fmt: skip
