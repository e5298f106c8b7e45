"""The laws of a description: named entries, each of a family, and the names by which phases take them."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, Union

from pydantic import BeforeValidator, Field, PrivateAttr, RootModel, create_model, model_serializer, model_validator

from workbook.errors import quoted
from workbook.fields.paths import key_of, leaves, replaced
from workbook.fields.texts import LOOKED_UP, NO_FORMULA, checked_name, place_of, require_distinct
from workbook.fields.types import EntryError, Model
from workbook.laws.registry import CODES, FAMILY, code_named, nearest_laws

LONGEST = 40  # characters of a law's name
NUMBERED = re.compile(r"([A-Z][A-Z0-9]{2})(\d*)")


@dataclass(frozen=True)
class TakesLaw:
    """Marks an entry that names a law of the book; with ``moves``, any but the dwell."""

    moves: bool = False


def listed(name: Any, names: Sequence[str]) -> str | None:
    """Return a name as it is listed: MATCH passes over the case of letters, and so does a description."""
    place = place_of(name, names) if isinstance(name, str) else -1
    return None if place < 0 else names[place]


def as_listed(name: Any) -> Any:
    """Return a code as the sheet Laws lists it, and all else as it is."""
    return listed(name, CODES) or name


NAME = Field(min_length=1, max_length=LONGEST, pattern=NO_FORMULA)
# the name of any law of the book
LawName = Annotated[str, NAME, LOOKED_UP, BeforeValidator(as_listed), TakesLaw()]
RisingLaw = Annotated[str, NAME, LOOKED_UP, BeforeValidator(as_listed), TakesLaw(moves=True)]
"""the name of a law that moves"""


Fields = dict[str, Any]
ENTRIES: dict[str, type[Model]] = {
    code: create_model(f"{code}Entries", __base__=base, __module__=__name__, **Fields(family=(Literal[code], code)))
    for code, base in ((code, page.entries) for code, page in FAMILY.items())
    if base
}
CALLED: Any = (Annotated[str, NAME, LOOKED_UP], ...)
CELLS: dict[str, type[Model]] = {  # the entries that a law's own page has: its name too
    code: create_model(f"{code}Cells", __base__=model, __module__=__name__, called=CALLED)
    for code, model in ENTRIES.items()
}
for _model in (*ENTRIES.values(), *CELLS.values()):
    globals()[_model.__name__] = _model  # pickle looks for them here

if TYPE_CHECKING:
    Entered = Any
else:
    Entered = Annotated[Union[tuple(ENTRIES.values())], Field(discriminator="family")]  # noqa: UP007


class Laws(RootModel[dict[str, Entered]]):
    """The laws of a book by name: the dwell, without entries, the basic families' codes, then those that are added."""

    _titles: dict[str, str] = PrivateAttr(default_factory=dict)

    @model_validator(mode="before")
    @classmethod
    def _named(cls, data: Any) -> Any:
        if not isinstance(data, Mapping):
            return data
        given = dict(data)
        require_names(list(given))
        basic = {code: given.pop(code, {}) for code in CODES if code in ENTRIES}
        return {name: in_family(name, entry) for name, entry in {**basic, **given}.items()}

    @model_serializer(mode="wrap")
    def _plain(self, handler: Callable[[Any], Any]) -> dict[str, Any]:
        """Put the family first, and leave out that of a basic law: its name says it."""
        dumped: dict[str, Any] = handler(self)
        families = {name: entry.pop("family") for name, entry in dumped.items()}
        return {name: entry if name in CODES else {"family": families[name], **entry} for name, entry in dumped.items()}

    @classmethod
    def entry_at(cls, key: str) -> type[Model]:
        """Return the model of the entries at a family's code, or at the key of a numbered law such as ``MTP8``."""
        match = NUMBERED.fullmatch(key)
        if match is None or match[1] not in ENTRIES:
            raise KeyError(key)
        return CELLS[match[1]] if match[2] else ENTRIES[match[1]]

    def __getitem__(self, name: str) -> Any:
        """Return the entries of a law; None of the dwell, which has none."""
        return self.root[name] if name != "DWL" else None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Laws) and [*self.root.items()] == [*other.root.items()]

    @property
    def names(self) -> tuple[str, ...]:
        """Every law in the order of the numbers."""
        return ("DWL", *self.root)

    def called(self, name: str) -> str:
        """Return the name that a law had when its book was built, else its present name."""
        return self._titles.get(name, name)

    def built_as(self, titles: Mapping[str, str]) -> None:
        """Keep the titles that the laws had when their book was built."""
        self._titles = dict(titles)

    def number(self, name: str) -> int:
        """Return the number of a law in the book, from 1."""
        return self.names.index(name) + 1

    def of(self, family: str) -> dict[str, Any]:
        """Return the laws of a family, by name."""
        return {name: entry for name, entry in self.root.items() if entry.family == family}


