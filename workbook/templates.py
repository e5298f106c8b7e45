"""The register of templates, each imported when it is asked for: those of motionbook, and those of other packages."""

import copyreg
import sys
from collections.abc import Iterator, Mapping
from functools import cached_property
from importlib import import_module
from importlib.metadata import entry_points
from typing import TypeAlias

from workbook.entries.machine import Machine
from workbook.template import Template

MODULES = {"machine": "machine", "indexing-overlap": "overlap", "flying-cutter": "flying", "motion-laws": "laws"}
"""where each template is declared, under workbook/machines/"""
GROUP = "motionbook.templates"  # the group of entry points by which packages bring their own
# a template as those see it who know it by its name only
AnyTemplate: TypeAlias = Template[Machine]


class Register(Mapping[str, AnyTemplate]):
    """The templates by name."""

    @cached_property
    def others(self) -> dict[str, AnyTemplate]:
        """Load the templates of other packages, once; say in a line which of them cannot be used."""
        others: dict[str, AnyTemplate] = {}
        for point in entry_points(group=GROUP):
            try:
                template = point.load()
                if not isinstance(template, Template):
                    raise ValueError(f"it is a {type(template).__name__}; expected a Template")
                if template.name != point.name:
                    raise ValueError(f"it calls itself {template.name!r}; expected the name of its entry point")
                if point.name in MODULES.keys() | others.keys():
                    raise ValueError("another template has that name")
                others[point.name] = template
            except Exception as error:  # whatever another package does, the rest works
                print(f"The template {point.name!r} of {point.value} cannot be used: {error}", file=sys.stderr)
        return others

    def __getitem__(self, name: str) -> AnyTemplate:
        """Return a template; raise KeyError where there is none of that name."""
        if name not in MODULES:
            return self.others[name]
        template: AnyTemplate = import_module(f"workbook.machines.{MODULES[name]}.template").TEMPLATE
        return template

    def __iter__(self) -> Iterator[str]:
        yield from (*MODULES, *self.others)

    def __len__(self) -> int:
        return len(MODULES) + len(self.others)


TEMPLATES = Register()
# to processes by its name
copyreg.pickle(Template, lambda template: (TEMPLATES.__getitem__, (template.name,)))

__all__ = ["TEMPLATES", "AnyTemplate", "Template"]
