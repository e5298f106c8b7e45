"""The switches of a machine as a controller's file, and how each differs when that is read back."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from engine.timing import SwitchDifference
from workbook.controllers.registry import targets
from workbook.controllers.target import MOST_OFF, SwitchExport, Tappets, Target, differences, tracks
from workbook.errors import TargetError, visible
from workbook.reports import cams
from workbook.reports.terminal import OUT, show_table, shown
from workbook.template_outputs import CamSwitch


class SwitchFile(NamedTuple):
    """The switches of a machine with their file's text, and how each differs when that is read back."""

    pairs: Sequence[tuple[CamSwitch, SwitchDifference]]
    text: str
    tappets: Tappets
    path: Path

    @property
    def beyond(self) -> list[str]:
        """Lines on the switches with an edge farther off than numbers of 32 bits hold."""
        far = ((switch, off.largest) for switch, off in self.pairs if off.largest > MOST_OFF)
        return [f"{switch.name}: an edge is off by {off:.3g} {switch.x_unit}" for switch, off in far]

    @property
    def rows(self) -> list[list[str]]:
        """A row of texts for each switch."""
        rows = []
        for lane, off in self.pairs:
            at = f"{off.x:.6g} {lane.x_unit}" if off.largest else ""
            largest, duration = (f"{size:.3g} {lane.x_unit}" for size in (off.largest, off.duration))
            rows.append([lane.name, str(off.edges), largest, at, duration])
        return rows

    def show(self, target: Target) -> None:
        """Print how each switch differs when its file is read back."""
        title = shown(f"Switches to {target.name}: {self.tappets.title}")
        show_table(OUT, cams.SWITCHED, self.rows, (1, 2, 3, 4), title)

    def as_data(self, target: Target) -> dict[str, Any]:
        """Return the same as data."""
        switches = []
        for switch, off in self.pairs:
            data = {"switch": switch.name, "unit": switch.x_unit, "edges": off.edges}
            largest = off.largest if math.isfinite(off.largest) else None
            switches.append(data | {"largest": largest, "at": off.x, "apart": off.duration})
        untested = [claim.what for claim in self.tappets.untested]
        file = {"switches": switches, "target": target.name, "file": str(self.path)}
        return file | {"untested": untested}


def switch_format(target: Target, switches: Sequence[CamSwitch] | None = None) -> Tappets:
    """Return how a target takes switches; raise TargetError where it does not, or where the machine has none."""
    if switches is not None and not switches:
        raise TargetError("the machine has no switches; expected some, or --axis NAME")
    if target.tappets is None:
        taking = [target.name for target in targets() if target.tappets]
        raise TargetError(f"{target.name} takes no switches; expected one of {', '.join(taking)}")
    return target.tappets


def export_switches(
    machine: str, switches: Sequence[CamSwitch], target: Target, signs: tuple[str, str], mark: Sequence[str], path: Path
) -> SwitchFile:
    """Return the file of a machine's switches, read back."""
    tappets = switch_format(target)
    header = (f"Switches of {machine}: {tappets.title}", "angles in °; on from one to the other", *mark,
              *(f"untested: {claim.what} ({claim.source})" for claim in tappets.untested))  # fmt: skip
    cycle, held = switches[0].switch.cycle, tracks(switches, tappets)
    text = tappets.write(SwitchExport(held, "Switches", tuple(map(visible, header)), cycle, *signs))
    compared = differences(switches, tappets.read(text))
    return SwitchFile(list(zip(switches, compared, strict=True)), text, tappets, path)
