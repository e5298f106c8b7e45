"""Declare cells by tables in Markdown beside the code: words and formulas there, the engine's values from Python.

``power.py`` has its tables in ``power.md``, each under a heading, a row a cell. The two hands that compute a cell so
stand apart: an engineer reads how the sheet does it, without any Python; and no formula knows the engine.

===========  ====================================================================================================
``kind``     calc, result, given, constant or check (:mod:`workbook.book.quantity`); entry: given, with its value
             from the part of a description that :meth:`CellTable.entries` is given; key: an entry that has no cell
``cell``     its name
``formula``  in the notation of :mod:`workbook.book.declare`; of what is given its key in the description; of a
             check its condition, without =
``source``   the note beside it
others       label, symbol, unit, format, align, choices; of a check its rule, and what it says where it fails; of
             an entry its meaning, an example, what it is in variations (:mod:`workbook.entries.facts`)
===========  ====================================================================================================

A text may have ``{parts}``, which Python fills in, of other names than :data:`OWN`; braces of Excel are written twice.
Of a column whose formula has a part that is a list, each row has the formula with its own.
"""

import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Sequence
from operator import attrgetter
from pathlib import Path
from string import Formatter
from typing import Any, NamedTuple

from workbook.book.quantity import PLAIN, Quantity, calc, check, constant, given, result
from workbook.book.rows import filled

KINDS: dict[str, Callable[..., Quantity]] = {
    "calc": calc,
    "result": result,
    "given": given,
    "constant": constant,
    "check": check,
    "entry": given,
}
FORMULAS = {"given": "key", "entry": "key", "key": "key", "check": "condition"}
"""by kind, the attribute that stands in the column of formulas"""
OWN = frozenset("formula source scale format align choices limit upper_limit wrap says".split())
"""attributes that Python may give a cell"""
HEADING, BAR = re.compile(r"^## (.+)$", re.MULTILINE), re.compile(r"(?<!\\)\|")


def value_of(text: str) -> Any:
    """Return the number, word or list (of TOML) that a text stands for; None of an empty one, and of the word empty."""
    try:
        return float(text)
    except ValueError:
        listed = text.startswith("[") or text == "true"
        return tomllib.loads(f"value = {text}")["value"] if listed else None if text in ("", "empty") else text


class CellWords(NamedTuple):
    """The words of a cell, with parts to fill in."""

    kind: str
    texts: dict[str, str]  # by attribute
    parts: frozenset[str]  # names of what is to be filled in
    example: Any = None
    varies: tuple[Any, ...] = ()
    meaning: str = ""

    @classmethod
    def of_row(cls, texts: dict[str, str]) -> "CellWords":
        """Return the words of a row, whose texts are given by the heads of their columns."""
        kind, name, formula = (texts.pop(head, "") for head in ("kind", "cell", "formula"))
        example, varies, meaning = (texts.pop(head, "") for head in ("example", "varies", "meaning"))
        empty = {"label": ""} if kind == "check" else {"label": "", "symbol": "", "unit": ""}
        texts = {"name": name} | empty | texts | ({FORMULAS.get(kind, "formula"): formula} if formula else {})
        fields = (field for text in texts.values() for _, field, _, _ in Formatter().parse(text) if field)
        parts = frozenset(re.split(r"[.\[]", field)[0] for field in fields)
        values = tuple(map(value_of, filter(None, varies.split(", "))))
        return cls(kind, texts, parts, value_of(example), values, meaning)

    def filled(self, more: dict[str, Any]) -> dict[str, Any]:
        """Return the attributes of a cell: its words with their parts, and those attributes that are given.

        Raises
        ------
        TypeError
            Where a part is missing, or something is given that no text has.
        """
        own = {key: more.pop(key) for key in OWN & more.keys()}
        if more.keys() != self.parts:
            raise TypeError(f"{self.texts['name']}: given {sorted(more)}; expected {sorted(self.parts)}")
        lists = {part: value for part, value in more.items() if isinstance(value, list)}
        rows = [more | dict(zip(lists, row, strict=True)) for row in zip(*lists.values(), strict=True)]
        texts = {name: text.format(**more) for name, text in self.texts.items()}
        by_row = {"formula": [self.texts["formula"].format(**row) for row in rows]} if rows else {}
        return texts | by_row | own


class CellTable(dict[str, CellWords]):
    """The rows of a table by their cells' names."""

    def __call__(self, name: str, value: Any, /, **more: Any) -> Quantity:
        """Return the quantity of a row.

        Parameters
        ----------
        name : str
            Of the cell, as the table has it.
        value : object
            What the engine says of it, in its unit; of a given cell what is entered; of a check whether it holds; of
            a column a sequence.
        **more
            What the texts of the row have in braces, and attributes that are no fixed words.

        Raises
        ------
        KeyError
            Where the table has no such cell.
        TypeError
            Where a part is missing, or something is given that no text has.
        """
        row = self[name]
        return KINDS[row.kind](**{"ok" if row.kind == "check" else "value": value}, **row.filled(more))

    def of_rows(self, rows: Iterable[Any], **attributes: str) -> list[Quantity]:
        """Return columns by their names, each with the values that an attribute of the rows has."""
        return [self(name, [*map(attrgetter(attribute), rows)]) for name, attribute in attributes.items()]

    def entries(self, model: Any, place: str) -> Callable[..., Quantity]:
        """Return a function that declares an input by the name of its row; the model stands at a place."""

        def entry(name: str, /, **more: Any) -> Quantity:
            texts = self[name].filled(more)
            value = attrgetter(texts["key"])(model)
            own = {"format": "" if isinstance(value, str) else PLAIN} | texts
            return given(value=value, **own | {"key": f"{place}.{texts['key']}"})

        return entry

    def columns(self, models: Sequence[Any], place: str, rows: int) -> Callable[..., Quantity]:
        """Return a function that declares an input column by the name of its row; the models stand at a place."""

        def column(name: str, /, **more: Any) -> Quantity:
            texts = self[name].filled(more)
            values = filled([getattr(model, texts["key"]) for model in models], rows, None)
            return given(value=values, **texts | {"key": f"{place}.*.{texts['key']}"})

        return column


def cell_tables(module: str) -> dict[str, CellTable]:
    """Return the tables of the Markdown file beside a module, whose ``__file__`` is given, by their headings."""
    return {title: CellTable(rows_of(text)) for title, text in sections(module)}


def sections(module: str) -> Iterator[tuple[str, str]]:
    """Yield the headings of the Markdown file beside a module, each with the text below it."""
    _, *parts = HEADING.split(Path(module).with_suffix(".md").read_text(encoding="utf-8"))
    yield from zip(parts[::2], parts[1::2], strict=True)


def rows_of(text: str) -> Iterator[tuple[str, CellWords]]:
    """Yield the rows of a Markdown table of cells, each with the name of its cell."""
    for texts in markdown_rows(text):
        yield texts.get("cell") or texts["formula"], CellWords.of_row(texts)


def markdown_rows(text: str) -> Iterator[dict[str, str]]:
    """Yield the rows of a Markdown table, each with its entries by the heads of their columns; empty ones left out."""
    lines = (BAR.split(line)[1:-1] for line in text.splitlines() if line.startswith("|"))
    heads, _, *rows = ([entry.strip() for entry in line] for line in lines)
    for row in rows:
        yield {head: entry.strip("`").replace("\\|", "|") for head, entry in zip(heads, row, strict=True) if entry}
