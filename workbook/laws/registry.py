"""The families of laws that a workbook knows: the pages of the engine's catalogue, in its order."""

import re
from collections.abc import Sequence

from engine.laws import CATALOGUE, Law
from engine.motion.handover import PULSES, early_of, end_mode
from workbook.laws.family import COEFFICIENTS, Page
from workbook.laws.pages import modified, pieces, ramps, simple, spline

FILES = (modified, pieces, ramps, simple, spline)
FOUND = [found for file in FILES for found in vars(file).values()]
PAGES = [page for found in FOUND for page in (found if isinstance(found, list) else [found]) if isinstance(page, Page)]


class IncompleteError(TypeError):
    """A law has no page, or half of one."""


def page_of(law: type[Law], pages: Sequence[Page]) -> Page:
    """Return the page of a law; raise IncompleteError where it has none, or half of one."""
    page = next((page for page in pages if page.law.code == law.code), None)
    if page is None:
        raise IncompleteError(f"no page in FILES of workbook/laws/registry.py is of the law {law.code}")
    if page.pieces:  # else they are what is entered
        require_complete(page)
    return page


def require_complete(page: Page) -> None:
    """Raise IncompleteError, naming the law and what its page leaves out, or has otherwise than the engine."""
    law, default = page.law(), page.entries() if page.entries else None
    wrong = [name for name, *_ in COEFFICIENTS if name not in page.coefficients]
    if len(law.monotone_pieces()) != len(page.pieces):
        wrong.append(f"pieces as many as the engine's {len(law.monotone_pieces())}")
    modes = {int(found) for found in re.findall(r"(?<=[=,])-?[0-9](?=$|[,)])", page.end_mode)}
    early = {mode: page.early if mode == PULSES else 0 for mode in modes}
    if early.get(end_mode(law)) != early_of(law):
        wrong.append("how it meets its neighbours, as the engine has it")
    entered = {name: getattr(default, name) for name in page.fields}
    keys = {key for name, value in entered.items()
            for key in ([f"{name}.{i}" for i in range(len(value))] if isinstance(value, list) else [name])}  # fmt: skip
    wrong += [f"the parameter {key}" for key in sorted(keys ^ {parameter.key for parameter in page.parameters})]
    wrong += [f"variations of {key}" for key in page.fields if any(key not in v for v in page.variations)]
    if page.parameters and len(page.variations) < 2:
        wrong.append("two variations or more")
    if wrong:
        raise IncompleteError(f"the page of {page.law.code} lacks {', '.join(wrong)}")


FAMILY: dict[str, Page] = {law.code: page_of(law, PAGES) for law in CATALOGUE}
"""the pages of all families by code, in the order of the catalogue"""
CODES: tuple[str, ...] = ("DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
"""the basic laws, which every book has, in the order of their numbers: each named by the code of its family"""
RISING: tuple[str, ...] = CODES[1:]  # those of them that move
