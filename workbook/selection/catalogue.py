"""One product of a catalogue: what is known of it, and the rules that its figures obey."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from workbook.book.limits import RowRule
from workbook.fields.texts import LOOKED_UP, NO_FORMULA, ONE_LINE
from workbook.fields.types import DesignError, Model, NotNegative, Positive

Name = Annotated[str, Field(min_length=1, max_length=60, pattern=NO_FORMULA), LOOKED_UP]
Source = Annotated[str, Field(min_length=1, max_length=200, pattern=NO_FORMULA), ONE_LINE]
Efficiency = Annotated[float, Field(gt=0, le=1, allow_inf_nan=False)]
Factor = Annotated[float, Field(ge=1, allow_inf_nan=False)]
FULL_CYCLES = 1000.0  # an hour: up to so many makers tell the torque of a reducer that accelerates


class MotorRow(Model):
    """One motor of the catalogue.

    The continuous torque falls from ``stall_torque`` to ``rated_torque`` at ``rated_speed``; empty ones count as the
    rated torque and as the largest speed. The peak torque is given up to ``max_speed``, or falls in a straight line
    from ``full_torque_to`` to ``end_torque`` there.
    """

    name: Name
    inertia: Positive  # kg cm²
    stall_torque: Positive | None = None  # Nm
    rated_torque: Positive  # Nm
    rated_speed: Positive | None = None  # rpm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm
    full_torque_to: NotNegative | None = None  # rpm
    end_torque: NotNegative | None = None  # Nm
    copper_losses: NotNegative | None = None  # kW, of its winding at the rated torque
    shaft: NotNegative | None = None  # mm
    mass: NotNegative | None = None  # kg
    cost: NotNegative | None = None
    source: Source | None = None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield half a curve, or a curve that falls beyond the largest speed."""
        if (self.full_torque_to is None) != (self.end_torque is None):
            missing = "full_torque_to" if self.full_torque_to is None else "end_torque"
            problem = "half of the torque–speed curve is empty; expected both figures, or neither"
            yield DesignError(missing, problem, 0.0)
        if self.full_torque_to is not None and self.full_torque_to >= self.max_speed:
            problem = f"the torque falls from {self.full_torque_to:g} rpm; expected less than the largest speed"
            yield DesignError("full_torque_to", problem, 0.0)


HALF = RowRule("half", "COUNT([knee],[end])<>1", "knee", "half of the curve is empty: peak torque up to")
FALLING = RowRule("falling", "OR(COUNT([knee])=0,[knee]+0<[nmax])", "knee", "peak torque up to the largest speed")


class ReducerRow(Model):
    """One reducer of the catalogue; inertia and no-load torque that are not given count as 0, a limit as none.

    Beyond ``full_cycles`` an hour (1,000 if not given) the largest output torque counts over ``cycle_factor``.
    """

    name: Name
    reduction: Positive  # ω_M/ω_L
    efficiency: Efficiency
    inertia: NotNegative | None = None  # kg cm², at the motor's shaft
    no_load_torque: NotNegative | None = None  # Nm, at the motor's shaft: T_012
    max_speed: Positive | None = None  # rpm, of the input
    max_torque: Positive | None = None  # Nm, of the output
    full_cycles: Positive | None = None  # 1/h, up to which the largest output torque holds
    cycle_factor: Factor | None = None  # f_s: divides that torque beyond
    mean_torque: Positive | None = None  # Nm, of the output: T2N
    hub: Positive | None = None  # mm, the largest shaft of a motor that it takes
    mass: NotNegative | None = None  # kg
    cost: NotNegative | None = None
    source: Source | None = None
