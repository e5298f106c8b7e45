"""A formula as a tree of operations, read once for all formulas of the same shape."""

from functools import lru_cache
from typing import Any, NamedTuple

from workbook.book.formula import FormulaError, words

LEVELS = (("=", "<>", "<", ">", "<=", ">="), ("&",), ("+", "-"), ("*", "/"), ("^",))
"""operations of two sides, those that bind least first"""


class Node(NamedTuple):
    """An operation, a call, a number, an argument, constants side by side, or a name or error; and its parts."""

    kind: str
    value: Any = None
    parts: "tuple[Node, ...]" = ()


@lru_cache(maxsize=20_000)
def tree(shape: str) -> Node:
    """Return the tree of a shape such as ``=A1*SUM(A2:B2)``; raise FormulaError where it is no formula."""
    reader = Reader([*words(shape[1:])])
    node = reader.level(0)
    if reader.left:
        raise FormulaError("#NAME?", f"{reader.left[0][1]!r} is not expected")
    return node


class Reader:
    """Takes words from the front of a formula."""

    def __init__(self, found: list[tuple[str, str]]) -> None:
        self.left = found

    def next(self) -> tuple[str, str]:
        """Take the next word; raise FormulaError at the end."""
        if not self.left:
            raise FormulaError("#NAME?", "the formula ends early")
        return self.left.pop(0)

    def sees(self, *signs: str) -> bool:
        """Whether one of these signs comes next."""
        return bool(self.left) and self.left[0][0] == "sign" and self.left[0][1] in signs

    def level(self, depth: int) -> Node:
        """Return what binds at least so much."""
        if depth == len(LEVELS):
            return self.single()
        node = self.level(depth + 1)
        while self.sees(*LEVELS[depth]):
            node = Node("operation", self.next()[1], (node, self.level(depth + 1)))
        return node

    def single(self) -> Node:
        """Return a number, argument, call or bracket, with the signs before and behind it."""
        kind, word = self.next()
        if kind == "sign" and word in "+-":
            return Node("operation", "±", (self.single(),))
        if kind == "function":
            node = Node("call", word[:-1].upper().removeprefix("_XLFN."), self.arguments())
        elif word == "(":
            node = self.level(0)
            self.next()
        elif word == "{":
            while self.next()[1] != "}":
                pass
            node = Node("constants")
        elif kind == "number":
            node = Node("number", float(word))
        elif kind == "reference":
            node = Node("argument", int(word.split(":")[0][1:]) - 1)
        elif kind in ("name", "error"):
            node = Node("other", word)
        else:
            raise FormulaError("#NAME?", f"{word!r} is not expected")
        while self.sees("%"):
            self.next()
        return node

    def arguments(self) -> tuple[Node, ...]:
        """Return the arguments of a call, whose bracket is open; nothing between commas is an empty one."""
        found: list[Node] = []
        while not self.sees(")"):
            found.append(Node("other") if self.sees(",") else self.level(0))
            if not self.sees(")"):
                self.next()
        self.next()
        return tuple(found)
