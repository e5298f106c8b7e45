"""What the commands print: tables for people, JSON for machines."""

from __future__ import annotations

import json
import math
from typing import Any

from rich.console import Console
from rich.table import Table

from engine.laws import CATALOGUE
from workbook.verify import Report

MOST = 40  # findings that the terminal shows; --json has them all


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it."""
    return value if value is None or isinstance(value, bool | int | str) or math.isfinite(value) else str(value)


def report_json(report: Report) -> str:
    """Return a report as JSON."""
    return json.dumps(
        {
            "file": str(report.path),
            "template": report.template,
            "agrees": report.agrees,
            "compared": report.compared,
            "witness": report.witness,
            "deviations": report.deviations,
            "findings": [
                {
                    "sheet": f.sheet, "cell": f.cell, "kind": f.kind, "computed": plain(f.computed),
                    "expected": plain(f.expected), "what": f.what,
                }
                for f in report.findings
            ],
            "unmatched": report.unmatched,
            "notes": report.notes,
        },
        ensure_ascii=False, indent=1,
    )  # fmt: skip


def show_report(report: Report, console: Console) -> None:
    """Print a report: what was compared on each sheet, then each finding, worst first."""
    sheets = Table(
        "Sheet",
        "Formula cells",
        "Largest deviation",
        "Findings",
        title=str(report.path),
        title_justify="left",
    )
    for sheet, compared in report.cells.items():
        deviation = report.deviations.get(sheet, 0.0)
        faults = sum(f.sheet == sheet for f in report.findings)
        sheets.add_row(sheet, f"{compared:,}", f"{deviation:.1e}", str(faults) if faults else "-")
    console.print(sheets)
    if report.findings:
        found = Table(
            "Cell",
            "What",
            "Kind",
            "Computes",
            "Expected",
            title="Findings, worst first",
            title_justify="left",
        )
        for f in report.findings[:MOST]:
            found.add_row(f"{f.sheet}!{f.cell}", f.what, f.kind, figure(f.computed), figure(f.expected))
        console.print(found)
        if len(report.findings) > MOST:
            console.print(f"… and {len(report.findings) - MOST} more; --json lists them all")
    for note in report.notes:
        console.print(f"Note: {note}")
    if report.unmatched:
        shown = ", ".join(report.unmatched[:8]) + (" …" if len(report.unmatched) > 8 else "")
        console.print(
            f"Not compared, as nothing generated stands there: {len(report.unmatched)} formula cells ({shown})"
        )
    verdict = "every one computes what the engine computes" if report.agrees else f"{len(report.findings)} findings"
    console.print(f"{report.compared:,} formula cells compared by {report.witness}: {verdict}.")


def figure(value: Any) -> str:
    """Return a value for a table."""
    return f"{value:.10g}" if isinstance(value, float) else "empty" if value is None else str(value)


FIGURES = {"C_v": "cv", "C_a+": "ca_max", "C_a−": "ca_min", "C_a,rms": "ca_rms", "C_j": "cj", "max(v·a)": "va_max"}


def catalogue() -> list[dict[str, Any]]:
    """Return every law of the catalogue with its coefficients, for its parameters as delivered."""
    return [
        {"code": e.code, "name": e.name, "aliases": list(e.aliases), "source": e.source}
        | {figure: plain(getattr(e.example().coefficients, field)) for figure, field in FIGURES.items()}
        for e in CATALOGUE
    ]


def show_catalogue(console: Console) -> None:
    """Print the catalogue of laws."""
    table = Table()
    for heading in ("Code", "Law", *FIGURES):
        table.add_column(heading, no_wrap=heading != "Law", justify="left" if heading in ("Code", "Law") else "right")
    for row in catalogue():
        figures = ("∞" if row[f] == "inf" else f"{row[f]:.5g}" for f in FIGURES)
        table.add_row(row["code"], row["name"], *figures)
    console.print(table)
    console.print("Unit rise and time, parameters as delivered. --json adds aliases and sources.")
