"""The shaft that a motor and a reducer are chosen for: what it asks of them, and where its book has that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from engine.drive.quadrature import COUNT
from engine.laws.base import Array
from engine.selection.point_load import PointLoad
from workbook.book.rows import filled


class Figure(NamedTuple):
    """A figure of a shaft or of its drive: the formula of its cell without ``=``, the engine's value, its scale."""

    name: str
    label: str
    unit: str
    formula: str
    value: float
    scale: float = 0.0


@dataclass(frozen=True)
class Shaft:
    """A shaft behind a reducer, with the pair that drives it.

    ``title`` is the formula of its axis' name. ``columns`` begins the names of the columns of its points in the book
    (``dir``, ``al``, ``S``, ``n``); they have ``rows`` intervals, spare ones among them. ``rpm`` makes |speed| of the
    shaft (rpm) of the column ``n``. ``turning`` is the scale of ω̇ (rad/s²), ``torque`` that of S (Nm).
    """

    name: str
    number: int
    title: str
    columns: str
    rows: int
    load: PointLoad
    rpm: str
    turning: float
    torque: float
    figures: Sequence[Figure]

    @cached_property
    def values(self) -> dict[str, float]:
        """The engine's value of each figure."""
        return {one.name: one.value for one in self.figures}

    @property
    def product(self) -> float:
        """The scale of means of ω̇ S (W/s)."""
        return self.turning * self.torque

    def by_point(self, values: Array) -> list[float]:
        """Return values of the points as a column; spare rows have that of the last."""
        flat = values.ravel()
        return filled(flat, self.rows * COUNT, float(flat[-1]))
