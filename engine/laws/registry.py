"""The registry of motion laws: a line a family.

A name in :data:`MODULES` is that of a file beside this one, whose ``ENTRY`` says all that the engine knows of the
family, and of the file in ``workbook/laws/pages`` whose ``PAGE`` says all that a workbook needs of it. Everything
else (the stack of pieces, drop-downs, variations, tests) goes through the registry. The order is that of the laws'
numbers in a workbook.
"""

from collections.abc import Sequence
from importlib import import_module
from typing import Any

from engine.laws.base import Law
from engine.laws.entry import Entry, IncompleteError

MODULES = (
    "dwell",
    "constant_acceleration",
    "trapezoidal_velocity",
    "cycloidal",
    "cubic",
    "modified_trapezoidal",
    "pieces",
    "straight_line",
    "simple_harmonic",
    "double_harmonic",
    "polynomial_345",
    "polynomial_4567",
    "modified_sine",
    "trapezoid_by_share",
    "sine_constant_cosine",
    "harmonic_combination",
    "sine_straight_sine",
    "sine_ramps",
    "s_curve",
    "spline",
)


class UnknownLawError(ValueError):
    """No law of the catalogue has this name."""


def entry_of(module: str) -> Entry:
    """Return the entry of a law's file in this folder; raise IncompleteError where it has none."""
    found = getattr(import_module(f"engine.laws.{module}"), "ENTRY", None)
    if not isinstance(found, Entry):
        raise IncompleteError(f"engine/laws/{module}.py has no ENTRY")
    return found


def _key(name: str) -> str:
    return " ".join(name.casefold().split())


def by_name(entries: Sequence[Entry]) -> dict[str, Entry]:
    """Return the entries by each of their names; raise ValueError where one name means two laws."""
    found: dict[str, Entry] = {}
    for entry in entries:
        for key in {_key(name) for name in entry.names}:
            if key in found:
                raise ValueError(f"{key!r} names two laws: {found[key].law.__name__} and {entry.law.__name__}")
            found[key] = entry
    return found


CATALOGUE: tuple[Entry, ...] = tuple(entry_of(module) for module in MODULES)
_KNOWN = by_name(CATALOGUE)


def law(name: str, **parameters: Any) -> Law:
    """Return a law of the catalogue.

    Parameters
    ----------
    name : str
        Its code, name or alias, in capitals or not.
    **parameters
        Those of the law's class.

    Returns
    -------
    Law
        The law, made with its parameters.

    Raises
    ------
    UnknownLawError
        For a name that is not in the catalogue; it lists the known laws.
    ValueError
        What the law itself raises for its parameters.
    """
    entry = _KNOWN.get(_key(name))
    if entry is None:
        known = ", ".join(f"{e.code} ({e.name})" for e in CATALOGUE)
        raise UnknownLawError(f"no law is named {name!r}; expected one of {known}")
    return entry.law(**parameters)
