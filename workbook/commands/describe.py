"""A new description, and the schema that editors complete it from."""

from __future__ import annotations

import json
import re
from keyword import iskeyword
from pathlib import Path

import workbook
from workbook.build import write_text
from workbook.described import schema as schemas
from workbook.described.commented import commented
from workbook.errors import InputError, ReadError, WriteError
from workbook.intake import odd, read_text
from workbook.reading.descriptions import template_named
from workbook.reports.terminal import OUT, say, say_data
from workbook.templates import TEMPLATES
from workbook.writing.place import refuse_existing, refuse_one_for_two, replace

ARGUMENT = "TEMPLATE"
STARTER = Path(workbook.__file__).parent / "starter"
NAME = re.compile(r"[a-z][a-z0-9_]{0,30}")


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


def new_template(name: str, folder: Path | None) -> None:
    """Write a package with a template of one's own: the hoist, called otherwise."""
    if not NAME.fullmatch(name) or iskeyword(name):
        raise InputError([f"NAME: found {name!r}; expected small letters, digits and _, beginning with a letter"])
    if name in TEMPLATES:
        raise InputError([f"NAME: a template is named {name!r}; expected another name"])
    target = folder or Path(f"motionbook-{name}")
    if target.exists():
        raise WriteError(f"{target}: exists; expected a folder to be made")
    texts = {path.name: path.read_text(encoding="utf-8") for path in sorted(STARTER.iterdir()) if path.is_file()}
    try:
        target.mkdir(parents=True)
        for file, text in texts.items():
            write_text(target / renamed(file, name), renamed(text, name))
    except OSError as error:
        raise WriteError(f"{target}: {error.strerror}") from error
    say(
        OUT, f"Wrote {target.absolute()}; python -m pip install -e {target}, then motionbook build {target}/{name}.toml"
    )


def renamed(text: str, name: str) -> str:
    """Return a text on the hoist as one on another machine."""
    return text.replace("hoist", name).replace("Hoist", name.title().replace("_", ""))


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
