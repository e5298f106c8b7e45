"""Scales: in SI a formula leaves a number such as 2π; where it leaves 1000 or 60, a conversion is missing or twice."""

import math
from collections.abc import Iterator
from functools import lru_cache

from workbook.audit.finding import Finding
from workbook.audit.lines import Lines
from workbook.audit.units import MILLIONTHS, NOTHING, Units, converts, once
from workbook.book.address import Address
from workbook.book.columns import Node, tree
from workbook.book.formula import Area, FormulaError
from workbook.dimensions.rules import number_of
from workbook.dimensions.units import NONE, size_of

QUOTIENTS = {"π/180": math.pi / 180, "1000/60": 1e3 / 60}
CONVERSIONS = {
    name: QUOTIENTS.get(name) or float(name.replace(",", ""))
    for name in "1000 1,000,000 60 3600 25.4 π/180 1000/60 3.6 100 10,000 9.81 360".split()
}
EXACT = 1.5e-3  # by which 9.55 and 30/π, 9550 and 60,000/2π deviate
SHARES = 2  # below which a number of per cent may be a share
TRIGONOMETRY = frozenset(["SIN", "COS", "TAN"])
SAME = frozenset("SUM AVERAGE MAX MIN ABS ROUND ROUNDUP ROUNDDOWN MEDIAN LARGE SMALL INDEX".split())


class Scales:
    """The formula of a cell by its scales: a key is its number in SI, over the sizes of its units."""

    def __init__(self, sizes: dict[Address, float], arguments: tuple[Area | str, ...]) -> None:
        self.sizes, self.arguments = sizes, arguments
        self.wrong: list[str] = []

    def of(self, node: Node) -> float | None:
        """Return the key of a node, None where it is not known."""
        if node.kind == "number":
            return float(node.value) if converts(float(node.value)) else None
        if node.kind == "argument":
            return self.argument(self.arguments[int(node.value)])
        if node.kind == "call":
            return self.call(str(node.value), node)
        return self.operation(node) if node.kind == "operation" else None

    def operation(self, node: Node) -> float | None:
        """Return the key of an operation, and note parts of a sum that are of unlike scales."""
        keys = [self.of(part) for part in node.parts]
        a, b, sign = keys[0], keys[-1], str(node.value)
        if len(keys) == 1 or a is None or b is None:
            return a if len(keys) == 1 else None
        if sign in "+-" and a * b:
            if (factor := missing(a / b)) and not any(map(constant, node.parts)):
                self.wrong.append(f"the parts of a sum are of scales that differ by {factor}")
            return a
        is_power = sign == "^" and node.parts[1].kind == "number" and a > 0 and abs(b) <= 6
        return number_of(sign, a, b) if is_power or sign in "*/" else None

    def argument(self, area: Area | str) -> float | None:
        """Return the key of a cell, or of a range of cells of the same unit."""
        if isinstance(area, str):
            return None
        cells = [area.first] if area.single else [area.first, Address(area.sheet, area.bottom, area.left)]
        sizes = {self.sizes.get(cell) for cell in cells}
        size = sizes.pop()
        return None if sizes or not size else 1.0 / size

    def call(self, name: str, node: Node) -> float | None:
        """Return the key of a call."""
        keys = [self.of(part) for part in node.parts]
        first = keys[0] if keys else None
        if name == "PI":
            return math.pi
        if name in TRIGONOMETRY:
            if first is not None and node.parts[0].kind == "argument" and close_to(first, 180 / math.pi):
                self.wrong.append(f"{name} of degrees")
            return 1.0
        if name == "SQRT" and first is not None and first >= 0:
            return math.sqrt(first)
        if name in ("RADIANS", "DEGREES") and first is not None:
            return first * (math.pi / 180 if name == "RADIANS" else 180 / math.pi)
        return first if name in SAME else None


def constant(node: Node) -> bool:
    """Whether a node is built of numbers alone."""
    return node.kind == "number" or (node.kind == "operation" and all(map(constant, node.parts)))


def close_to(a: float, b: float) -> bool:
    """Whether two numbers are the same but for what conversions round off."""
    return math.isclose(a, b, rel_tol=EXACT)


PARTS = (1, 2, 3, 4, 5, 6, 8, 12, 16, 32, 64)
SIMPLE = sorted({p / q * math.pi**k for p in range(1, 13) for q in PARTS for k in range(-2, 3)})


@lru_cache(maxsize=20_000)
def is_simple(number: float) -> bool:
    """Whether a number may stand in a law of physics: a small fraction, π, their products."""
    return any(close_to(number, simple) for simple in SIMPLE)


@lru_cache(maxsize=20_000)
def missing(number: float) -> str:
    """Return the conversion by which a number is off a simple one; nothing where it is simple, or off by no such."""
    number = abs(number)
    if not number or not math.isfinite(number) or is_simple(number) or is_simple(number / 9.81):
        return ""
    factors = [(name, power, number / size**power) for name, size in CONVERSIONS.items() for power in (1, -1, 2, -2)]
    exact = [factor for factor in factors if close_to(factor[2], 1.0)]
    for name, power, left in exact or factors:
        if is_simple(left):
            return name if abs(power) == 1 else f"{name} twice"
    return ""


def scales(lines: Lines, units: Units) -> Iterator[Finding]:
    """Yield formulas in which a conversion of units is missing, wrong or there twice."""
    view = lines.view
    rows = list[tuple[Address, str, str]]()
    known = dict[tuple[object, ...], list[str]]()
    sizes = {cell: size[1] for cell, u in units.of.items() if (size := (NONE, 1.0) if u in NOTHING else size_of(u))}
    for cell, value in view.numbers.items():
        if units.of.get(cell) == "%" and abs(value) <= SHARES:
            del sizes[cell]  # 0.15 or 15 %
    for cell, form in view.forms.items():
        if not form.areas or cell in units.checked or (formula := view.contents.formulas.get(cell)) is None:
            continue
        near = tuple(sizes.get(a.first) for a in form.areas)
        key = (
            formula.shape,
            sizes.get(cell),
            near,
            tuple(sizes.get(Address(a.sheet, a.bottom, a.left)) for a in form.areas),
        )
        if key not in known:
            known[key] = off_scale(Scales(sizes, formula.arguments), formula.shape, sizes.get(cell))
        rows += [(cell, "scale", why) for why in known[key]]
    yield from once(lines, rows)


def off_scale(reading: Scales, shape: str, size: float | None) -> list[str]:
    """Return the faults in the scales of a formula, in words."""
    try:
        key = None if MILLIONTHS.search(shape) else reading.of(tree(shape))
    except (FormulaError, RecursionError, OverflowError, ZeroDivisionError):
        return []
    wrong = list(reading.wrong)
    if not wrong and key and size and (factor := missing(key * size)):
        wrong.append(f"by its units it is off by a factor of {factor}: a conversion is missing, or there twice")
    return wrong


RULES = (scales,)
