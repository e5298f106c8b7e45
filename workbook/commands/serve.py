"""Serve a folder of machines to the browser of this computer."""

from __future__ import annotations

import asyncio
from pathlib import Path

from workbook.reports.terminal import OUT, say
from workbook.serve import app


def serve(folder: Path, port: int, browse: bool) -> None:
    """Serve until Ctrl+C."""
    try:
        asyncio.run(app.serve(folder, port, browse, lambda address: say(OUT, f"Open {address} (Ctrl+C ends)")))
    except KeyboardInterrupt:
        say(OUT, "Ended")
