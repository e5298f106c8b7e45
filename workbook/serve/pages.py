"""The pages: what is in the folder, a description to edit, what a command printed."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from pathlib import Path
from xml.etree.ElementTree import Element

from workbook.reports.html import Content, document, e, markup, table
from workbook.serve.folder import Folder
from workbook.templates import TEMPLATES

VERDICTS = {0: "agrees", 1: "disagrees", 2: "cannot be read", 3: "agrees; the design fails its checks"}


def home(folder: Folder, verdicts: Mapping[str, str], waiting: int) -> str:
    """Return the first page: the folder's files with verdicts, a new machine, an upload, a comparison."""
    rows = [row(path, verdicts) for path in folder.files()]
    queue = [e("p", f"{waiting} commands run or wait for their turn.", css="quiet")] if waiting else []
    file = e("input", type="file", name="book", id="book", accept=".xlsx,.xlsm", required="required")
    names = [path.name for path in folder.files()]
    body = [
        e("h1", "motionbook"), e("p", str(folder.path), css="quiet"), *queue, e("h2", "Machines in this folder"),
        table(("File", "Changed", "In short", "Verdict", ""), rows, ()) if rows else e("p", "No machine yet."),
        e("h2", "New machine"), gallery(),
        e("h2", "Verify a workbook from elsewhere"),
        form("/upload", label("Workbook", "book"), file, button("Verify"), enctype="multipart/form-data"),
        e("h2", "Compare two"), form("/compare", label("Old", "old"), choice("old", names), label("New", "new"),
                                     choice("new", names), button("Compare")),
    ]  # fmt: skip
    return page("motionbook", body, "home")


def row(path: Path, verdicts: Mapping[str, str]) -> list[Content]:
    """Return what the table says of a file, and what can be done with it."""
    changed = f"{datetime.fromtimestamp(path.stat().st_mtime).astimezone():%Y-%m-%d %H:%M}"
    described = path.suffix.lower() == ".toml" and not is_study(path)
    short = e("span", css="quiet", **({"data-short": path.name} if described else {}))
    return [path.name, changed, short, verdicts.get(path.name, "–"), e("span", *actions(path))]


def actions(path: Path) -> list[Element]:
    """Return what can be done with a description, a study or a workbook."""
    name = path.name
    if path.suffix.lower() != ".toml":
        return [post("/verify", name, "Verify"), link(f"/controller/{name}", "Controller"),
                link(f"/file/{name}", "Download")]  # fmt: skip
    if is_study(path):
        return [link(f"/study/{name}", "Study")]
    return [link(f"/edit/{name}", "Edit"), post("/build", name, "Build"), link(f"/vary/{name}", "Study"),
            link(f"/print/{name}", "Print")]  # fmt: skip


def is_study(path: Path) -> bool:
    """Whether a file says what varies in a description, and is none itself."""
    return any(line.startswith("[[vary]]") for line in path.read_text(encoding="utf-8", errors="replace").splitlines())


def gallery() -> Element:
    """Return the templates with their pictures, each with the form that begins a machine."""
    cards = []
    for name in TEMPLATES:
        words = name.replace("-", " ").capitalize()
        picture = e("img", src=f"/picture/{name}.svg", alt=f"{words}: its first chart", width="360", height="200")
        named = e("input", type="text", name="name", value=name, required="required", **{"aria-label": "Name"})
        begin = form("/new", hidden("template", name), named, button("New machine"))
        cards.append(e("div", e("h3", words), picture, begin))
    return e("div", *cards, css="gallery")


def editor(name: str, words: str, state: str, said: str = "", target: str = "") -> str:
    """Return the page on which a description is edited; ``said`` is what there is to say of the text.

    ``target`` is the name that is proposed for saving it, that of the description unless told otherwise.
    """
    area = e("textarea", words, name="text", id="text", rows="34", cols="80", spellcheck="false")
    turns = [e("button", word, type="button", id=word.lower()) for word in ("Undo", "Redo")]
    fields = [hidden("name", name), hidden("state", state), e("p", label("Description", "text"), *turns), area,
              e("p", label("Save as", "as"), text("as", target or name), " ", button("Save", "edit"), " ",
                button("Save and build", "build"))]  # fmt: skip
    live = e("div", e("p", "…", css="quiet"), id="live")
    left = e("div", e("div", id="form"), form("/save", *fields), css="left")
    beside = e("div", left, live, css="beside")
    return page(name, [e("h1", name), back(), e("pre", said, id="said", role="status"), beside], "form", "live")


def framed(report: str, *links: Element) -> str:
    """Return a report of a command with links above it."""
    return report.replace("<body>", f"<body>{markup(back(), e('div', *links, css='above'))}", 1)


def printed(title: str, words: str, verdict: str, *files: Path) -> str:
    """Return the page of what a command printed, and what can be done with the files of it."""
    rows: list[list[Content]] = [[path.name, e("span", *actions(path))] for path in files]
    done = [table(("File", ""), rows, ())] if rows else []
    return page(title, [e("h1", title), back(), e("p", verdict), e("pre", words), *done])


def page(title: str, body: Sequence[Element], *scripts: str) -> str:
    """Return a page with its scripts, and the one that says when the server is at work."""
    return document(title, [*body, *(e("script", src=f"/{one}.js", type="module") for one in ("busy", *scripts))])


def back() -> Element:
    """Return the link to the first page."""
    return e("p", link("/", "All machines"))


def link(href: str, words: str) -> Element:
    """Return a link with room behind it."""
    return e("span", e("a", words, href=href), " ")


def post(action: str, name: str, words: str) -> Element:
    """Return a button that does something with a file."""
    return form(action, hidden("name", name), button(words))


def form(action: str, *content: Content, **attributes: str) -> Element:
    """Return a form that is posted."""
    return e("form", *content, action=action, method="post", **attributes)


def label(words: str, name: str) -> Element:
    """Return the label of a field."""
    return e("label", f"{words} ", **{"for": name})


def choice(name: str, values: Sequence[str], key: str = "") -> Element:
    """Return a field of one of some texts; ``key`` is its own in the page, the name unless told otherwise."""
    return e("select", *(e("option", one, value=one) for one in values), name=name, id=key or name)


def text(name: str, value: str) -> Element:
    """Return a field of one line."""
    return e("input", type="text", name=name, id=name, value=value, required="required")


def hidden(name: str, value: str) -> Element:
    """Return a field that is not shown."""
    return e("input", type="hidden", name=name, value=value)


def button(words: str, then: str = "") -> Element:
    """Return what sends a form; of several in one form, ``then`` says which was pressed."""
    return e("button", words, type="submit", **({"name": "then", "value": then} if then else {}))
