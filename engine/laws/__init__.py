"""The motion laws: a class for each family, in the order of their numbers.

A law is found by its number, which a class in any file of this folder states. :mod:`workbook.laws.pages` holds what a
workbook needs of each. Everything else (tables of pieces, drop-downs, variations, tests) iterates over the catalogue.
"""

from difflib import get_close_matches
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from engine.laws.family import Law
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.simple import Dwell

__all__ = ["CATALOGUE", "Dwell", "Law", "Piece", "PieceLaw", "UnknownLawError", "law"]

for _file in iter_modules(__path__):
    import_module(f"{__name__}.{_file.name}")
CATALOGUE: tuple[type[Law], ...] = tuple(sorted(Law.numbered, key=lambda family: family.number))


class UnknownLawError(ValueError):
    """No law of the catalogue has this name."""


def _key(name: str) -> str:
    return "".join(letter for letter in name.casefold() if letter.isalnum())


_KNOWN = {_key(name): family for family in CATALOGUE for name in (family.code, family.name, *family.aliases)}
"""the families by their names in letters and digits"""


def family_named(name: str) -> type[Law] | None:
    """Return the class of the catalogue's law with this code, name or alias; None where it has none."""
    return _KNOWN.get(_key(name))


def law(name: str, **parameters: Any) -> Law:
    """Return a law of the catalogue.

    Parameters
    ----------
    name : str
        Code, name or alias of the law; case, blanks and dashes do not matter.
    **parameters
        Fields of the law's class, dimensionless.

    Raises
    ------
    UnknownLawError
        If the catalogue has no law of this name; the message lists the three whose names are most like it.
    ValueError
        If the law's class rejects a parameter.
    """
    chosen = family_named(name)
    if chosen is None:
        names = {each.casefold(): each for family in CATALOGUE for each in (family.code, family.name, *family.aliases)}
        near = (names[each] for each in get_close_matches(name.casefold(), names, n=3, cutoff=0.0))
        raise UnknownLawError(f"no law is named {name!r}; expected one of {', '.join(near)}")
    return chosen(**parameters)
