"""What is entered of an axis' load."""

from __future__ import annotations

from workbook.book.declare import Quantity, given
from workbook.machines.machine.drive.driven import Driven


def loads(driven: Driven, key: str) -> list[Quantity]:
    """Return the entries of the load of this kind."""
    e = driven.entered.load
    rows: tuple[tuple[str, str, str, str, str], ...] = (
        ("mass", "Mass that travels", "m", "kg", ""),
        ("friction", "Coefficient of friction", "μ", "", "opposes the motion"),
        ("slope", "Slope", "γ", "°", "rising with positive travel"),
        ("force", "Force against positive travel", "F", "N", "always, also at rest"),
    ) if driven.travels else (
        ("inertia", "Inertia that turns", "J", "kg cm²", ""),
        ("torque", "Torque against positive motion", "T", "Nm", "always, also at rest"),
        ("friction_torque", "Friction torque", "T_f", "Nm", "opposes the motion"),
    )  # fmt: skip
    viscous = ("viscous", "Viscous friction", "c", "N s/m" if driven.travels else "Nm s/rad", "c ẏ")
    return [
        given(f"@{name}", label, symbol, unit, getattr(e, name), f"{key}.load.{name}",
              format="General" if unit == "kg cm²" else "0.0##", source=source)
        for name, label, symbol, unit, source in (*rows, *([] if e.viscous is None else [viscous]))
    ]  # fmt: skip
