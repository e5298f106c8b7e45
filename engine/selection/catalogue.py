"""Catalogues of motors and reducers as arrays. SI units."""

from dataclasses import dataclass, field, fields, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.motor import continuous
from engine.laws.base import Array

# defaults for all products
NO_LIMIT, NOT_GIVEN = partial(np.array, np.inf), partial(np.array, np.nan)


@dataclass(eq=False)
class Motors:
    """A catalogue of motors: arrays, or a number for all; NaN if not given. Raises ValueError for wrong figures."""

    names: tuple[str, ...]
    inertia: Array  # J_M (kg m²)
    rated_torque: Array  # T_M,N (Nm), continuous at the rated speed
    peak_torque: Array  # T_M,max (Nm), up to ``full_torque_to``
    max_speed: Array  # ω_M,max (rad/s)
    size: Array = field(default_factory=NOT_GIVEN)  # mass (kg)
    cost: Array = field(default_factory=NOT_GIVEN)  # in any currency
    # speed beyond which the peak torque falls (rad/s)
    full_torque_to: Array = field(default_factory=NOT_GIVEN)
    end_torque: Array = field(default_factory=NOT_GIVEN)  # peak torque at the largest speed (Nm)
    stall_torque: Array = field(default_factory=NOT_GIVEN)  # T_0 (Nm), continuous at standstill
    rated_speed: Array = field(default_factory=NOT_GIVEN)  # rad/s; NaN: the largest speed
    shaft: Array = field(default_factory=NOT_GIVEN)  # diameter of its shaft (m)

    def __post_init__(self) -> None:
        _columns(self, (), ("size", "cost", "full_torque_to", "end_torque", "stall_torque", "rated_speed", "shaft"))
        both = np.isnan(self.full_torque_to) == np.isnan(self.end_torque)
        _require(self, "end_torque", both, "wherever full_torque_to is one")
        _require(self, "full_torque_to", ~(self.full_torque_to >= self.max_speed), "below max_speed")
        # continuous torque at standstill (Nm)
        self.stall: Array = np.fmax(self.rated_torque, self.stall_torque)
        unknown = np.isnan(self.rated_speed)
        # speed of the rated torque (rad/s)
        self.falls_to = np.where(unknown, self.max_speed, self.rated_speed)
        # of the peak (rad/s)
        self.knee = np.where(np.isnan(self.full_torque_to), self.max_speed, self.full_torque_to)
        drop = np.nan_to_num(np.maximum(0.0, self.peak_torque - self.end_torque))
        beyond, none = self.max_speed - self.knee, np.zeros(drop.shape)
        # of the peak beyond the knee (Nm s)
        self.fall: Array = np.divide(drop, beyond, out=none, where=drop > 0.0)

    def derated(self, share: float) -> "Motors":
        """Return the motors with rated and stall torque times a share: see :func:`engine.drive.derating`."""
        return replace(self, rated_torque=self.rated_torque * share, stall_torque=self.stall_torque * share)

    def continuous(self, k: Any, speed: ArrayLike) -> Array:
        """Return the continuous torque (Nm) of the motors with the index ``k`` at mean speeds (rad/s)."""
        return continuous(self.rated_torque[k], self.stall[k], self.falls_to[k], speed)


@dataclass(eq=False)
class Reducers:
    """A catalogue of reducers: arrays, or a number for all; NaN if not given. Raises ValueError for wrong figures."""

    names: tuple[str, ...]
    reduction: Array  # i = ω_M/ω_L
    efficiency: Array  # η, at most 1
    inertia: Array  # J_T at the motor's shaft (kg m²)
    max_input_speed: Array  # rad/s
    max_output_torque: Array  # Nm, up to ``full_rate``; divided by ``cycle_factor`` beyond
    max_mean_torque: Array = field(default_factory=NO_LIMIT)  # cubic mean at the output (Nm)
    size: Array = field(default_factory=NOT_GIVEN)  # mass (kg)
    cost: Array = field(default_factory=NOT_GIVEN)  # in any currency
    # no-load torque at the input (Nm)
    no_load: Array = field(default_factory=lambda: np.array(0.0))
    full_rate: Array = field(default_factory=NO_LIMIT)  # cycles per second
    cycle_factor: Array = field(default_factory=lambda: np.array(1.0))  # f_s, 1 or more
    hub: Array = field(default_factory=NO_LIMIT)  # largest diameter of a motor's shaft that it takes (m)

    def __post_init__(self) -> None:
        _columns(self, ("inertia", "no_load", "cycle_factor"), ("size", "cost"))
        _require(self, "efficiency", self.efficiency <= 1.0, "at most 1")
        _require(self, "cycle_factor", self.cycle_factor >= 1.0, "1 or more")
        self.ratio = 1.0 / self.reduction  # τ = ω_L/ω_M


def _columns(catalogue: Motors | Reducers, other: tuple[str, ...], known: tuple[str, ...]) -> None:
    """Turn columns into arrays of a value for each name; raise ValueError for wrong values.

    Those in ``other`` may be 0, those in ``known`` NaN too.
    """
    catalogue.names = tuple(catalogue.names)
    count = len(catalogue.names)
    for column in (each.name for each in fields(catalogue)[1:]):
        values = np.asarray(getattr(catalogue, column), dtype=np.float64)
        if values.shape not in ((), (count,)):
            kinds = type(catalogue).__name__.lower()
            raise ValueError(f"{count} {kinds} are named and {values.size} values of {column} given")
        setattr(catalogue, column, np.broadcast_to(values, (count,)))
        may_be_zero = column in (*other, *known)
        holds = values >= 0.0 if may_be_zero else values > 0.0
        unknown = np.isnan(values) & (column in known)
        _require(catalogue, column, holds | unknown, "0 or more" if may_be_zero else "above 0")


def _require(catalogue: Motors | Reducers, column: str, holds: NDArray[np.bool_], expected: str) -> None:
    if not holds.all():
        k, kind = int(np.argmin(holds)), type(catalogue).__name__.lower()[:-1]
        value = getattr(catalogue, column)[k]
        raise ValueError(f"{kind} {catalogue.names[k]!r}: {column} is {value:g}; expected a number {expected}")
