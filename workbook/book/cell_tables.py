"""Declare cells by tables in Markdown beside the code: words and formulas there, the engine's values from Python.

``power.py`` has its tables in ``power.md``, each under a heading, a row a cell. The two hands that compute a cell so
stand apart: an engineer reads how the sheet does it, without any Python; and no formula knows the engine.

===========  ====================================================================================================
``kind``     calc, result, given, constant, sentence, verdict, check (:mod:`workbook.book.quantity`); limit: a check of
             a figure that may have no limit, which is 0 then (:meth:`CellTable.limit`); entry: given, with its value
             from the part of a description that :meth:`CellTable.entries` is given; key: an entry that has no cell;
             number: the first column of a table, which counts its rows
``cell``     its name
``formula``  in the notation of :mod:`workbook.book.declare`; of what is given its key in the description; of a
             check its condition, without =
``source``   the note beside it
``scale``    by what its deviations are measured: a number, or the name of a part that Python gives
others       label, symbol, unit, format, align, choices; of a check its rule, and what it says where it fails; of
             an entry its meaning, an example, what it is in variations (:mod:`workbook.entries.facts`)
===========  ====================================================================================================

Above its rows a table may have its own name and title, as ``name``: title; :meth:`CellTable.place` puts it on a sheet.
Above these, behind ``>``, heading and note of a part of a sheet may stand, which :meth:`CellTable.begin` begins.
A text may have ``{parts}``, which Python fills in, of other names than :data:`OWN`; braces of Excel are written twice.
Of a column whose formula has a part that is a list, each row has the formula with its own.
"""

import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from operator import attrgetter
from pathlib import Path
from string import Formatter
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from workbook.book.chart import Chart, Series
from workbook.book.limits import RowRule
from workbook.book.quantity import PLAIN, Block, Quantity, check
from workbook.book.rows import filled
from workbook.book.sentence import NOTHING, CheckSentence, exceeding

if TYPE_CHECKING:
    from workbook.book.sheet import Sheet

ROLES: dict[str, Any] = {
    "calc": "calculation", "given": "input", "entry": "input", "number": "constant", "verdict": "check",
}  # fmt: skip
"""the roles of quantities by kinds whose names are others"""
FORMULAS = {"given": "key", "entry": "key", "key": "key", "check": "condition", "limit": "condition"}
"""by kind, the attribute that stands in the column of formulas"""
OWN = frozenset("formula source scale format align choices limit upper_limit wrap says".split())
"""attributes that Python may give a cell"""
HEADING, BAR = re.compile(r"^## (.+)$", re.MULTILINE), re.compile(r"(?<!\\)\|")
HEAD = re.compile(r"^`(\S+)`: (.+)$", re.MULTILINE)
BEGIN = re.compile(r"^> (.+)\n> (.+)$", re.MULTILINE)


MORE = ("example", "varies", "meaning", "scale", "head")
"""heads of columns that are no attributes of a quantity"""


def value_of(text: str) -> Any:
    """Return the number, word or list (of TOML) that a text stands for; None of an empty one, and of the word empty."""
    try:
        return float(text)
    except ValueError:
        listed = text.startswith("[") or text == "true"
        if listed:
            return tomllib.loads(f"value = {text}")["value"]
        if text in ("", "empty"):
            return None
        return text


class CellWords(NamedTuple):
    """The words of a cell, with parts to fill in."""

    kind: str
    texts: dict[str, str]  # by attribute
    parts: frozenset[str]  # names of what is to be filled in
    example: Any = None
    varies: tuple[Any, ...] = ()
    meaning: str = ""
    scale: str = ""
    head: str = ""

    @classmethod
    def of_row(cls, texts: dict[str, str]) -> "CellWords":
        """Return the words of a row, whose texts are given by the heads of their columns."""
        kind, name, formula = (texts.pop(head, "") for head in ("kind", "cell", "formula"))
        example, varies, meaning, scale, csv = (texts.pop(head, "") for head in MORE)
        empty = {"label": ""} if kind in ("check", "limit") else {"label": "", "symbol": "", "unit": ""}
        texts = {"name": name} | empty | texts | ({FORMULAS.get(kind, "formula"): formula} if formula else {})
        fields = (field for text in texts.values() for _, field, _, _ in Formatter().parse(text) if field)
        parts = {re.split(r"[.\[]", field)[0] for field in fields} | ({scale} if scale.isidentifier() else set())
        values = tuple(map(value_of, filter(None, varies.split(", "))))
        return cls(kind, texts, frozenset(parts), value_of(example), values, meaning, scale, csv)

    def filled(self, more: dict[str, Any]) -> dict[str, Any]:
        """Return the attributes of a cell: its words with their parts, and those attributes that are given.

        Raises TypeError where a part is missing, or something is given that no text has.
        """
        own = {key: more.pop(key) for key in OWN & more.keys()}
        if more.keys() != self.parts:
            raise TypeError(f"{self.texts['name']}: given {sorted(more)}; expected {sorted(self.parts)}")
        lists = {part: value for part, value in more.items() if isinstance(value, list)}
        rows = [more | dict(zip(lists, row, strict=True)) for row in zip(*lists.values(), strict=True)]
        texts = {name: text.format(**more) for name, text in self.texts.items()}
        by_row = {"formula": [self.texts["formula"].format(**row) for row in rows]} if rows else {}
        scale = {"scale": more[self.scale] if self.scale in more else float(self.scale)} if self.scale else {}
        return texts | by_row | scale | own


