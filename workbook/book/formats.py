"""How numbers are shown: the format of a quantity's cells."""

from typing import Any

from workbook.book.quantity import Quantity

LOOKS = ((1.0, "0.0000"), (10.0, "0.000"), (100.0, "0.00"), (1000.0, "0.0"))  # below each size: four digits that count
NOISE = 1e-12  # rounding, of any unit and as a share of a value


def sample(q: Quantity) -> Any:
    """Return the value by whose size all cells of a quantity are shown: the only one, or the greatest of them."""
    if q.format or isinstance(q.value, str) or not hasattr(q.value, "__len__"):
        return q.value
    values = list(q.value)
    numbers = [v for v in values if isinstance(v, int | float) and not isinstance(v, bool)]
    return max(numbers, key=abs) if numbers else next(iter(values), None)


def number_format(q: Quantity, value: Any) -> str:
    """Return the format of a quantity: its own, or decimals that suit the size of its values."""
    if q.format:
        return q.format
    if isinstance(value, bool) or not isinstance(value, int | float):
        return "General"
    if isinstance(value, int):
        return "0"
    size = abs(value) * (1.0 + NOISE)  # 0.999… by rounding is shown as 1
    if size < NOISE:
        return LOOKS[0][1]
    if size < 1e-3 or size >= 1e6:
        return "0.000E+00"
    return next((look for limit, look in LOOKS if size < limit), "0")
