"""Write validation.md: the printed figures of the source documents beside ours.

.venv/bin/python -m docs.validation
"""

from __future__ import annotations

from pathlib import Path

from tests.printed.figures import DOCUMENTS, Figure

PAGE = Path(__file__).with_suffix(".md")
HEAD = """\
# Validation against print

Made by `python -m docs.validation` from [tests/printed](../tests/printed/figures.py), which CI runs. Each figure that
a source document prints stands beside the engine's, with the deviation from the printed digits. A figure agrees where
ours rounds to those digits; where it does not, the reason is given. S5 prints equations and no figures: its tests
write the equations out. Every formula cell of a workbook is then compared with the engine
([verification.md](verification.md)).
"""
COLUMNS = "| section | quantity | unit | printed | ours | deviation | |\n|---|---|---|---|---|---|---|"


def row(figure: Figure) -> str:
    """Return the row of a figure."""
    printed = float(figure.printed)
    per_cent = 100 * (figure.ours / printed - 1)
    deviation = f"{per_cent:+.3g} %" if abs(per_cent) > 1e-6 else "0"
    verdict = "agrees" if figure.agrees else figure.reason
    cells = [figure.section, figure.quantity, figure.unit, figure.printed, f"{figure.ours:.7g}", deviation, verdict]
    return f"| {' | '.join(cells)} |"


def page() -> str:
    """Return the whole page."""
    parts = [HEAD]
    for name, (figures, title) in DOCUMENTS.items():
        parts.append("\n".join([f"## {name} · {title}\n", COLUMNS, *map(row, figures())]) + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
