"""Content of a description, for people and editors: the page of documentation and JSON Schemas, by a single walk."""

import json
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from pydantic import BaseModel

from workbook.description.keys import Key, Section, default_of, remark, sections, toml
from workbook.entries.rules import KIND
from workbook.laws.entries import ENTRIES
from workbook.templates import TEMPLATES, AnyTemplate

DRAFT = "http://json-schema.org/draft-07/schema#"
REFERENCE = "#/$defs/"
CATALOGUES = ("motors", "reducers")


def schema(template: AnyTemplate) -> dict[str, Any]:
    """Return the schema of a template's descriptions, each key with its meaning, unit and example."""
    return {"$schema": DRAFT, **model_schema(template.model, sections(template))}


def model_schema(model: type[BaseModel], known: Sequence[Section]) -> dict[str, Any]:
    """Return the schema of the descriptions that a model checks, all but which draft it is of."""
    whole = model.model_json_schema()
    for law in ENTRIES.values():
        node = whole["$defs"][law.__name__]
        node["required"] = [name for name in node.get("required", []) if name != "family"]
    known_laws = {code: {"$ref": f"{REFERENCE}{law.__name__}"} for code, law in ENTRIES.items()}
    others = {"type": "object", "required": ["family"], "properties": {"family": {"enum": [*ENTRIES]}}}
    whole["$defs"]["Laws"] = {"type": "object", "properties": known_laws, "additionalProperties": others}
    for section in known:
        for key, node in key_nodes(section, model, whole):
            node["description"] = remark(key)
            if key.example is not None and not key.rows:
                node["examples"] = [key.example]
    for name in ("Selection", "Products"):
        selection = whole["$defs"].get(name, {}).get("properties", {})
        for entry in CATALOGUES:
            if entry in selection:
                rows = selection[entry]
                selection[entry] = {"description": rows.pop("description", ""), "anyOf": [{"const": "committed"}, rows]}
    whole["required"] = [*dict.fromkeys(["template", *whole.get("required", [])])]
    return whole


def key_nodes(section: Section, model: type[BaseModel], whole: dict[str, Any]) -> Iterator[tuple[Key, dict[str, Any]]]:
    """Yield each key of a section with its places in the schema of a model."""
    begin = f"{section.path}." if section.path else ""
    for model_type in section.models:
        table = whole if model_type is model else whole["$defs"][model_type.__name__]
        for key in (*section.keys, *(row for entry in section.keys for row in entry.rows)):
            node = node_at(whole, table, key.path.removeprefix(begin))
            if node is not None and (key.name != KIND or not section.models[1:]):
                yield key, node


def node_at(whole: dict[str, Any], table: Any, path: str) -> dict[str, Any] | None:
    """Return the place of a key in a table of a schema, through references and optional tables, or None."""
    for part in path.split("."):
        for choice in [choice for choice in table.get("anyOf", ()) if choice.get("type") != "null"]:
            table = choice
        if "$ref" in table:
            table = whole["$defs"][table["$ref"].removeprefix(REFERENCE)]
        table = table.get("items") if part == "*" else table.get("properties", {}).get(part)
        if table is None:
            return None
    node: dict[str, Any] = table
    return node


def any_schema() -> dict[str, Any]:
    """Return the schema of a description of any template: by the name that it gives of its template."""
    defs: dict[str, Any] = {}
    choices = []
    for name, template in TEMPLATES.items():
        own = json.loads(json.dumps(schema(template)).replace(REFERENCE, f"{REFERENCE}{name}-"))
        own.pop("$schema")
        defs |= {f"{name}-{part}": node for part, node in own.pop("$defs").items()}
        choices.append({"if": {"properties": {"template": {"const": name}}}, "then": own})
    named = {"properties": {"template": {"enum": [*TEMPLATES]}}, "required": ["template"]}
    return {"$schema": DRAFT, "type": "object", **named, "allOf": choices, "$defs": defs}


def text(content: dict[str, Any]) -> str:
    """Return a schema as the text of a file."""
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


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
name. Any law of the catalogue is there too, with its defaults, where it is named as people write it: `law = "modified
sine"`, `"3-4-5"`, `"cycloidal"`. No law of your own can take such a name of another family.
"""
TITLES = ("key", "meaning", "unit", "what it takes", "default", "example")
LONGEST = 60


def page() -> str:
    """Return the page."""
    parts, laws = [HEAD], list[Section]()
    for name, template in TEMPLATES.items():
        every = sections(template)
        laws = laws or [section for section in every if section.path.startswith("laws.")]
        own = [section for section in every if not section.path.startswith("laws.")]
        parts.append(f"## {name}\n\n{own[0].models[0].__doc__ or ''}\n")
        parts += [section_text(section) for section in own]
    return "\n".join([*parts, LAWS, *(section_text(section) for section in laws)])


def section_text(section: Section) -> str:
    """Return the table of a section, with those of its lists."""
    kind = f" with `kind = {toml(section.kind)}`" if section.kind else ""
    title = f"### `[{section.path}]`{kind}\n\n{section.about}.\n\n" if section.path else ""
    return f"{title}{md_table(key_lines(section.path, section.keys))}" if section.keys else title.rstrip("\n") + "\n"


def md_table(lines: Iterable[tuple[str, ...]]) -> str:
    """Return lines as a table, with titles."""
    rows = [TITLES, ("---",) * len(TITLES), *lines]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows) + "\n"


def key_lines(path: str, keys: Iterable[Key]) -> Iterator[tuple[str, ...]]:
    """Yield a line for each key, and below a list a line for each entry of its rows."""
    for key in keys:
        shown = key.path.removeprefix(f"{path}.")
        example = "" if key.rows or key.example is None else code(toml(key.example))
        default = default_of(key)
        yield (
            code(shown),
            plain(key.meaning),
            plain(key.unit),
            plain(key.expected),
            code(default) if default not in ("", "none") and not key.rows else default,
            example,
        )
        yield from key_lines(path, key.rows)


def code(text: str) -> str:
    """Return a text as code; long ones are cut."""
    return f"`{text if len(text) <= LONGEST else f'{text[:LONGEST]}…'}`"


def plain(text: str) -> str:
    """Return a text that a cell of a table can hold."""
    return text.replace("|", "\\|")
