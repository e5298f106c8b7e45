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
    arm = e.arm
    swinging = [] if arm is None else [
        given("@arm_mass", "Arm: its mass", "m_a", "kg", arm.mass, f"{key}.load.arm.mass", format="0.0##",
              source="its inertia is entered above"),
        given("@arm_radius", "Arm: its centre of mass from the axis", "r_a", "mm", arm.radius,
              f"{key}.load.arm.radius", format="0.0##"),
        given("@arm_angle", "Arm: above the horizontal where the axis is at 0", "φ_0", "°", arm.angle,
              f"{key}.load.arm.angle", format="0.0##"),
    ]  # fmt: skip
    return [
        given(f"@{name}", label, symbol, unit, getattr(e, name), f"{key}.load.{name}",
              format="General" if unit == "kg cm²" else "0.0##", source=source)
        for name, label, symbol, unit, source in (*rows, *([] if e.viscous is None else [viscous]))
    ] + swinging  # fmt: skip
