"""Machine descriptions: what an engineer enters, in the engineer's units, with the rules each entry obeys.

The same models read a ``machine.toml`` and the inputs of an edited workbook, so a rule is written once;
the validation that Excel shows beside a cell is derived from them too (:mod:`workbook.rules`).
"""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

LARGEST, SMALLEST = 1e12, 1e-12  # of any entry but 0: beyond, squares leave what a cell can hold
Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Field(gt=0, ge=SMALLEST, le=LARGEST)]
NotNegative = Annotated[float, Field(ge=0, le=LARGEST)]
Share = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)]
Angle = Annotated[float, Field(ge=0, le=360, allow_inf_nan=False)]
PLAIN = r"^[^=\x00-\x1f][^\x00-\x1f]*$"  # one line, no formula
Text = Annotated[str, Field(min_length=1, max_length=80, pattern=PLAIN)]
LawCode = Literal["DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN"]

SUM_TOLERANCE = 1e-9
ANGLE_TOLERANCE = 1e-9  # degrees


class EntryError(ValueError):
    """An entry that does not go with the others; ``field`` says which, below the model that found it."""

    def __init__(self, field: str, message: str) -> None:
        super().__init__(message)
        self.field = field


class Model(BaseModel):
    """Entries are taken as they are: no text becomes a number, no unknown entry is dropped."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)


class LawSheet(Model):
    """The rise that a law's own sheet shows in dimensional form."""

    lift: Number = 100.0  # mm
    time: Positive = 0.5  # s


class TrapezoidalVelocity(LawSheet):
    """Break points of the trapezoidal velocity profile as shares of the rise: S1's α_v/α_s and α_w/α_s."""

    rise_end: Annotated[float, Field(gt=0, le=1)] = 1 / 3
    fall_start: Annotated[float, Field(ge=0, lt=1)] = 2 / 3

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.fall_start < self.rise_end:
            raise EntryError(
                "fall_start",
                f"the second break point {self.fall_start:g} lies before the first; expected at "
                f"least {self.rise_end:g}",
            )
        return self


class ModifiedTrapezoidal(LawSheet):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = [
        1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8,
    ]  # fmt: skip

    @model_validator(mode="after")
    def _complete(self) -> Self:
        total = sum(self.durations)
        if abs(total - 1) > SUM_TOLERANCE:
            raise EntryError("durations", f"the seven durations sum to {total:.10g}; expected 1")
        if not sum(self.durations[:3]) or not sum(self.durations[4:]):
            raise EntryError(
                "durations",
                "stages 1 to 3 or stages 5 to 7 are all zero; expected at least one of each "
                "three to last, or the law cannot start and stop",
            )
        return self


class Piece(Model):
    """One piece of the engineer's own law: a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ)."""

    duration: NotNegative
    c0: Number = 0.0
    c1: Number = 0.0
    c2: Number = 0.0
    c3: Number = 0.0
    amplitude: Number = 0.0
    omega: NotNegative = 0.0
    phase: Number = 0.0

    @model_validator(mode="after")
    def _turning(self) -> Self:
        if self.amplitude and not self.omega:
            raise EntryError("omega", f"the sine of amplitude {self.amplitude:g} has no ω; expected more than 0")
        if 0 < self.omega < SMALLEST:
            raise EntryError("omega", f"ω = {self.omega:g} is too small; expected 0 or at least {SMALLEST:g}")
        return self


class OwnLaw(Model):
    """The engineer's own law, piece by piece; the default is the polynomial 3-4-5."""

    name: Text = "Polynomial 3-4-5"
    pieces: list[Piece] = [Piece(duration=1.0, c1=60.0, c2=-180.0, c3=120.0)]

    @model_validator(mode="after")
    def _complete(self) -> Self:
        total = sum(piece.duration for piece in self.pieces)
        if abs(total - 1) > SUM_TOLERANCE:
            raise EntryError("pieces", f"the durations of the own law sum to {total:.10g}; expected 1")
        return self


