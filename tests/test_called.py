"""The engine is what the product uses: nothing in it that neither the workbooks call nor an example shows."""

import ast
import contextlib
import io
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXAMPLE = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PRINTED = re.compile(r"^ *print\(.*\)  # (.*)$", re.MULTILINE)

Name = tuple[str, str]
"""A function or class by its module and name; a method by the empty text and its name, whosoever it is."""


class Source:
    """A module, and what the names in it stand for."""

    def __init__(self, module: str, text: str) -> None:
        self.module, self.tree = module, ast.parse(text)
        self.own = {n.name for n in self.tree.body if isinstance(n, ast.FunctionDef | ast.ClassDef)}
        self.imported: dict[str, Name] = {}
        for node in ast.walk(self.tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                self.imported |= {part.asname or part.name: (node.module, part.name) for part in node.names}

    def mentions(self, nodes: Iterable[ast.AST], of_itself: bool = True) -> Iterator[Name]:
        """The names that pieces of this module use; what it only imports counts for nothing."""
        for node in (node for top in nodes for node in ast.walk(top)):
            if isinstance(node, ast.Name):
                if node.id in self.own:
                    yield self.module, node.id
                elif node.id in self.imported:
                    yield self.imported[node.id]
            elif isinstance(node, ast.Attribute):
                holder = node.value.id if isinstance(node.value, ast.Name) else ""
                if of_itself or holder not in ("self", "cls"):
                    yield "", node.attr
                if holder in self.imported:  # a module that was imported as a whole
                    yield ".".join(self.imported[holder]), node.attr


class Engine:
    """What the engine offers, and which names lead to which."""

    def __init__(self, sources: Iterable[Source]) -> None:
        self.sources = {source.module: source for source in sources}
        self.offered: dict[str, Name] = {}  # public things, as they are printed
        self.leads: dict[Name, set[Name]] = {}
        self.at_import: set[Name] = set()
        for source in self.sources.values():
            for node in source.tree.body:
                self._take(source, node)

    def _take(self, source: Source, node: ast.stmt) -> None:
        if isinstance(node, ast.ClassDef):
            methods = [part for part in node.body if isinstance(part, ast.FunctionDef)]
            public = [method for method in methods if not method.name.startswith("_")]
            for method in public:
                self._offer(f"{node.name}.{method.name}", ("", method.name), source, [method])
            rest = [part for part in ast.iter_child_nodes(node) if part not in public]
            self._offer(node.name, (source.module, node.name), source, rest)
        elif isinstance(node, ast.FunctionDef):
            self._offer(node.name, (source.module, node.name), source, [node])
        else:
            self.at_import |= {self.home(name) for name in source.mentions([node])}

    def _offer(self, said: str, name: Name, source: Source, nodes: list[ast.AST]) -> None:
        if not said.startswith("_"):
            self.offered[f"{source.module}.{said}"] = name
        self.leads.setdefault(name, set()).update(map(self.home, source.mentions(nodes)))

    def home(self, name: Name) -> Name:
        """Where a name is defined, however many modules hand it on."""
        source = self.sources.get(name[0])
        if source is None or name[1] in source.own or source.imported.get(name[1], name) == name:
            return name
        return self.home(source.imported[name[1]])

    def called(self, outside: Iterable[Source]) -> set[Name]:
        """What is called from outside."""
        return {self.home(name) for source in outside for name in source.mentions([source.tree], of_itself=False)}

    def unreached(self, outside: Iterable[Source]) -> list[str]:
        """What is called neither from outside, nor by what is, and so on."""
        fresh = self.called(outside) | self.at_import
        reached: set[Name] = set()
        while fresh:
            reached |= fresh
            fresh = set().union(*(self.leads.get(name, set()) for name in fresh)) - reached
        return [said for said, name in self.offered.items() if name not in reached]


def sources(package: str) -> Iterator[Source]:
    for path in sorted((ROOT / package).rglob("*.py")):
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        yield Source(module, path.read_text(encoding="utf-8"))


def examples() -> Iterator[Source]:
    """The Python that README and the guides show."""
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))):
        yield from (Source("", text) for text in EXAMPLE.findall(path.read_text(encoding="utf-8")))


def test_the_product_or_an_example_calls_all_that_the_engine_offers() -> None:
    found = Engine(sources("engine")).unreached([*sources("workbook"), *examples()])
    assert not found, "\n".join(found)


MANY = 3  # parameters, from which on a sentence no longer tells them
PLAIN = re.compile(r"\b(float|int|bool|str|Array|NDArray|dict)\b")  # types that tell neither shape nor unit
PARAMETERS = re.compile(r"^(\w+(?:, \w+)*)(?: : .*)?$", re.MULTILINE)


def functions(source: Source) -> Iterator[tuple[Name, ast.FunctionDef]]:
    """The public functions and methods of a module, as :data:`Name` has them."""
    for scope in (source.tree, *(node for node in source.tree.body if isinstance(node, ast.ClassDef))):
        for one in scope.body:
            if isinstance(one, ast.FunctionDef) and not one.name.startswith("_"):
                yield (source.module if scope is source.tree else "", one.name), one


def untold(one: ast.FunctionDef) -> Iterator[str]:
    """What a docstring leaves out that numpydoc's sections should tell."""
    taken = {a.arg for a in ast.walk(one.args) if isinstance(a, ast.arg)} - {"self", "cls"}
    _, _, told = (ast.get_docstring(one) or "").partition("\nParameters\n----------\n")
    parameters, returns, _ = told.partition("\nReturns\n-------\n")
    if len(taken) >= MANY:
        yield from sorted(taken - set(re.findall(r"\w+", " ".join(PARAMETERS.findall(parameters)))))
        if one.returns and PLAIN.search(ast.unparse(one.returns)) and not returns:
            yield "what it returns"


def test_what_others_call_of_the_engine_tells_each_of_many_parameters() -> None:
    engine = Engine(sources("engine"))
    called = engine.called([*sources("workbook"), *examples()])
    found = [
        f"{source.module}.{one.name}: {', '.join(missing)}"
        for source in engine.sources.values()
        for name, one in functions(source)
        if name in called and (missing := list(untold(one)))
    ]
    assert not found, "\n".join(found)


def test_the_examples_run_and_those_of_the_guides_print_what_stands_beside() -> None:
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))):
        for text in EXAMPLE.findall(path.read_text(encoding="utf-8")):
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(text, path.name, "exec"), {})  # noqa: S102 - the project's own text
            assert path.name == "README.md" or printed.getvalue().splitlines() == PRINTED.findall(text)
