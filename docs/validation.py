"""Write validation.md: the printed figures of the source documents beside ours.

.venv/bin/python -m docs.validation
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from tests.printed.figures import DOCUMENTS, Figure
from tests.workbook.cells import computed
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

PAGE = Path(__file__).with_suffix(".md")
HEAD = """\
# Validation against print

Made by `python -m docs.validation` from [tests/printed](../tests/printed/figures.py), which CI runs. Each figure that
a source document prints stands beside the engine's and beside that of the cell which has it, as pycel works out the
templates' workbooks, with the engine's deviation from the printed digits. A figure agrees where the engine's rounds to
those digits; where it does not, the reason is given. Where no workbook has a quantity by itself, there is no cell. S5
prints equations and no figures: its tests write the equations out. Every formula cell of a workbook is compared with
the engine ([verification.md](verification.md)).
"""
DRAWN = """\
## Drawn machines

Machines that nobody printed are drawn: all mechanisms, laws that turn back, hand-over at speed, dead centres, slow
running, falling curves, brakes. Each drive is computed at the points of its sheet, by the exact engine and, apart from
both, by fine quadrature of the equation of motion. This is the worst deviation of each result from the exact
engine's, as `python -m tests.workbook.machines.test_drawn_drives COUNT WORD` prints it, of other machines for each
word; CI draws 40 machines with every change. RMS and mean torques are shares of the peak, powers and energies of the
larger of what drives and what comes back.

"""
DRAWN_TABLE = FOLDER.parent / "tests/printed/drawn_machines.md"
COLUMNS = "| section | quantity | unit | printed | engine | cell | deviation | |\n|---|---|---|---|---|---|---|---|"


@cache
def computed_book(name: str) -> Callable[..., Any]:
    """Return what gives the value of each cell of a template's workbook, by pycel."""
    machine = read_machine(FOLDER / f"{name}.toml")
    return computed(TEMPLATES[machine.template], machine)


def cell_value(figure: Figure) -> float:
    """Return the value of a figure's cell, in the figure's unit."""
    book, _, cell = figure.cell.partition(" ")
    block, column, row = (*cell.split("."), "", "")[:3]
    value = computed_book(book)(block, column)[int(row) - 1] if row else computed_book(book)(block)
    return float(value) * figure.factor


def row(figure: Figure) -> str:
    """Return the row of a figure."""
    printed = float(figure.printed)
    per_cent = 100 * (figure.ours / printed - 1)
    deviation = f"{per_cent:+.3g} %" if abs(per_cent) > 1e-6 else "0"
    verdict = "agrees" if figure.agrees else figure.reason
    cell = f"{cell_value(figure):.7g}" if figure.cell else "–"
    engine = f"{figure.ours:.7g}"
    cells = [figure.section, figure.quantity, figure.unit, figure.printed, engine, cell, deviation, verdict]
    return f"| {' | '.join(cells)} |"


def page() -> str:
    """Return the whole page."""
    parts = [HEAD]
    for name, (figures, title) in DOCUMENTS.items():
        parts.append("\n".join([f"## {name} · {title}\n", COLUMNS, *map(row, figures())]) + "\n")
    return "\n".join([*parts, DRAWN + DRAWN_TABLE.read_text(encoding="utf-8")])


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
