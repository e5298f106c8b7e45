"""What the page of the functions has entered, and what the engine says of it."""

import math
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from pydantic import BeforeValidator, Field

from engine.drive import Part
from engine.laws import Law
from engine.motion import Motion, Phase
from engine.motion.joining import joined
from workbook.entries.types import Model, NotNegative, Number, Share
from workbook.functions.declared import CODES, TAKES
from workbook.laws.entries import Laws, as_listed
from workbook.laws.registry import CODES as BASIC
from workbook.laws.registry import FAMILY

LAW_STEPS, MOTION_STEPS = 100, 120
EMPTY_PIECES, EMPTY_PHASES = 2, 2
WIDTH = 8  # parameters of a phase's law, at most: an own law of one piece

VIA = "VIA"
if TYPE_CHECKING:
    LawCode = str
    RowCode = str
else:
    LawCode = Annotated[Literal[CODES], BeforeValidator(as_listed)]
    """a law that the functions know"""
    RowCode = Annotated[Literal[(*CODES, VIA)], BeforeValidator(as_listed)]
    """a law of a phase, or what stands for it where a velocity is prescribed"""


class ShownPhase(Model):
    """A row of the table of phases."""

    law: RowCode
    duration: Number
    lift: Number = 0.0
    p: Annotated[list[Number], Field(max_length=WIDTH)] = Field(default_factory=list)

    @property
    def made(self) -> Phase:
        """The engine's phase."""
        return Phase(FAMILY[self.law].law_of(self.p), self.lift, self.duration)


class Shaft(Model):
    """A shaft with its inertia, and its speed over that of the reference shaft."""

    inertia: NotNegative
    ratio: Number


class Interval(Model):
    """An interval of a profile: its value and how long it lasts."""

    value: Number
    duration: NotNegative


class Shown(Model):
    """Every input of the page."""

    law: LawCode = "MTP"
    xi: Share = 0.3
    s: Share = 0.3
    x: NotNegative = 120.0
    laws: Laws = Laws({code: {"family": code} for code in CODES if code not in BASIC})
    phases: list[ShownPhase]
    shafts: list[Shaft]
    profile: list[Interval]

    @cached_property
    def one(self) -> Law:
        """The law that is chosen."""
        return FAMILY[self.law].law_of(self.parameters)

    @property
    def parameters(self) -> list[float]:
        """The numbers that the chosen law takes, piece after piece those of the own law."""
        return FAMILY[self.law].numbers(self.laws[self.law]) if self.law in TAKES else []

    @cached_property
    def motion(self) -> Motion:
        """The phases, joined: they take over velocities from straight lines."""
        return joined([phase.made for phase in self.phases], periodic=False).motion

    @property
    def reduced(self) -> float:
        """The reflected inertia of the shafts."""
        return math.fsum(Part("", one.inertia, speed_ratio=one.ratio).reflected for one in self.shafts)

    @property
    def rms(self) -> float:
        """The root mean square of the profile."""
        value, duration = np.array([(one.value, one.duration) for one in self.profile]).T
        return float(np.sqrt(value**2 @ duration / duration.sum()))


MTP = [0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125]
EXAMPLE = Shown.model_validate({
    "phases": [
        {"law": "DWL", "duration": 30.0},
        {"law": "MTP", "duration": 120.0, "lift": 80.0, "p": MTP},
        {"law": "DWL", "duration": 30.0},
        {"law": "MSN", "duration": 40.0, "lift": -13.0},
        {"law": "LIN", "duration": 40.0, "lift": -25.0},
        {"law": "PO5", "duration": 40.0, "lift": -12.0},
        {"law": "OWN", "duration": 60.0, "lift": -30.0, "p": [1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0]},
    ],
    "shafts": [{"inertia": 0.02, "ratio": 1.0}, {"inertia": 0.5, "ratio": 0.2}, {"inertia": 0.0012, "ratio": -3.0}],
    "profile": [
        {"value": value, "duration": d} for value, d in ((12.0, 0.2), (3.0, 0.5), (-9.0, 0.2), (0.0, 0.6))
    ],
})  # fmt: skip