class Laws(Model):
    """The parameters of every law in the book."""

    ACS: LawSheet = LawSheet()
    TVP: TrapezoidalVelocity = TrapezoidalVelocity()
    CIC: LawSheet = LawSheet()
    CUB: LawSheet = LawSheet()
    MTP: ModifiedTrapezoidal = ModifiedTrapezoidal()
    OWN: OwnLaw = OwnLaw()


class Phase(Model):
    """One phase of an axis: angles of the master shaft in degrees, lift in mm."""

    start: Angle
    stop: Angle
    lift: Number = 0.0
    law: LawCode = "DWL"

    @model_validator(mode="after")
    def _forward(self) -> Self:
        if self.stop <= self.start:
            raise EntryError("stop", f"the angles run backwards: {self.stop:g}° does not lie after {self.start:g}°")
        if self.law == "DWL" and self.lift != 0:
            raise EntryError("lift", f"a dwell has no lift; expected 0, or another law, not {self.lift:g} mm")
        return self


class Axis(Model):
    """An axis of the timing diagram: what it does in each phase of one turn of the master shaft."""

    name: Annotated[str, Field(min_length=1, max_length=24, pattern=PLAIN)]
    group: Text
    closes: Literal["position", "feed"] = "position"
    phases: Annotated[list[Phase], Field(min_length=1)]

    @model_validator(mode="after")
    def _joined(self) -> Self:
        reached = 0.0
        for i, phase in enumerate(self.phases):
            if abs(phase.start - reached) > ANGLE_TOLERANCE:
                raise EntryError(f"phases.{i}.start", f"the phase begins at {phase.start:g}°; expected {reached:g}°")
            reached = phase.stop
        if abs(reached - 360) > ANGLE_TOLERANCE:
            raise EntryError(
                f"phases.{len(self.phases) - 1}.stop", f"the last phase ends at {reached:g}°; expected 360°"
            )
        return self


class Timing(Model):
    """The timing diagram of three axes over one turn of the master shaft."""

    rate: Positive  # pieces/min, one piece a turn
    axes: Annotated[list[Axis], Field(min_length=3, max_length=3)]

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        names = [axis.name for axis in self.axes]
        for i, name in enumerate(names):
            if name in names[:i]:
                raise EntryError(f"axes.{i}.name", f"a second axis is named {name!r}; expected a name of its own")
        return self


class Rotor(Model):
    """Rotating parts that turn alike: how many, the inertia of one, the teeth of the gear that drives them."""

    name: Text
    count: NotNegative
    inertia: NotNegative  # kg m²
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None

    @model_validator(mode="after")
    def _geared(self) -> Self:
        if (self.teeth_driver is None) != (self.teeth_driven is None):
            missing = "teeth_driver" if self.teeth_driver is None else "teeth_driven"
            raise EntryError(missing, "one of the two teeth counts is empty; expected both, or neither")
        return self


class Motor(Model):
    """The motor and its reducer, as the drive sheet needs them."""

    inertia: NotNegative  # kg m²
    rated_torque: Positive  # Nm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm
    reduction: Positive  # ω_m/ω_r
    efficiency: Annotated[float, Field(gt=0, le=1)] = 1.0


class Drive(Model):
    """The drive of one axis: load, rotors, motor."""

    rate: Positive  # pieces/min
    axis: str
    force: Number  # N
    radius: Positive  # m
    resists: Literal["always", "moving"] = "always"
    rotors: Annotated[list[Rotor], Field(min_length=1)]
    motor: Motor


class Sizes(Model):
    """How large the tables are built: intervals of a cycle and of a law, rows to fill."""

    cycle: Annotated[int, Field(ge=4, le=7200)] = 360
    law: Annotated[int, Field(ge=4, le=1000)] = 100
    own_law: Annotated[int, Field(ge=4, le=1000)] = 200
    phases: Annotated[int, Field(ge=2, le=60)] = 8
    rotors: Annotated[int, Field(ge=2, le=60)] = 6
    pieces: Annotated[int, Field(ge=2, le=60)] = 8


class Machine(Model):
    """What every machine description has, whatever its template."""

    template: str
    title: Text
    laws: Laws = Laws()
    sizes: Sizes = Sizes()
