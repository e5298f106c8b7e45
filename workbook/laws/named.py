"""The laws of a description by the names that people give them, which only a book's own list decides in a cell."""

from collections.abc import Mapping
from typing import Any

from workbook.fields.paths import key_of, leaves, replaced
from workbook.fields.types import EntryError
from workbook.laws.entries import listed
from workbook.laws.registry import CODES, FAMILY, code_named

NAMING = ("law", "law_in", "law_out")  # entries that name a law


def with_laws_by_code(data: dict[str, Any], usual: Mapping[str, Any]) -> dict[str, Any]:
    """Return a description whose entries name laws by what its book lists: those of the catalogue by their codes.

    A law that the description has itself goes before the catalogue's, which come with their defaults. One that says
    nothing of laws has the ``usual``, and names these in any of their ways.
    """
    own = data.get("laws", usual)
    listed_as = {} if "laws" in data else {entry["family"]: name for name, entry in usual.items()}
    if not isinstance(own, Mapping):
        return data
    require_names_of_family(own)
    changed, added = data, dict[str, Any]()
    for path, name in leaves({key: entry for key, entry in data.items() if key != "laws"}):
        if isinstance(name, str) and path[-1] in NAMING and not listed(name, [*CODES, *own]):
            code = code_named(name)
            if code is not None:
                changed = replaced(changed, path, listed_as.get(code, code))
                added |= {} if code in listed_as or listed(code, [*CODES, *own]) else {code: {}}
    return {**changed, "laws": {**own, **added}} if own or added else changed


def require_names_of_family(own: Mapping[Any, Any]) -> None:
    """Raise EntryError for a law of a description whose name hides a law of the catalogue that is of another family."""
    for name, entry in own.items():
        code = code_named(name) if isinstance(name, str) else None
        family = entry.get("family", code) if isinstance(entry, Mapping) else code
        if code and (not isinstance(family, str) or code_named(family) != code):
            hidden = f"{name} is the law {FAMILY[code].law.name} ({code}) of the catalogue"
            raise EntryError(f"laws.{key_of(name)}", f"{hidden}; expected its family, or another name")
