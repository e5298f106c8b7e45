"""The register of targets: their names, which the command's help lists without loading them, and their facts."""

from __future__ import annotations

import tomllib
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import TYPE_CHECKING

from workbook.errors import TargetError

if TYPE_CHECKING:
    from workbook.controllers.target import Target

STATED = tomllib.loads(Path(__file__).with_name("targets.toml").read_text(encoding="utf-8"))
"""the facts of each target, and the claims about its format, with their documents"""
TARGETS = tuple(name for name in STATED if not name.endswith(" switches"))


def targets() -> list[Target]:
    """Return every target, in the order of the register."""
    folder = import_module("workbook.controllers.targets")
    rows = [import_module(f"{folder.__name__}.{file.name}").TARGETS for file in iter_modules(folder.__path__)]
    return sorted((row for some in rows for row in some), key=lambda row: TARGETS.index(row.name))


def target(name: str) -> Target:
    """Return the target of a name; raise TargetError, which lists those there are."""
    if name not in TARGETS:
        raise TargetError(f"no target is named {name!r}; expected one of {', '.join(TARGETS)}")
    return targets()[TARGETS.index(name)]
