"""A new description, and the schema that editors complete it from."""

from __future__ import annotations

import json
from pathlib import Path

from workbook.build import write_text
from workbook.described import schema as schemas
from workbook.described.commented import commented
from workbook.errors import ReadError
from workbook.intake import odd, read_text
from workbook.reading.descriptions import template_named
from workbook.reports.terminal import OUT, say, say_data
from workbook.writing.place import refuse_existing, refuse_one_for_two, replace

ARGUMENT = "TEMPLATE"


def new(template: str, output: Path | None, force: bool) -> None:
    """Write a description with every key, and its schema beside it."""
    chosen = template_named(template, ARGUMENT)
    target = output or Path(f"{chosen.name}.toml")
    refuse_existing(target, force)
    beside = target.parent / f"{chosen.name}.schema.json"
    refuse_one_for_two(target, beside)
    made = schemas.text(schemas.schema(chosen))
    kept = holds(beside, made)
    if not kept:
        refuse_existing(beside, force)
        replace(beside, lambda draft: write_text(draft, made), force)
    replace(target, lambda draft: write_text(draft, commented(chosen, f"./{beside.name}")), force)
    say(OUT, f"Wrote {target.absolute()}, and {beside.name} beside it, from which an editor completes its keys")


def holds(path: Path, text: str) -> bool:
    """Whether a file is there, and holds just this text."""
    try:
        return not odd(path) and read_text(path, "a schema") == text
    except (OSError, ReadError):
        return False


def schema(template: str | None, output: Path | None, force: bool) -> None:
    """Write the schema of a template's descriptions, or of any template's."""
    made = schemas.any_schema() if template is None else schemas.schema(template_named(template, ARGUMENT))
    if output is None:
        say_data(json.dumps(made, indent=1, ensure_ascii=False))
        return
    replace(output, lambda draft: write_text(draft, schemas.text(made)), force)
    say(OUT, f"Wrote {output.absolute()}")
