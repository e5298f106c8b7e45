"""Descriptions and books: a new description, its schema, the book, what is entered in it, the committed templates."""

import re
from keyword import iskeyword
from pathlib import Path

import workbook
from workbook import build as making
from workbook.commands.verify import digest_of
from workbook.description import schema as schemas
from workbook.description.commented import commented_description
from workbook.errors import AGREES, DISAGREES, FAILS, InputError, WriteError
from workbook.file_cache import load_cached, store_cached
from workbook.reading.descriptions import read_machine, template_named, write_machine
from workbook.reports.terminal import ERR, OUT, print_or_write, say, shown
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing.output_files import refuse_existing, refuse_itself, refuse_same_file, refuse_suffix, write_text

INPUTS = "inputs"
STARTER = Path(workbook.__file__).parent / "starter"
NAME = re.compile(r"[a-z][a-z0-9_]{0,30}")


def build(
    machine: Path | None,
    output: Path | None,
    motors: Path | None,
    reducers: Path | None,
    force: bool,
    keep: Path | None = None,
) -> int:
    """Build a workbook from a machine description, with what is added to an old book; return the exit code."""
    source = machine or FOLDER / "cutting-machine.toml"
    target = output or Path(f"{source.stem}.xlsx")
    refuse_itself(target, source)
    refuse_suffix(target)
    with ERR.status(shown(f"Building {target} …")):
        catalogues = {"motors": motors, "reducers": reducers}
        described = read_machine(source, **{entry: file for entry, file in catalogues.items() if file})
        report = making.build_keeping(described, target, making.read_entered(keep)[0] if keep else None, force)
    return show_built(target, report)


def show_built(target: Path, verdict: making.BookVerdict) -> int:
    """Print that a book is built, its failing checks and notes; return the exit code."""
    say(OUT, f"Built {target.absolute()}")
    show("FAIL ", verdict.failing, "yellow")
    show("Note:", verdict.notes)
    return FAILS if verdict.failing else AGREES


def inputs(book: Path, output: Path | None, force: bool) -> None:
    """Read what was entered into a workbook, and what that leaves behind; once for the same bytes."""
    refuse_itself(output, book)
    refuse_existing(output, force)
    with ERR.status(shown(f"Reading {book} …")):
        sha256 = digest_of(book)
        known = load_cached(INPUTS, sha256) if sha256 else None
        if not known:
            machine, notes = making.read_inputs(book)
            known = {"text": write_machine(machine), "notes": notes}
            if sha256 and sha256 == digest_of(book):
                store_cached(INPUTS, sha256, known)
    show("Note:", known["notes"])
    print_or_write(known["text"], output, force)


def regenerate(book: Path, output: Path, force: bool) -> int:
    """Build a workbook anew from the entries of an old book and what its engineer added; return the exit code."""
    refuse_itself(output, book)
    refuse_suffix(output)
    refuse_existing(output, force)
    with ERR.status(shown(f"Regenerating {book} …")):
        verdict = making.regenerate(book, output, force)
    return show_built(output, verdict)


def templates(check: bool) -> int:
    """Generate the committed workbooks, or tell the stale ones; return the exit code."""
    with ERR.status("Generating the templates …"):
        stale = making.stale_templates() if check else []
        written = [] if check else making.write_templates()
    for path in written:
        say(OUT, f"Built {path}")
    for path in stale:
        say(ERR, f"{path}: stale; run 'motionbook templates' and commit it")
    if check and not stale:
        OUT.print(f"{len(making.committed_descriptions())} workbooks up to date")
    return DISAGREES if stale else AGREES


def show(mark: str, lines: list[str], style: str = "") -> None:
    """Print checks that fail, or notes on what was not carried over."""
    for line in lines:
        say(ERR, f"{mark} {line}", style)


def new(template: str, output: Path | None, force: bool) -> None:
    """Write a description with every key, and its schema beside it."""
    chosen = template_named(template, "TEMPLATE")
    target = output or Path(f"{chosen.name}.toml")
    refuse_existing(target, force)
    beside = target.parent / f"{chosen.name}.schema.json"
    refuse_same_file(target, beside)
    text = schemas.text(schemas.schema(chosen))
    if not (beside.is_file() and beside.read_bytes() == text.encode()):
        write_text(beside, text, force)
    write_text(target, commented_description(chosen, f"./{beside.name}"), force)
    say(OUT, f"Wrote {target.absolute()}, and {beside.name} beside it, from which an editor completes its keys")


def new_template(name: str, folder: Path | None) -> None:
    """Write a package with a template of the engineer's own: the hoist, called otherwise."""
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
            (target / rename_hoist(file, name)).write_bytes(rename_hoist(text, name).encode())
    except OSError as error:
        raise WriteError(f"{target}: {error.strerror}") from error
    then = f"python -m pip install -e {target}, then motionbook build {target}/{name}.toml"
    say(OUT, f"Wrote {target.absolute()}; {then}")


def rename_hoist(text: str, name: str) -> str:
    """Return a text on the hoist as a text on another machine."""
    return text.replace("hoist", name).replace("Hoist", name.title().replace("_", ""))


def schema(template: str | None, output: Path | None, force: bool) -> None:
    """Write the schema of a template's descriptions, or of any template's."""
    chosen_schema = schemas.any_schema() if template is None else schemas.schema(template_named(template, "TEMPLATE"))
    print_or_write(schemas.text(chosen_schema), output, force)
