"""The switches of a book as a controller's file, certified by what an independent reader finds in it."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from engine.timing import Differing
from workbook.axes import CamSwitch
from workbook.controllers.files import text_of
from workbook.controllers.registry import targets
from workbook.controllers.target import MOST_OFF, HandedTracks, Tappets, Target, Track, certified, tracks
from workbook.errors import AGREES, DISAGREES, ReadError, TargetError
from workbook.reports.cams import SWITCHED
from workbook.reports.terminal import ERR, OUT, say, say_json, show_table, shown
from workbook.visible import visible

NAME = "Switches"
LONGEST = 24  # characters of a switch's name


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
        return [[one.name, str(differs.edges), f"{differs.largest:.3g} {one.x_unit}",
                 f"{differs.x:.6g} {one.x_unit}" if differs.largest else "", f"{differs.duration:.3g} {one.x_unit}"]
                for one, differs in zip(self.switches, self.found, strict=True)]  # fmt: skip


def takes(target: Target) -> Tappets:
    """Return how a target takes switches; raise TargetError where it does not."""
    if target.tappets is None:
        taking = [one.name for one in targets() if one.tappets]
        raise TargetError(f"{target.name} takes no switches; expected one of {', '.join(taking)}")
    return target.tappets


def require_some(switches: Sequence[CamSwitch]) -> None:
    """Raise TargetError for a machine without switches."""
    if not switches:
        raise TargetError("the machine has no switches; expected some, or --axis NAME")


def switched(
    machine: str, switches: Sequence[CamSwitch], target: Target, signs: tuple[str, str], mark: Sequence[str], path: Path
) -> Switched:  # fmt: skip
    """Return the file of a machine's switches, read back."""
    tappets = takes(target)
    header = (f"Switches of {machine}: {tappets.title}", "angles in °; on from one to the other", *mark,
              *(f"untested: {claim.what} ({claim.source})" for claim in tappets.untested))  # fmt: skip
    cycle, held = switches[0].switch.cycle, tracks(switches, tappets)
    text = tappets.write(HandedTracks(held, NAME, tuple(map(visible, header)), cycle, *signs))
    return Switched(switches, text, certified(switches, tappets.read(text)), tappets, path)


def lanes_of(file: Path, target: Target) -> list[Track]:
    """Return the switches of a controller's file; raise ReadError, in one line, where it is none."""
    tappets = takes(target)
    try:
        return tappets.read(text_of(file, target))
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
    require_some(lanes)
    found = Switched(lanes, "", certified(lanes, lanes_of(file, target)), takes(target), file)
    if as_json:
        say_json(told(found, target))
    else:
        show(found, target)
    for line in found.beyond:
        say(ERR, f"{line}: {book.name} has it elsewhere", "red")
    return DISAGREES if found.beyond else AGREES


def show(found: Switched, target: Target) -> None:
    """Print how each switch differs when its file is read back."""
    show_table(OUT, SWITCHED, found.rows, (1, 2, 3, 4), shown(f"Switches to {target.name}: {found.tappets.title}"))


def told(found: Switched, target: Target) -> Mapping[str, Any]:
    """Return the same as data."""
    switches = [{"switch": one.name, "unit": one.x_unit, "edges": differs.edges,
                 "largest": differs.largest if math.isfinite(differs.largest) else None, "at": differs.x,
                 "apart": differs.duration}
                for one, differs in zip(found.switches, found.found, strict=True)]  # fmt: skip
    return {"switches": switches, "target": target.name, "file": str(found.path),
            "untested": [claim.what for claim in found.tappets.untested]}  # fmt: skip
