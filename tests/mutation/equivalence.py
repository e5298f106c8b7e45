"""Mutants that provably compute what the original computes, whatever valid inputs are entered."""

import re
from collections.abc import Callable, Iterator
from functools import cached_property

from openpyxl.formula.tokenizer import Token

from tests.mutation.bench import Bench
from tests.mutation.mutants import REFERENCE, Mutant, tokens_of
from workbook.book.address import Address
from workbook.book.formula import Area, Formula
from workbook.judging.matching import is_formula

SKIPS_TEXT = ("MAX", "MIN", "SUM", "COUNT")
"""Functions to which a range may grow by cells without numbers."""

ALWAYS_OK = re.compile(
    r"(\w+_entries|axis\d_(forward|follows|fills|room)|[A-Z]+\d*_(order|sum|lasts)|move_ok_pieces"
    r"|act_ok_(pieces|rises|shafts|temp|inertia|size)|fly_ok_(length|tools|load|range|pieces|angle|law)"
    r"|tool\d_ok_(angle|turn|entry|pieces)|overlap_ok_rises)(_says)?|entries|backwards|parted"
)
"""Checks of what makes a design unfinished, and what they rest on: no finished one lets them say FAIL."""


class Equivalence:
    """The rules, by what they say; each is asked about a mutant whose value no set of inputs has told apart."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.rules: dict[str, Callable[[Mutant], bool]] = {
            "the same cells: only a $ is gone, and nothing is copied": lambda m: m.kind == "anchor",
            "no input reaches the cell, before or after": self._fixed,
            "the fault lies in a branch of IF that a constant beside it never takes": self._dead,
            "INDEX finds the same cell in a longer range; text and blanks count for nothing": self._longer,
            "factors or summands only change places": commuted,
            "the model refuses inputs at which the check would fail": self._always_ok,
        }

    def reason(self, mutant: Mutant) -> str | None:
        """Return the rule that proves a mutant equivalent, if there is one."""
        return next((words for words, holds in self.rules.items() if holds(mutant)), None)

    @cached_property
    def _fed(self) -> set[Address]:
        """Every cell that some input reaches through formulas."""
        needs = {a: set(precedents(f)) for a, f in self.bench.model.formulas.items()}
        fed = {a for a, pair in self.bench.pairs.items() if pair.cell.quantity.role == "input"}
        while more := {a for a, needed in needs.items() if a not in fed and not fed.isdisjoint(needed)}:
            fed |= more
        return fed

    def _fixed(self, mutant: Mutant) -> bool:
        if mutant.address in self._fed:
            return False
        if not is_formula(mutant.mutated):
            return True
        formula = self.bench.read(mutant)
        return formula is not None and self._fed.isdisjoint(precedents(formula))

    def _dead(self, mutant: Mutant) -> bool:
        if mutant.kind == "name":  # two places change
            return False
        tokens = tokens_of(mutant.original)
        for condition, taken in branches(tokens, mutant.at):
            first, *rest = tokens[slice(*condition)]
            held = self._constant(mutant.address.sheet, first.value)
            compared = len(rest) == 2 and rest[0].value == "=" and rest[1].subtype == "NUMBER"
            if held is not None and compared and taken != (1 if held == float(rest[1].value) else 2):
                return not self._circular(mutant)
        return False

    def _circular(self, mutant: Mutant) -> bool:
        formula = self.bench.read(mutant)
        return formula is not None and mutant.address in precedents(formula)

    def _constant(self, sheet: str, text: str) -> float | None:
        """Return the number in a constant's cell; None for any other cell."""
        if not REFERENCE.fullmatch(text):
            return None
        pair = self.bench.pairs.get(Address.parse(text, sheet))
        return pair.cell.content if pair and pair.cell.quantity.role == "constant" else None

    def _longer(self, mutant: Mutant) -> bool:
        if mutant.kind != "range":
            return False
        tokens = tokens_of(mutant.original)
        before, after = (self._area(t[mutant.at].value, mutant) for t in (tokens, tokens_of(mutant.mutated)))
        if not set(before) < set(after) or mutant.address in after:
            return False
        function, argument, alone = enclosing(tokens, mutant.at)
        if function == "INDEX" and argument == 0:
            return after[0] == before[0] and after[0].column == after[-1].column
        return alone and function in SKIPS_TEXT and all(self._numberless(a) for a in set(after) - set(before))

    def _area(self, text: str, mutant: Mutant) -> list[Address]:
        found = REFERENCE.fullmatch(self.bench.targets.get(text, text))
        if found is None:
            return []
        sheet = (found[1] or mutant.address.sheet).rstrip("!").strip("'")
        first, last = Address.parse(found[2], sheet), Address.parse(found[7] or found[2], sheet)
        return Area(sheet, first.row, first.column, last.row, last.column, single=False).cells()

    def _numberless(self, address: Address) -> bool:
        """Whether a cell holds nothing, or a label: what neither an input nor a formula turns into a number."""
        value = self.bench.file.value(address)
        return address not in self.bench.pairs and (value is None or (isinstance(value, str) and not is_formula(value)))

    def _always_ok(self, mutant: Mutant) -> bool:
        name = self.bench.pairs[mutant.address].cell.quantity.name
        return mutant.kind == "value" and bool(ALWAYS_OK.fullmatch(name))


def precedents(formula: Formula) -> Iterator[Address]:
    """Yield the cells that a formula refers to."""
    for argument in formula.arguments:
        if isinstance(argument, Area):
            yield from argument.cells()


def commuted(mutant: Mutant) -> bool:
    """Whether two names of a plain product, or of a plain sum, have changed places."""
    before, after = tokens_of(mutant.original), tokens_of(mutant.mutated) if is_formula(mutant.mutated) else []
    if sorted(t.value for t in before) != sorted(t.value for t in after):
        return False
    others = {t.value for t in before if t.type != Token.OPERAND}
    return others in ({"*"}, {"+"})


def branches(tokens: list[Token], at: int) -> Iterator[tuple[tuple[int, int], int]]:
    """Yield each IF around a token: where its condition stands, and in which argument of it the token lies."""
    for opened, arguments in calls(tokens):
        if tokens[opened].value == "IF(":
            for n, (start, end) in enumerate(arguments):
                if n and start <= at < end:
                    yield arguments[0], n


def enclosing(tokens: list[Token], at: int) -> tuple[str, int, bool]:
    """Return the innermost function around a token, which argument holds it, and whether it stands there alone."""
    found = [
        (start, tokens[opened].value[:-1], n, end - start == 1)
        for opened, arguments in calls(tokens)
        for n, (start, end) in enumerate(arguments)
        if start <= at < end
    ]
    _, name, n, alone = max(found, default=(0, "", 0, False))
    return name, n, alone


def calls(tokens: list[Token]) -> Iterator[tuple[int, list[tuple[int, int]]]]:
    """Yield each call of a function: where it opens, and the spans of its arguments."""
    stack: list[tuple[int, list[int]]] = []
    for i, token in enumerate(tokens):
        if token.subtype == Token.OPEN:
            stack.append((i, [i + 1]))
        elif token.type == Token.SEP:
            stack[-1][1].append(i + 1)
        elif token.subtype == Token.CLOSE:
            opened, starts = stack.pop()
            if tokens[opened].type == Token.FUNC:
                yield opened, [(a, b - 1) for a, b in zip(starts, [*starts[1:], i + 1], strict=True)]
