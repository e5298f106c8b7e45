"""The register of targets, each loaded when it is asked for."""

from __future__ import annotations

from importlib import import_module

from workbook.controllers.names import TARGETS
from workbook.controllers.target import Target
from workbook.errors import TargetError


def targets() -> list[Target]:
    """Return every target, in the order of the register."""
    return [target(name) for name in TARGETS]


def target(name: str) -> Target:
    """Return the target of a name; raise TargetError, which lists those there are."""
    if name not in TARGETS:
        raise TargetError(f"no target is named {name!r}; expected one of {', '.join(TARGETS)}")
    found: Target = import_module(f"workbook.controllers.targets.{name.replace('-', '_')}").TARGET
    return found
