"""Whether a formula takes one cell of a range by where it stands, as Excel does and evaluators do not."""

from workbook.book.formula import words

SIGNS = frozenset("+-*/^&=<>%")
OVER_ARRAYS = frozenset(("SUMPRODUCT(", "MMULT(", "LOOKUP("))
"""functions that take all cells of what is computed in them"""


def spreads(formula: str) -> bool:
    """Return whether a range stands outside of every function, or is computed with where one cell of it is taken.

    "Implicit intersection operator: @" (support.microsoft.com): a formula that is no array formula takes of such a
    range the cell in its own row or column.
    """
    found = list(words(formula.removeprefix("=")))
    begun: list[str] = []
    for k, (kind, word) in enumerate(found):
        if kind == "function" or word == "(":
            begun.append(word.upper())
        elif word == ")" and begun:
            begun.pop()
        elif kind == "lines" or (kind == "reference" and several(word)):
            called = [one for one in begun if one != "("]
            if not called or (computed(found, k) and OVER_ARRAYS.isdisjoint(called)):
                return True
    return False


def several(word: str) -> bool:
    """Whether a reference means more cells than one."""
    first, _, last = word.rpartition("!")[2].replace("$", "").upper().partition(":")
    return last not in ("", first)


def computed(found: list[tuple[str, str]], k: int) -> bool:
    """Whether a sign of an operation stands before or behind a word, its brackets left aside."""
    before, after = k - 1, k + 1
    while before >= 0 and after < len(found) and (found[before][1], found[after][1]) == ("(", ")"):
        before, after = before - 1, after + 1
    beside = [found[at][1] for at in (before, after) if 0 <= at < len(found)]
    return not SIGNS.isdisjoint(beside)
