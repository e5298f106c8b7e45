"""The register of targets by their names, which the command's help lists without loading them."""

from __future__ import annotations

import tomllib
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.errors import TargetError

if TYPE_CHECKING:
    from workbook.controllers.target import Target

CLAIMS = tomllib.loads(Path(__file__).with_name("claims.toml").read_text(encoding="utf-8"))
TARGETS = tuple(name for name in CLAIMS if not name.endswith(" switches"))
"""each declared in the file in ``targets`` that is called as its name begins, up to the -"""


def targets() -> list[Target]:
    """Return every target, in the order of the register."""
    return [target(name) for name in TARGETS]


def target(name: str) -> Target:
    """Return the target of a name; raise TargetError, which lists those there are."""
    if name not in TARGETS:
        raise TargetError(f"no target is named {name!r}; expected one of {', '.join(TARGETS)}")
    declared: tuple[Target, ...] = import_module(f"workbook.controllers.targets.{name.partition('-')[0]}").TARGETS
    return next(one for one in declared if one.name == name)
