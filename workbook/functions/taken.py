"""What each law takes as parameters of the functions MOTION.*, in three languages."""

from __future__ import annotations

from typing import NamedTuple

from engine.laws.entry import IncompleteError
from workbook.laws.registry import FAMILIES
from workbook.laws.tops import OWN_ENTRIES


class Text(NamedTuple):
    """The same words in English, Italian and German."""

    en: str
    it: str
    de: str


LANGUAGES: tuple[str, ...] = Text._fields
OWN_WIDTH = len(OWN_ENTRIES)
CODES: tuple[str, ...] = tuple(family.code for family in FAMILIES if family.page.functions)
"""codes of the laws that the functions know: of every family but points, which are a table of their own"""
SHARE = Text(
    "share λ of the time that accelerates", "quota λ del tempo in accelerazione", "Anteil λ der Beschleunigung"
)
RAMPS = Text(
    "end of acceleration, start of deceleration",
    "fine dell'accelerazione, inizio della decelerazione",
    "Ende der Beschleunigung, Beginn der Verzögerung",
)
SEVEN = Text("seven durations", "sette durate", "sieben Dauern")
TAKES = {
    **dict.fromkeys(("ACS", "CIC", "CUB", "SHM", "PO5", "PO7"), SHARE),
    **dict.fromkeys(("TVP", "SRT"), RAMPS),
    **dict.fromkeys(("MTP", "SCV"), SEVEN),
    "DHM": Text("turns round at start or end", "inverte a start o end", "kehrt um bei start oder end"),
    "MSN": Text("λ, first edge, last edge", "λ, primo e ultimo bordo", "λ, erste und letzte Flanke"),
    "MTS": Text("λ, none, start or end, edge", "λ, none, start o end, bordo", "λ, none, start oder end, Flanke"),
    "SCC": Text("sine, constant, cosine, straight, λ", "seno, costante, coseno, retta, λ",
                "Sinus, Konstante, Kosinus, Gerade, λ"),
    "HAC": Text("λ, start or end", "λ, start o end", "λ, start oder end"),
    "SGS": Text("λ, share of the sines", "λ, quota dei seni", "λ, Anteil der Sinus"),
    "OWN": Text(
        "a row a piece (duration, c0, c1, c2, c3, P, ω, φ)",
        "una riga per tratto (durata, c0, c1, c2, c3, P, ω, φ)",
        "eine Zeile je Abschnitt (Dauer, c0, c1, c2, c3, P, ω, φ)",
    ),
}  # fmt: skip
"""What a law takes, of those that take anything."""
PARAMETERS = {one.code: len(one.page.parameters) for one in FAMILIES if one.code in CODES and one.code != "OWN"}
"""Codes of the laws with the number of parameters each takes; OWN, beside them, takes rows of OWN_WIDTH."""
if wrong := [code for code in CODES if (code in TAKES) != bool(PARAMETERS.get(code, OWN_WIDTH))]:
    raise IncompleteError(f"TAKES should have words for the parameters of {', '.join(wrong)}, or should not")


def spelled(last: str) -> str:
    """Return the codes of the laws, the last after a language's word for or."""
    return f"{', '.join(CODES[:-1])} {last} {CODES[-1]}"


def taken(language: str) -> str:
    """Return what each law takes, in a language."""
    alike: dict[str, list[str]] = {}
    for code, words in TAKES.items():
        alike.setdefault(getattr(words, language), []).append(code)
    return "; ".join(f"{', '.join(codes)}: {words}" for words, codes in alike.items())
