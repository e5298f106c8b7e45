"""The functions MOTION.* of ``functions.toml``, for both back ends; docs/motion-functions.md has what both promise."""

import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from workbook.functions.addin.motion_functions.library import LAWS
from workbook.laws.registry import FAMILY


class Text(NamedTuple):
    """The same words in English, Italian and German."""

    en: str
    it: str
    de: str


NAMESPACE = "MOTION"
TEXTS = tomllib.loads(Path(__file__).with_name("functions.toml").read_text(encoding="utf-8"))
CODES: tuple[str, ...] = tuple(code for code, page in FAMILY.items() if page.functions)
"""codes of the laws that the functions know: of every family but points, which are a table of their own"""
# what each law takes that takes anything
TAKES = {code: Text(*law.takes) for code, law in LAWS.items() if law.takes} | {"OWN": Text(*TEXTS["own"])}


class Argument(NamedTuple):
    """An argument: what it takes (a law's code, a number, a range or array or single value, a table of phases)."""

    kind: str
    name: Text
    help: Text
    optional: bool  # whether it may be left out

    @property
    def shown(self) -> str:
        """The name as a call shows it: in brackets where it may be left out."""
        return f"[{self.name.en}]" if self.optional else self.name.en


class Function(NamedTuple):
    """A function: the last part of its name, what it returns, its arguments; the last of them may be optional ones."""

    key: str
    help: Text
    arguments: list[Argument]

    @property
    def name(self) -> str:
        """The name as it stands in a formula and in the file."""
        return f"{NAMESPACE}.{self.key}"


def with_law_texts(texts: Sequence[str]) -> Text:
    """Return texts of three languages with the codes of the laws, and with what each law takes."""
    languages = []
    for words, text in zip(zip(*TAKES.values(), strict=True), texts, strict=True):
        alike = {text: [code for code, other in zip(TAKES, words, strict=True) if other == text] for text in words}
        takes = "; ".join(f"{', '.join(codes)}: {words}" for words, codes in alike.items())
        languages.append(text.format(codes=", ".join(CODES[:-1]), last=CODES[-1], takes=takes))
    return Text(*languages)


ARGUMENTS = {
    name: Argument(row["kind"], Text(*row["name"]), with_law_texts(row["help"]), row.get("optional", False))
    for name, row in TEXTS["arguments"].items()
}
FUNCTIONS = [
    Function(key, with_law_texts(entry["help"]), [ARGUMENTS[name] for name in entry["arguments"]])
    for key, entry in TEXTS["functions"].items()
]
