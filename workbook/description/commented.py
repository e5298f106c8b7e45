"""A description to begin with: what an example enters, then in comments what is rarely needed."""

import textwrap
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from workbook.description.keys import Key, Section, default_of, sections, toml
from workbook.entries.rules import KIND
from workbook.fields.paths import key_of
from workbook.templates import AnyTemplate

WIDTH, COLUMN = 116, 32
AXES = 2
# what an example of a machine has and a first machine does not need
RARE = ("clearances", "sizes", "switches")
HEAD = "A machine to begin with: change what differs. What is rarely needed stands below, in comments."
REST = (
    "Rarely needed. Move a line up into its table and take the # away. A table of several kinds takes the keys of its "
    "own kind. The parameters of the laws are explained in docs/laws.md."
)


def commented_description(template: AnyTemplate, schema: str) -> str:
    """Return a new description of a template; ``schema`` is the file that editors complete its keys from."""
    data = tomllib.loads(template.description.read_text(encoding="utf-8"))
    if "axes" in data:  # two of them at most, and nothing that is rare
        data = {name: value for name, value in data.items() if name not in RARE} | {"axes": data["axes"][:AXES]}
    file = DescriptionWriter(sections(template))
    first = "\n".join([f"#:schema {schema}", *comments(HEAD)])
    return "\n\n".join([first, *file.tables("", "", data), "\n".join(comments(REST)), *file.rest()]) + "\n"


class DescriptionWriter:
    """A description that is being written; each key is explained where it first stands."""

    def __init__(self, known: Sequence[Section]) -> None:
        self.known = known
        self.written: set[tuple[str, str]] = set()

    def tables(self, title: str, path: str, data: Mapping[str, Any]) -> Iterator[str]:
        """Yield a table, and those below it."""
        own = [part for part in self.known if part.path == path and part.kind in ("", data.get(KIND))]
        entries = [(key, part.kind) for part in own for key in part.keys if key.name in data]
        lines = table_head(title, path)
        lines += [f"family = {toml(data['family'])}"] if path.startswith("laws.") and "family" in data else []
        lines += [line for key, kind in entries for line in self.entry(key, kind, data[key.name])]
        if own:
            yield "\n".join(lines)
        plain = {key.name for key, _ in entries}
        for name, value in data.items():
            if name not in plain:
                yield from self.tables_below(title, path, name, value)

    def tables_below(self, title: str, path: str, name: str, value: Any) -> Iterator[str]:
        """Yield the tables of an entry that is a table or a list of tables."""
        inner, below = f"{title}.{name}".strip("."), f"{path}.{name}".strip(".")
        if isinstance(value, list):
            for row in value:
                yield from self.tables(inner, f"{below}.*", row)
        elif isinstance(value, dict) and path == "laws":
            yield from self.tables(f"laws.{key_of(name)}", f"laws.{value.get('family', name)}", value)
        elif isinstance(value, dict):
            yield from self.tables(inner, below, value)

    def entry(self, key: Key, kind: str, value: Any) -> Iterator[str]:
        """Yield the lines of an entry."""
        new = (key.path, kind) not in self.written
        self.written.add((key.path, kind))
        if not (key.rows and value):
            yield from line(f"{key.name} = {toml(value)}", about(key) if new else "")
            return
        used = [row for row in key.rows if any(row.name in entry for entry in value)]
        self.written |= {(row.path, kind) for row in used}
        if new:
            yield from comments(f"{key.meaning}: {', '.join(with_unit(row) for row in used)}")
        yield f"{key.name} = ["
        yield from (f"  {toml(row)}," for row in value)
        yield "]"

    def unwritten(self, keys: Sequence[Key], kind: str) -> list[Key]:
        """Return the keys of a kind that have not been written yet."""
        return [key for key in keys if (key.path, kind) not in self.written]

    def rest(self) -> Iterator[str]:
        """Yield in comments the keys that have not been written yet, and a line for each family of laws."""
        laws = ["# [laws]"]
        for part in self.known:
            if part.path.startswith("laws."):
                code = part.path.rpartition(".")[2]
                laws.append(f"# {code} = {toml({'family': code} | {key.name: example_of(key) for key in part.keys})}")
                continue
            keys = self.unwritten(part.keys, part.kind)
            written = (key for key in part.keys if key not in keys)
            rows = [row for key in written for row in self.unwritten(key.rows, part.kind)]
            lines = [text for key in keys for text in unused_key_lines(key)]
            for row in rows:
                lines += line(f"#   {row.path.split('.')[-3]}: {row.name} = {toml(example_of(row))}", about(row))
            head = [f"# {text}" for text in table_head(part.path.removesuffix(".*").replace(".*", ""), part.path)]
            kind = [f"# kind = {toml(part.kind)}"] if part.kind else []
            if lines:
                yield "\n".join([*head, *kind, *lines])
        yield "\n".join(laws)


def table_head(title: str, path: str) -> list[str]:
    """Return the line above a table, or above a row of a list; nothing for the entries above all tables."""
    return [f"[[{title}]]" if path.endswith(".*") else f"[{title}]"] if title else []


def unused_key_lines(key: Key) -> Iterator[str]:
    """Yield the lines of a key that the example does not have."""
    default = default_of(key)
    more = f"; else {default}" if default not in ("", "none") and not key.rows else ""
    rows = f": {', '.join(map(with_unit, key.rows))}" if key.rows else ""
    yield from line(f"# {key.name} = {toml(example_of(key))}", f"{about(key)}{more}{rows}")


def example_of(key: Key) -> Any:
    """Return an entry of a real machine, or else what the key is by default."""
    return key.default if key.example is None else key.example


def about(key: Key) -> str:
    """Return the meaning of a key, with its unit, or the words that it takes."""
    words = isinstance(example_of(key), str) and not (key.rows or key.expected.startswith("a text"))
    return f"{with_unit(key, key.meaning)}{f': {key.expected}' if words else ''}"


def with_unit(key: Key, text: str = "") -> str:
    """Return the name of a key, or a text about it, with its unit."""
    return f"{text or key.name}{f' [{key.unit}]' if key.unit else ''}"


def line(text: str, remark: str) -> Iterator[str]:
    """Yield an entry with a remark behind it, or above it if both are too long for a line."""
    if not remark:
        yield text
    elif len(joined := f"{text:<{COLUMN}}  # {remark}") <= WIDTH:
        yield joined
    else:
        yield from comments(remark)
        yield text


def comments(text: str) -> list[str]:
    """Return a text as comments."""
    return [f"# {row}" for row in textwrap.wrap(text, WIDTH - 2, break_long_words=False, break_on_hyphens=False)]
