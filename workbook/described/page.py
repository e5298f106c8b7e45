"""The page of documentation on descriptions: every key, a section a template."""

from collections.abc import Iterable, Iterator

from workbook.described.keys import Key, Section, default_of, sections, toml
from workbook.templates import TEMPLATES

HEAD = """\
# What a description says

Made by `python -m docs.description` from the models that check a description, and from the cells that show it.
`motionbook new TEMPLATE` writes a description to begin with; `motionbook schema TEMPLATE` writes a JSON
Schema from which an editor completes the keys. In a key, `*` stands for each row of a list. A key without a default
must be there. Lengths, angles and rates are in the units named here, never in others.
"""
LAWS = """\
## Laws

Every template takes these. The basic laws are there without being named; a law of another family, or a second one of
the same, has a name of its own and says its family: `[laws."soft MTP"]` with `family = "MTP"`. Phases take it by that
name.
"""
TITLES = ("key", "meaning", "unit", "what it takes", "default", "example")
LONGEST = 60


def page() -> str:
    """Return the page."""
    parts, laws = [HEAD], list[Section]()
    for name, template in TEMPLATES.items():
        found = sections(template)
        laws = laws or [section for section in found if section.path.startswith("laws.")]
        own = [section for section in found if not section.path.startswith("laws.")]
        parts.append(f"## {name}\n\n{own[0].models[0].__doc__ or ''}\n")
        parts += [described(section) for section in own]
        parts += [differing(key, found, sections(template, key)) for key in template.others]
    return "\n".join([*parts, LAWS, *(described(section) for section in laws)])


def differing(other: str, own: Iterable[Section], told: Iterable[Section]) -> str:
    """Return the table of the keys that another way to tell a machine has, or takes in other units or ranges."""

    def lined(found: Iterable[Section]) -> dict[str, tuple[str, ...]]:
        return {f"{key.path}.{line[0]}": line for one in found for key in one.keys for line in lines("", [key])}

    known = lined(own)
    rows = [(*line[:-1], "") for key, line in lined(told).items() if known.get(key, ())[1:4] != line[1:4]]
    return f"### With `{other}`\n\nWhat differs then.\n\n{tabled(rows)}"


def described(section: Section) -> str:
    """Return the table of a section, with those of its lists."""
    kind = f" with `kind = {toml(section.kind)}`" if section.kind else ""
    title = f"### `[{section.path}]`{kind}\n\n{section.about}.\n\n" if section.path else ""
    return f"{title}{tabled(lines(section.path, section.keys))}" if section.keys else title.rstrip("\n") + "\n"


def tabled(told: Iterable[tuple[str, ...]]) -> str:
    """Return lines as a table, with titles."""
    rows = [TITLES, ("---",) * len(TITLES), *told]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows) + "\n"


def lines(path: str, keys: Iterable[Key]) -> Iterator[tuple[str, ...]]:
    """Yield a line for each key, and below a list one for each entry of its rows."""
    for key in keys:
        shown = key.path.removeprefix(f"{path}.")
        example = "" if key.rows or key.example is None else code(toml(key.example))
        default = default_of(key)
        yield (
            code(shown), plain(key.meaning), plain(key.unit), plain(key.expected),
            code(default) if default not in ("", "none") and not key.rows else default, example,
        )  # fmt: skip
        yield from lines(path, key.rows)


def code(text: str) -> str:
    """Return a text as code; long ones are cut."""
    return f"`{text if len(text) <= LONGEST else f'{text[:LONGEST]}…'}`"


def plain(text: str) -> str:
    """Return a text that a cell of a table can hold."""
    return text.replace("|", "\\|")