class CellTable(dict[str, CellWords]):
    """The rows of a table by their cells' names, with its name, title and heading, and the parts that rows share."""

    head: tuple[str, ...] = ()
    heading: tuple[str, ...] = ()
    shared: Mapping[str, Any] = {}

    def sharing(self, **parts: Any) -> Self:
        """Return the same table, each row of which takes of these parts those that its texts have."""
        table = copy(self)
        table.shared = {**self.shared, **parts}
        return table

    def __call__(self, name: str, value: Any, /, **more: Any) -> Quantity:
        """Return the quantity of the cell of this name; raise KeyError where the table has none.

        ``value`` is what the engine says of it, in its unit; of a given cell what is entered; of a check whether it
        holds; of a column a sequence. ``more`` is what its texts have in braces, and attributes of :data:`OWN`; raises
        TypeError where a part is missing, or something is given that no text has.
        """
        kind, texts = self[name].kind, self._filled(name, more)
        if kind == "check":
            return check(ok=value, **texts)
        return Quantity(role=ROLES.get(kind, kind), value=value, **texts)

    def limit(self, name: str, value: float, most: float, /, then: CheckSentence = NOTHING, **more: Any) -> Quantity:
        """Return the check that a value is within its limit: its row has the formula value<=limit, and their unit.

        Where it fails, its sentence says by how much, and ``then`` what else.
        """
        texts, may_lack = self._filled(name, more), self[name].kind == "limit"
        figure, limit = texts["condition"].split("<=")
        says = exceeding(figure, limit, texts.pop("unit"), value, most).then(then)
        if may_lack:
            texts["condition"] = f"OR({limit}=0,{texts['condition']})"
        return check(ok=value <= most or (may_lack and not most), says=says, **texts)

    def _filled(self, name: str, more: dict[str, Any]) -> dict[str, Any]:
        row = self[name]
        return row.filled({part: self.shared[part] for part in row.parts & self.shared.keys()} | more)

    def begin(self, sheet: "Sheet") -> None:
        """Begin the part of a sheet whose heading and note stand above the table."""
        sheet.heading(*(text.format(**self.shared) for text in self.heading))

    def place(
        self, sheet: "Sheet", *columns: Quantity, rules: Sequence[RowRule] = (), blank: str = "", heads: bool = True
    ) -> Block:
        """Place the table below what is on a sheet, as long as its columns, as :meth:`Sheet.table` does."""
        size = max(len(q.value) for q in columns if not isinstance(q.value, str) and hasattr(q.value, "__len__"))
        numbers = [self(name, list(range(1, size + 1))) for name, row in self.items() if row.kind == "number"]
        name, title = (text.format(**self.shared) for text in self.head)
        return sheet.table(name, title, size, *numbers, *columns, rules=rules, blank=blank, heads=heads)

    def of_rows(self, rows: Iterable[Any], **attributes: str) -> list[Quantity]:
        """Return columns by their names, each with the values that an attribute of the rows has."""
        return [self(name, [*map(attrgetter(attribute), rows)]) for name, attribute in attributes.items()]

    def entries(self, model: Any, place: str) -> Callable[..., Quantity]:
        """Return a function that declares an input by the name of its row; the model stands at a place."""

        def entry(name: str, /, **more: Any) -> Quantity:
            texts = self._filled(name, more)
            value = attrgetter(texts["key"])(model)
            own = {"format": "" if isinstance(value, str) else PLAIN} | texts
            return Quantity(role="input", value=value, **own | {"key": f"{place}.{texts['key']}"})

        return entry

    def columns(self, models: Sequence[Any], place: str, rows: int) -> Callable[..., Quantity]:
        """Return a function that declares an input column by the name of its row; the models stand at a place."""

        def column(name: str, /, **more: Any) -> Quantity:
            texts = self._filled(name, more)
            values = filled([getattr(model, texts["key"]) for model in models], rows, None)
            return Quantity(role="input", value=values, **texts | {"key": f"{place}.*.{texts['key']}"})

        return column


def cell_tables(module: str) -> dict[str, CellTable]:
    """Return the tables of the Markdown file beside a module, whose ``__file__`` is given, by their headings."""
    tables = {}
    for title, text in sections(module):
        if not re.search(r"\| (cell|formula) \|", text):
            continue  # a table for :func:`formulas_by_row`
        tables[title] = CellTable(rows_of(text))
        tables[title].head = next(iter(HEAD.findall(text)), ())
        tables[title].heading = next(iter(BEGIN.findall(text)), ())
    return tables


def formulas_by_row(module: str, title: str, **parts: str) -> dict[str, list[str]]:
    """Return the columns of the table under a heading beside a module: texts, each row of the sheet with its own."""
    rows = list(markdown_rows(dict(sections(module))[title]))
    return {head: [row[head].format(**parts) for row in rows] for head in rows[0]}


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


AXES = re.compile(r"^`(.+)`, `(.+)`: (.+)$", re.MULTILINE)


def charts_beside(module: str) -> dict[str, Chart]:
    """Return the charts of the file ``charts.md`` beside a module, whose ``__file__`` is given, by their titles.

    Below each stand the titles of its axes, and what it shows; of the table a row is a line, with the fields of Series.
    """
    charts = {}
    for title, text in sections(str(Path(module).with_name("charts.md"))):
        x, y, about = AXES.findall(text)[0]
        lines: list[Series] = []
        for row in markdown_rows(text):
            drawn = {field: value == "yes" for field, value in row.items() if field in ("dashed", "points")}
            lines.append(Series(**{**row, **drawn}))  # type: ignore[arg-type]
        charts[title] = Chart(title, x, y, tuple(lines), about)
    return charts
