"""What a description says of the laws: the parameters of each family, and the codes that name them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from pydantic import create_model

from workbook.entries.types import Model
from workbook.laws.registry import FAMILIES, RISING

if TYPE_CHECKING:
    LawCode = str
    RiseCode = str

    class Laws(Model):
        """The parameters of every law in the book, by code."""

        def __getattr__(self, code: str) -> Any: ...

else:
    LawCode = Literal[tuple(family.code for family in FAMILIES)]
    """the code of any law"""
    RiseCode = Literal[RISING]
    """the code of a law that moves"""
    Laws = create_model(
        "Laws",
        __base__=Model,
        __module__=__name__,
        __doc__="The parameters of every law in the book.",
        **{one.code: (one.page.entries, one.page.entries()) for one in FAMILIES if one.page.entries},
    )
