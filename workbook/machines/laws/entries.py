"""Motion laws compared: what an engineer enters."""

from typing import Annotated, Literal

from pydantic import Field

from workbook.entries.machine import Machine
from workbook.fields.types import Model
from workbook.laws.entries import LawName

MOST_CURVES = 4


class Curve(Model):
    """A law that is drawn."""

    law: LawName


class Comparison(Model):
    """The laws whose curves are drawn together; the table has every law of the book."""

    curves: Annotated[list[Curve], Field(min_length=1, max_length=MOST_CURVES)]


class MotionLaws(Machine):
    """The laws of a book side by side."""

    template: Literal["motion-laws"] = "motion-laws"
    comparison: Comparison
