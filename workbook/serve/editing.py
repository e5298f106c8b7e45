"""The design page: what its script asks while a description is edited, all of it in JSON; drafts and saving."""

from pathlib import Path
from typing import Any

from workbook.errors import InputError, ReadError, WriteError
from workbook.reports.html import render
from workbook.serve import design, parts, shown, study, tables
from workbook.serve.handler import Page, state
from workbook.serve.server import SCRIPTS, VERSION
from workbook.templates import TEMPLATES
from workbook.text_files import read_text
from workbook.writing.output_files import write_text

DRAFT = ".draft"
EXPECTED = "a machine description, a .toml file"
BOM, RETURNS = b"\xef\xbb\xbf", b"\r\n"


async def edit(page: Page, name: str) -> str:
    """Show the design page of a description, or, unsaved, of a design among the best of a study of it."""
    page.folder.file(name)
    asked, number = page.get_query_argument("study", ""), page.get_query_argument("pick", "")
    given = {"name": name, "study": asked, "pick": number, "version": VERSION, "scripts": SCRIPTS}
    return render("serve/page/design.html", **given)


async def open_design(page: Page) -> dict[str, Any]:
    """Return a description to be edited, its draft or a design of a study in its place, and the entries of its kind."""
    path, asked = page.file(), page.get_body_argument("study", "")
    saved, draft, text, note, target = file_text(path), draft_of(path), None, "", path.name
    if page.get_body_argument("discard", ""):
        draft.unlink(missing_ok=True)
    if asked:
        number, results = page.number("pick"), study.study_file(page, asked)
        text = await page.work.in_worker(study.design_of_study, results, number)
        note = f"Design {number} of {asked}. It is not saved yet; Save gives it a name of its own."
        target = f"{results.stem}-{number}.toml"
    elif draft.exists():
        text = read_text(draft, EXPECTED)
        note = "These changes were not saved when the page was closed."
    book = path.with_suffix(".xlsx")
    built = {"name": book.name, "time": book.stat().st_mtime} if book.is_file() else None
    more = {"saved": saved, "state": state(path), "note": note, "target": target, "book": built}
    return await page.work.in_worker(open_text, saved if text is None else text, more)


def open_text(text: str, more: dict[str, Any]) -> dict[str, Any]:
    """Return a text as the page opens it."""
    read = shown_text(text)
    name = read["data"].get("template") if read["data"] else None
    known = tables.schema(name) if name in TEMPLATES else []
    return read | {"schema": known} | tables.catalogue() | more


def shown_text(text: str) -> dict[str, Any]:
    """Return a text with its data and the faults of its entries; with the error alone where it is no TOML."""
    try:
        edited = design.edited_design(text)
    except (InputError, ReadError) as error:
        return {"text": text, "data": None, "faults": {}, "error": str(error).removeprefix("the description: ")}
    live = bool(edited.template.live)
    return {"text": text, "data": edited.data, "faults": edited.faults, "error": None, "live": live}


async def change(page: Page) -> dict[str, Any]:
    """Return a text with changes made in it, and the figures of an axis; keep a draft of what is no preview."""
    path, text = page.file(), page.text()
    changes, chosen = page.changes(), page.number("axis", "-1")
    given = await page.work.in_worker(edit_result, text, changes, chosen)
    if not page.get_body_argument("preview", ""):
        keep_draft(path, given["text"])
    return given


def edit_result(text: str, changes: list[dict[str, Any]], chosen: int) -> dict[str, Any]:
    """Return a text after changes, with the figures of an axis."""
    text, refused = parts.apply_changes(text, changes)
    return shown_text(text) | {"refused": refused} | design.figures(text, chosen, machine=False)


async def figures(page: Page) -> dict[str, Any]:
    """Return the figures of all axes of a text and of the machine, in parts of work, so that a change comes between."""
    text, chosen = page.text(), page.number("axis")
    done: int | None = 0
    while done is not None:
        done = await page.work.in_worker(design.worked_out, text, done)
    return await page.work.in_worker(design.figures, text, chosen)


async def products(page: Page) -> dict[str, Any]:
    """Return the use of each motor or reducer of the catalogue in an axis of a text."""
    axis, kind = page.number("axis"), page.get_body_argument("kind")
    return await page.work.in_worker(design.products, page.text(), axis, kind)


async def verdict(page: Page) -> dict[str, Any]:
    """Return the verdict on a text."""
    return await page.work.in_worker(design.verdict, page.file().name, page.text(), slow=True)


async def gains(page: Page) -> list[dict[str, str]]:
    """Return what each single change of a text would gain, and the texts with them."""
    return await page.work.in_worker(shown.gains, page.file().name, page.text(), slow=True)


async def file_state(page: Page, name: str) -> str:
    """Return which version of a file is on disk; empty where it is gone."""
    try:
        return state(page.folder.file(name))
    except ReadError:
        return ""


async def save(page: Page) -> dict[str, Any]:
    """Save a description unless its file changed meanwhile, or under another, free name; delete its draft."""
    path, text, name = page.file(), page.text(), page.get_body_argument("as")
    source = path.read_bytes()
    target = path
    if name != path.name:
        target = page.folder.free(name if name.endswith(".toml") else f"{name}.toml")
    elif state(path) != page.get_body_argument("state"):
        raise WriteError(f"{path.name} changed on disk since it was opened")
    lines = text.replace("\n", "\r\n") if RETURNS in source else text  # as the file had its lines, and its mark
    write_text(target, f"\ufeff{lines}" if source.startswith(BOM) else lines, overwrite=True)
    draft_of(path).unlink(missing_ok=True)
    return {"name": target.name, "state": state(target)}


def file_text(path: Path) -> str:
    """Return the text of a description as the page edits it."""
    return read_text(path, EXPECTED).replace("\r\n", "\n")


def draft_of(path: Path) -> Path:
    """Return the path of the draft of a description."""
    return path.with_name(path.name + DRAFT)


def keep_draft(path: Path, text: str) -> None:
    """Keep a text as the draft of a description, unless it is as saved."""
    if text == file_text(path):
        draft_of(path).unlink(missing_ok=True)
    else:
        write_text(draft_of(path), text, overwrite=True)
