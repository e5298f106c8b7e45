"""A crank that drives a slide through its dead centres, in cells: its sizes, and where the slide is by the angle."""

import numpy as np

from engine.drive.mechanisms.by_angle import PressCrank as Crank
from engine.drive.quadrature import LoadPoints
from workbook.book.declare import Quantity, calc, given
from workbook.machines.machine.drive.driven import Driven, as_a
from workbook.machines.machine.drive.mechanisms import constant, slides
from workbook.machines.machine.drive.mechanisms.column import Column
from workbook.machines.machine.mechanism import PressCrank


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered."""
    e, key = as_a(PressCrank, driven.given), f"{key}.mechanism"
    return [
        *slides.crank(e, key, "slide"),
        given("@start_angle", "Angle of the crank where the axis is at 0", "φ_0", "°", e.start_angle,
              f"{key}.start_angle", format="0.0##", source="from the slide's line outwards; 0 if empty"),
    ]  # fmt: skip


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios, and of the crank in m and rad."""
    one = as_a(Crank, driven.by_angle)
    return [
        *constant.sizes(driven),
        calc("@r", "Crank", "r", "m", "=@crank_radius/1000", one.crank),
        calc("@l", "Rod", "l", "m", "=@rod_length/1000", one.rod),
        calc("@e", "Offset", "e", "m", "=@offset/1000", one.offset),
        calc("@psi0", "Angle of the crank where the axis is at 0", "φ_0", "rad", "=RADIANS(@start_angle)", one.start),
    ]


def columns(driven: Driven, load: LoadPoints, of: Column) -> list[Quantity]:
    """Return the columns of the slide: where it is by the crank's angle, its velocity and its acceleration."""
    one = as_a(Crank, driven.by_angle)
    psi, x = load.position + one.start, one.position(load.position)
    velocity, acceleration = load.moving
    size = one.crank
    return [
        calc("psi", "angle of the crank", "ψ", "rad", "=[y]+@psi0", of(psi), scale=max(float(np.abs(psi).max()), 1.0),
             source="φ + φ_0"),
        *slides.pin(size, psi, of),
        calc("X", "slide from the shaft", "x", "m", "=[c]+SQRT(@l^2-([above]-@e)^2)", of(x), scale=one.rod,
             source="c + √(l² − (s − e)²)"),
        *slides.travel(size, one.offset, psi, x, of),
        calc("vs", "velocity of the slide", "ẋ", "m/s", "=[dx]*[v]", of(velocity),
             scale=size * max(float(np.abs(load.velocity).max()), 1e-9), source="dx/dψ φ̇"),
        calc("as", "acceleration of the slide", "ẍ", "m/s²", "=[dx]*[a]+[ddx]*[v]^2", of(acceleration),
             scale=max(float(np.abs(acceleration).max()), 1e-9), source="dx/dψ φ̈ + d²x/dψ² φ̇²"),
    ]  # fmt: skip
