"""The work of the commands; each module is loaded when it is first named, so that help and faults are told at once."""

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbook.commands import audit, cams, export, improve, make, oracle, study, verify

__all__ = ["audit", "cams", "export", "improve", "make", "oracle", "study", "verify"]


def __getattr__(name: str) -> ModuleType:
    """Return a module of this room; raise AttributeError for any other name."""
    if name not in __all__:
        raise AttributeError(name)
    return import_module(f"{__name__}.{name}")
