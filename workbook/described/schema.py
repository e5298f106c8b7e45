"""JSON Schemas of descriptions, from which editors complete keys and mark what does not do."""

import json
from collections.abc import Iterator, Sequence
from typing import Any

from pydantic import BaseModel

from workbook.described.keys import Key, Section, remark, sections
from workbook.entries.rules import KIND
from workbook.laws.entries import ENTRIES
from workbook.templates import TEMPLATES, AnyTemplate

DRAFT = "http://json-schema.org/draft-07/schema#"
REFERENCE = "#/$defs/"
CATALOGUES = ("motors", "reducers")


def schema(template: AnyTemplate) -> dict[str, Any]:
    """Return the schema of a template's descriptions, each key with its meaning, unit and example."""
    made = one_way(template.model, sections(template))
    for way, other in template.others.items():
        another = one_way(other.model, sections(template, way))
        above, _, last = way.rpartition(".")
        asked = {"properties": {above: {"required": [last]}}, "required": [above]}
        defs = made.pop("$defs") | another.pop("$defs")
        made = {"if": asked, "then": another, "else": made, "$defs": defs}
    return {"$schema": DRAFT, **made}


def one_way(model: type[BaseModel], known: Sequence[Section]) -> dict[str, Any]:
    """Return the schema of the descriptions that a model checks, all but which draft it is of."""
    made = model.model_json_schema()
    made["$defs"]["Laws"] = laws(made["$defs"])
    for section in known:
        for key, node in placed(section, model, made):
            node["description"] = remark(key)
            if key.example is not None and not key.rows:
                node["examples"] = [key.example]
    for name in ("Selection", "Products"):
        selection = made["$defs"].get(name, {}).get("properties", {})
        for entry in CATALOGUES:
            if entry in selection:
                rows = selection[entry]
                selection[entry] = {"description": rows.pop("description", ""), "anyOf": [{"const": "committed"}, rows]}
    made["required"] = [*dict.fromkeys(["template", *made.get("required", [])])]
    return made


def laws(defs: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of the laws: those of the basic families by code, others by names that say their family."""
    known = {code: {"$ref": f"{REFERENCE}{model.__name__}"} for code, model in ENTRIES.items()}
    for model in ENTRIES.values():
        node = defs[model.__name__]
        node["required"] = [name for name in node.get("required", []) if name != "family"]
    others = {"type": "object", "required": ["family"], "properties": {"family": {"enum": [*ENTRIES]}}}
    return {"type": "object", "properties": known, "additionalProperties": others}


def placed(section: Section, model: type[BaseModel], made: dict[str, Any]) -> Iterator[tuple[Key, dict[str, Any]]]:
    """Yield each key of a section with its places in the schema of a model."""
    begin = f"{section.path}." if section.path else ""
    for one in section.models:
        table = made if one is model else made["$defs"][one.__name__]
        for key in (*section.keys, *(row for one in section.keys for row in one.rows)):
            node = at(made, table, key.path.removeprefix(begin))
            if node is not None and (key.name != KIND or not section.models[1:]):
                yield key, node


def at(made: dict[str, Any], table: Any, path: str) -> dict[str, Any] | None:
    """Return the place of a key in a table of a schema, through references and optional tables, or None."""
    for part in path.split("."):
        for choice in [choice for choice in table.get("anyOf", ()) if choice.get("type") != "null"]:
            table = choice
        if "$ref" in table:
            table = made["$defs"][table["$ref"].removeprefix(REFERENCE)]
        table = table.get("items") if part == "*" else table.get("properties", {}).get(part)
        if table is None:
            return None
    found: dict[str, Any] = table
    return found


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


def text(made: dict[str, Any]) -> str:
    """Return a schema as the text of a file."""
    return json.dumps(made, indent=1, ensure_ascii=False) + "\n"
