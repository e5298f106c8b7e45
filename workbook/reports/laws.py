"""What the command prints of the laws: figures, what each costs, how smooth it is, and its names elsewhere."""

from collections.abc import Iterable, Sequence
from typing import Any

from rich.console import Console
from rich.table import Table

from engine.laws import CATALOGUE
from engine.laws.continuity import WORDS, continuity
from workbook.reports.console import plain

FIGURES = {"C_v": "cv", "C_a+": "ca_max", "C_a−": "ca_min", "C_a,rms": "ca_rms", "C_j": "cj", "max(v·a)": "va_max"}
COSTS = {"min(v·a)": "va_min", "C_a,rms²/12": "loss"}
SMOOTH = ("smooth_at_ends", "smooth_inside")
VENDORS = {"siemens": "Siemens LCamHdl", "twincat": "TwinCAT", "codesys": "CODESYS", "sew": "SEW"}
EXPLAINED = (
    "C_a,rms²/12: heat of a pure inertia against the cubic's, the least between two rests; smooth: what is continuous."
)


def catalogue() -> list[dict[str, Any]]:
    """Return every law's names, source, coefficients, for its parameters as delivered, continuity, names elsewhere."""
    rows: list[dict[str, Any]] = []
    for law in (one() for one in CATALOGUE):
        figures = {name: plain(getattr(law.coefficients, field)) for name, field in (FIGURES | COSTS).items()}
        smooth = dict(zip(SMOOTH, (WORDS[order] for order in continuity(law)), strict=True))
        told = {"code": law.code, "name": law.name, "aliases": list(law.aliases), "source": law.source}
        rows.append(told | figures | smooth | {"names": law.vendors._asdict()})
    return rows


def show_catalogue(console: Console) -> None:
    """Print the catalogue of laws: figures, what each costs, then the names that they have elsewhere."""
    rows = catalogue()
    show(console, rows, FIGURES, ())
    console.print("Unit rise and time, parameters as delivered. --json adds aliases and sources.")
    show(console, rows, COSTS, SMOOTH)
    console.print(EXPLAINED)
    named = Table("Code", title="Names elsewhere, as far as they are sure", title_justify="left")
    for vendor in VENDORS.values():
        named.add_column(vendor, overflow="fold")
    for row in rows:
        if any(row["names"].values()):
            named.add_row(row["code"], *(row["names"][vendor] for vendor in VENDORS))
    console.print(named)


def show(console: Console, rows: Sequence[dict[str, Any]], numbers: Iterable[str], words: Iterable[str]) -> None:
    """Print a table of the laws with some of their figures, and what is said of them in words."""
    table = Table()
    for heading in ("Code", "Law", *numbers, *(word.replace("_", " ") for word in words)):
        table.add_column(heading, no_wrap=heading != "Law", justify="right" if heading in numbers else "left")
    for row in rows:
        figures = ("∞" if row[f] == "inf" else f"{row[f]:.5g}" for f in numbers)
        table.add_row(row["code"], row["name"], *figures, *(row[word] for word in words))
    console.print(table)
