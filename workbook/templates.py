"""The register of templates, each imported when it is asked for."""

from collections.abc import Iterator, Mapping
from importlib import import_module

from workbook.template import Template

MODULES = {
    "cutting-machine": "cutting",
    "motion-composer": "composer",
    "indexing-overlap": "overlap",
    "flying-cutter": "flying",
    "actuator-sizing": "actuator",
}
"""where each template is declared, under workbook/machines/"""


class Register(Mapping[str, Template]):
    """The templates by name."""

    def __getitem__(self, name: str) -> Template:
        """Return a template; raise KeyError where there is none of that name."""
        template: Template = import_module(f"workbook.machines.{MODULES[name]}.template").TEMPLATE
        return template

    def __iter__(self) -> Iterator[str]:
        return iter(MODULES)

    def __len__(self) -> int:
        return len(MODULES)


TEMPLATES = Register()

__all__ = ["TEMPLATES", "Template"]
