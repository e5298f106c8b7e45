"""What a description says of the laws: the parameters of each family, and the codes that name them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, create_model

from workbook.entries.texts import place_of
from workbook.entries.types import Model
from workbook.laws.registry import FAMILIES, RISING

CODES = [family.code for family in FAMILIES]


def as_listed(code: Any) -> Any:
    """Return the code as the sheet Laws lists it: MATCH passes over the case of letters, and so does a description."""
    place = place_of(code, CODES) if isinstance(code, str) else -1
    return code if place < 0 else CODES[place]


if TYPE_CHECKING:
    LawCode = str
    RiseCode = str

    class Laws(Model):
        """The parameters of every law in the book, by code."""

        def __getattr__(self, code: str) -> Any: ...

else:
    LawCode = Annotated[Literal[tuple(CODES)], BeforeValidator(as_listed)]
    """the code of any law"""
    RiseCode = Annotated[Literal[RISING], BeforeValidator(as_listed)]
    """the code of a law that moves"""
    Laws = create_model(
        "Laws",
        __base__=Model,
        __module__=__name__,
        __doc__="The parameters of every law in the book.",
        **{one.code: (one.page.entries, one.page.entries()) for one in FAMILIES if one.page.entries},
    )
