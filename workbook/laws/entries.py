"""What a description says of the laws: parameters of each, and the engineer's own."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.types import (
    SMALLEST,
    SUM_TOLERANCE,
    EntryError,
    Model,
    NotNegative,
    Number,
    Positive,
    Share,
    Text,
)

LawCode = Literal["DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN"]


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

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(
        default=[1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8]
    )

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
    pieces: list[Piece] = Field(default=[Piece(duration=1.0, c1=60.0, c2=-180.0, c3=120.0)])

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
