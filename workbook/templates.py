"""The register of templates, each imported when it is asked for."""

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import TypeAlias

from workbook.entries.machine import Machine
from workbook.template import Template

MODULES = {
    "machine": "machine",
    "indexing-overlap": "overlap",
    "flying-cutter": "flying",
    "motion-laws": "laws",
}
"""where each template is declared, under workbook/machines/"""


AnyTemplate: TypeAlias = Template[Machine]
"""a template as those see it who know it by its name only"""


class Register(Mapping[str, AnyTemplate]):
    """The templates by name."""

    def __getitem__(self, name: str) -> AnyTemplate:
        """Return a template; raise KeyError where there is none of that name."""
        template: AnyTemplate = import_module(f"workbook.machines.{MODULES[name]}.template").TEMPLATE
        return template

    def __iter__(self) -> Iterator[str]:
        return iter(MODULES)

    def __len__(self) -> int:
        return len(MODULES)


TEMPLATES = Register()

__all__ = ["TEMPLATES", "AnyTemplate", "Template"]
