"""The cutting machine of S1: what an engineer enters."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import model_validator

from workbook.machine import Drive, EntryError, Machine, Timing
from workbook.machines.selection.model import Selection, SelectionSizes, require_room


class CuttingMachine(Machine):
    """The cutting machine of S1: three axes over one master shaft, and the drive of one of them."""

    template: Literal["cutting-machine"] = "cutting-machine"
    timing: Timing
    drive: Drive
    selection: Selection = Selection()
    sizes: SelectionSizes = SelectionSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        names = [axis.name for axis in self.timing.axes]
        if self.drive.axis not in names:
            raise EntryError("drive.axis", f"no axis is named {self.drive.axis!r}; expected one of {', '.join(names)}")
        for path, filled, room in (
            *((f"timing.axes.{i}.phases", len(a.phases), self.sizes.phases) for i, a in enumerate(self.timing.axes)),
            ("drive.rotors", len(self.drive.rotors), self.sizes.rotors),
            ("laws.OWN.pieces", len(self.laws.OWN.pieces), self.sizes.pieces),
        ):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{path.split('.')[-1]}")
        require_room(self.selection, self.sizes)
        return self