def require_names(names: list[Any]) -> None:
    """Raise EntryError for a name that a cell cannot hold, or that a look-up takes for another law's."""
    for name in names:
        if not isinstance(name, str):
            raise EntryError("", f"a law is named {quoted(name)}; expected a text")
        if not re.match(NO_FORMULA, name) or len(name) > LONGEST:
            raise EntryError(key_of(name), f"a law's name; expected 1 to {LONGEST} characters that do not begin with =")
        try:
            checked_name(name)
        except EntryError as error:
            raise EntryError(key_of(name), f"the law's name {error}") from None
        if name not in CODES and listed(name, CODES):
            raise EntryError(key_of(name), f"look-ups take this for the law {as_listed(name)}; expected another name")
    if "DWL" in names:
        raise EntryError("DWL", "a dwell has nothing to enter; expected no entries")
    require_distinct([*CODES, *(name for name in names if name not in CODES)], "law", "")


def in_family(name: str, entry: Any) -> Any:
    """Return the entries of a law with their family; raise EntryError where the family is missing or unknown."""
    if isinstance(entry, Model):
        return entry
    if not isinstance(entry, Mapping):
        raise EntryError(key_of(name), f"found {quoted(entry)}; expected the entries of a law")
    if name in CODES:
        if entry.get("family", name) != name:
            raise EntryError(f"{name}.family", f"the law {name} is of its own family; expected another name")
        for key in FAMILY[name].without_cells if name in ENTRIES else ():
            if entry.get(key) is not None:
                raise EntryError(
                    f"{name}.{key}", "every book has this law; expected a name of its own, such as laws.OPT"
                )
        return {**entry, "family": name}
    given = entry.get("family", code_named(name))
    if (family := listed(code_named(given) if isinstance(given, str) else given, [*ENTRIES])) is None:
        problem = "empty" if given is None else f"no family is named {quoted(given)}"
        raise EntryError(f"{key_of(name)}.family", f"{problem}; expected {nearest(given, [*ENTRIES])}")
    return {**entry, "family": family}


def nearest(given: Any, names: Sequence[str]) -> str:
    """Return in words the names that are like the given name, else all of them."""
    alike = get_close_matches(str(given).upper(), [name.upper() for name in names], n=3, cutoff=0.6)
    chosen = [name for name in names if name.upper() in alike] if given is not None else []
    return chosen[0] if len(chosen) == 1 else f"one of {', '.join(chosen or names)}"


class Reference(NamedTuple):
    """An entry that names a law: its model and field there, its key below the machine."""

    entries: Model
    field: str
    key: str
    moves: bool

    @property
    def name(self) -> str:
        """The name that is entered."""
        return str(getattr(self.entries, self.field))


def references(entries: Any, key: str = "") -> Iterator[Reference]:
    """Yield every entry below these that names a law."""
    if isinstance(entries, list):
        for i, entry in enumerate(entries):
            yield from references(entry, f"{key}.{i}")
    elif isinstance(entries, Model):
        for field, info in type(entries).model_fields.items():
            below = f"{key}.{field}".strip(".")
            marks = [mark for mark in info.metadata if isinstance(mark, TakesLaw)]
            if marks and getattr(entries, field) is not None:
                yield Reference(entries, field, below, marks[0].moves)
            elif field != "laws":
                yield from references(getattr(entries, field), below)


def resolve(entries: Model, laws: Laws) -> None:
    """Write the names of laws as they are listed; raise EntryError for a name that no law of the book has."""
    for reference in references(entries):
        name = listed(reference.name, laws.names)
        if name is None or (reference.moves and name == "DWL"):
            known = [known for known in laws.names if not reference.moves or known != "DWL"]
            if name:
                raise EntryError(reference.key, f"a dwell does not move; expected {nearest(reference.name, known)}")
            code = code_named(reference.name)
            takes = f"add [laws.{code}], or take" if code else "expected"
            alike = ", ".join(near for near in nearest_laws(reference.name, laws.names) if near != code)
            raise EntryError(reference.key, f"no law is named {quoted(reference.name)}; {takes} one of {alike}")
        # entries are frozen once they are whole
        object.__setattr__(reference.entries, reference.field, name)


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
