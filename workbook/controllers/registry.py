"""The register of targets by their names, which the command's help lists without loading them."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from workbook.controllers.claims import TARGETS
from workbook.errors import TargetError

if TYPE_CHECKING:
    from workbook.controllers.target import Target

MODULES = ("br", "codesys", "columns", "mitsubishi", "rockwell", "siemens", "twincat")
"""the files in ``targets`` in which these are declared"""


def targets() -> list[Target]:
    """Return every target, in the order of the register."""
    found = [import_module(f"workbook.controllers.targets.{module}").TARGETS for module in MODULES]
    return sorted((one for some in found for one in some), key=lambda one: TARGETS.index(one.name))


def target(name: str) -> Target:
    """Return the target of a name; raise TargetError, which lists those there are."""
    if name not in TARGETS:
        raise TargetError(f"no target is named {name!r}; expected one of {', '.join(TARGETS)}")
    return targets()[TARGETS.index(name)]
