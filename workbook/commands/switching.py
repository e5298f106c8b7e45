"""The switches of a book as a controller's file, certified by what an independent reader finds in it."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from engine.cams.switched import Differing
from workbook.axes import CamSwitch
from workbook.controllers.files import text_of
from workbook.controllers.names import TARGETS
from workbook.controllers.registry import target as target_named
from workbook.controllers.tappets import MOST_OFF, HandedTracks, Tappets, Track, certified, tracks
from workbook.controllers.target import Target
from workbook.errors import ReadError, TargetError
from workbook.exits import AGREES, DISAGREES
from workbook.reports.cams import SWITCHED
from workbook.reports.terminal import ERR, OUT, say, say_data
from workbook.visible import visible

NAME = "Switches"
LONGEST = 24
"""characters of a switch's name"""


@dataclass(frozen=True)
class Switched:
    """The switches of a machine with their file's text, and how each differs when that is read back."""

    switches: Sequence[CamSwitch]
    text: str
    found: Sequence[Differing]
    tappets: Tappets
    path: Path

    @property
    def beyond(self) -> list[str]:
        """In a line each, what is farther off than numbers of 32 bits hold."""
        pairs = zip(self.switches, self.found, strict=True)
        return [f"{one.name}: an edge is off by {differs.largest:.3g} {one.x_unit}"
                for one, differs in pairs if differs.largest > MOST_OFF]  # fmt: skip

    @property
    def rows(self) -> list[list[str]]:
        """A row of texts for each switch."""
        return [[visible(one.name), str(differs.edges), f"{differs.largest:.3g} {one.x_unit}",
                 f"{differs.x:.6g} {one.x_unit}" if differs.largest else "", f"{differs.duration:.3g} {one.x_unit}"]
                for one, differs in zip(self.switches, self.found, strict=True)]  # fmt: skip


def takes(target: Target, switches: Sequence[CamSwitch]) -> Tappets:
    """Return how a target takes switches; raise TargetError where it does not, or there are none."""
    if not switches:
        raise TargetError("the machine has no switches; expected some, or --axis NAME")
    if target.tappets is None:
        raise TargetError(f"{target.name} takes no switches; expected one of {', '.join(taking())}")
    return target.tappets


def taking() -> list[str]:
    """Return the names of the targets that take switches."""
    return [name for name in TARGETS if target_named(name).tappets]


def switched(
    machine: str, switches: Sequence[CamSwitch], target: Target, signs: tuple[str, str], mark: Sequence[str], path: Path
) -> Switched:  # fmt: skip
    """Return the file of a machine's switches, read back."""
    tappets = takes(target, switches)
    header = (f"Switches of {machine}: {tappets.title}", "angles in °; on from one to the other", *mark,
              *(f"untested: {claim.what} ({claim.source})" for claim in tappets.untested))  # fmt: skip
    handed = HandedTracks(
        tracks(switches, tappets), NAME, tuple(map(visible, header)), switches[0].switch.cycle, *signs
    )
    text = tappets.write(handed)
    return Switched(switches, text, certified(switches, tappets.read(text)), tappets, path)


def lanes_of(file: Path, target: Target) -> list[Track]:
    """Return the switches of a controller's file; raise ReadError, in one line, where it is none."""
    if target.tappets is None:
        raise TargetError(f"{target.name} takes no switches; expected one of {', '.join(taking())}")
    try:
        return target.tappets.read(text_of(file, target))
    except TargetError as error:
        raise ReadError(f"{file}: {error}") from None


def entries(found: Sequence[Track]) -> str:
    """Return switches as a machine's description tells them."""
    rows = []
    for one in found:
        times = ", ".join(f"[{begin:.9g}, {end:.9g}]" for begin, end in one.on)
        name = json.dumps(visible(one.name)[:LONGEST], ensure_ascii=False)
        rows.append(f"[[switches]]\nname = {name}\non = [{times}]\n")
    return "\n".join(rows)


def compared(book: Path, lanes: Sequence[CamSwitch], file: Path, target: Target, as_json: bool) -> int:
    """Compare the switches of a file with those of a book; return the exit code."""
    tappets = takes(target, lanes)
    told_tracks = lanes_of(file, target)
    found = Switched(lanes, "", certified(lanes, told_tracks), tappets, file)
    if as_json:
        say_data(f"{json.dumps(told(found, target), ensure_ascii=False, indent=1)}\n")
    else:
        show(OUT, found, target)
    for line in found.beyond:
        say(ERR, f"{line}: {book.name} has it elsewhere", "red")
    return DISAGREES if found.beyond else AGREES


def show(console: Console, found: Switched, target: Target) -> None:
    """Print how each switch differs when its file is read back."""
    grid = Grid(title=Text(f"Switches to {target.name}: {found.tappets.title}"), title_justify="left")
    for heading in SWITCHED:
        grid.add_column(Text(heading), justify="left" if heading == SWITCHED[0] else "right")
    for row in found.rows:
        grid.add_row(*map(Text, row))
    console.print(grid)


def told(found: Switched, target: Target) -> Mapping[str, Any]:
    """Return the same as data."""
    return {
        "switches": [
            {"switch": one.name, "unit": one.x_unit, "edges": differs.edges,
             "largest": differs.largest if math.isfinite(differs.largest) else None, "at": differs.x,
             "apart": differs.duration}
            for one, differs in zip(found.switches, found.found, strict=True)
        ],
        "target": target.name,
        "file": str(found.path),
        "untested": [claim.what for claim in found.tappets.untested],
    }  # fmt: skip
