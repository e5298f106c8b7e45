"""Entries that several families have: the share λ of the time that accelerates."""

from typing import Annotated

from pydantic import Field

from workbook.laws.family import LawSheet, Parameter

LEAST = 0.01
EVEN = 0.5
Between = Annotated[float, Field(ge=LEAST, le=1 - LEAST, allow_inf_nan=False)]
"""a share of the time: sensible are 0.2 to 0.8; far beyond 0.01 and 0.99 figures lose digits"""


class Shared(LawSheet):
    """The share of the time that accelerates."""

    share: Between = EVEN


SHARE = Parameter("@share", "Share of the time that accelerates", "λ", "share", "share λ", source="½: symmetric")
SHARES = ({"share": 0.4}, {"share": 0.65}, {"share": 0.3})
"""other values of it"""
POLYNOMIAL = "=IF(ABS(@share-1/2)<1E-12,{},0)"
"""how a polynomial meets its neighbours: by its degree, unless a share shifts it"""
