"""The laws of a description by the names that people give them, which only a book's own list decides in a cell."""

from collections.abc import Mapping
from typing import Any

from workbook.fields.paths import key_of
from workbook.fields.types import EntryError
from workbook.laws.entries import listed
from workbook.laws.registry import CODES, FAMILY, code_named

NAMING = ("law", "law_in", "law_out")  # entries that name a law


def with_laws_by_code(data: dict[str, Any]) -> dict[str, Any]:
    """Return a description whose entries name laws by what its book lists: those of the catalogue by their codes.

    A law that the description has itself goes before the catalogue's, which come with their defaults.
    """
    own = data.get("laws", {})
    if not isinstance(own, Mapping):
        return data
    require_names_of_family(own)
    added: dict[str, Any] = {}

    def by_code(name: str) -> str:
        code = None if listed(name, [*CODES, *own]) else code_named(name)
        if code is None:
            return name
        if listed(code, [*CODES, *own]) is None:
            added[code] = {}
        return code

    def renamed(entry: Any) -> Any:
        if isinstance(entry, list):
            return [renamed(each) for each in entry]
        if not isinstance(entry, Mapping):
            return entry
        return {
            key: by_code(each) if key in NAMING and isinstance(each, str) else renamed(each)
            for key, each in entry.items()
        }

    changed = renamed({key: entry for key, entry in data.items() if key != "laws"})
    return {**changed, "laws": {**own, **added}} if own or added else changed


def require_names_of_family(own: Mapping[Any, Any]) -> None:
    """Raise EntryError for a law of a description whose name hides a law of the catalogue that is of another family."""
    for name, entry in own.items():
        code = code_named(name) if isinstance(name, str) else None
        family = entry.get("family", code) if isinstance(entry, Mapping) else code
        if code and family != code:
            hidden = f"{name} is the law {FAMILY[code].law.name} ({code}) of the catalogue"
            raise EntryError(f"laws.{key_of(name)}", f"{hidden}; expected its family, or another name")
