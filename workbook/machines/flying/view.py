"""The engine's view of flying machining."""

import numpy as np

from engine.drive import Load
from engine.flying.cut import Beyond, Cut
from engine.flying.pieces import sizes as sizes_of
from engine.flying.tool import Tool, flying_saw, rotary_drum
from engine.laws import Dwell, Law
from engine.laws.points import fastest
from engine.motion import Phase
from engine.selection.task import Task
from workbook.entries.units import DEGREE, KG_CM2, MM, MM_PER_TURN, PER_MINUTE, shown, si
from workbook.machines.flying.entries import DRUM, CutterEntry, FlyingCutter

CASES = {"faster": "faster", "constant speed": "in step", "slower": "slower"}
"""the engine's words for the three cases, and the sheet's"""
REST = 1e-9  # dimensionless velocity at which a law is at rest


def tool_of(given: CutterEntry) -> Tool:
    """Return the engine's tool."""
    if given.kind == DRUM:
        drum = given.drum
        return rotary_drum(int(drum.tools), si(drum.radius, MM), si(drum.tool_angle, DEGREE))
    return flying_saw(si(given.saw.tool_length, MM), si(given.saw.lead, MM_PER_TURN))


class Flying:
    """The engine's view: tool and load, the cut entered, its cycle, and cuts of other lengths."""

    def __init__(self, machine: FlyingCutter, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = machine.cutter, machine.sizes, library
        self.tool, self.law = tool_of(self.given), library[self.given.law]
        self.number = machine.laws.number(self.given.law)
        self.is_drum = self.given.kind == DRUM
        self.line = si(self.given.line_speed, PER_MINUTE)
        load, lengths = self.given.load, self.given.lengths
        self.load = Load(si(load.inertia, KG_CM2) + load.mass * self.tool.radius**2, load.torque)  # J_L = J + m R_t²
        self.peak = fastest(self.law)
        self.cut = self.of(self.given.product_length)
        self.scales = sizes_of(self.cut, self.load.inertia, self.load.torque)
        self.room = self.sizes.motion_pieces or 0  # rows of the table of the motion's pieces
        self.times = np.linspace(0.0, self.cut.cycle_time, self.sizes.cycle + 1)  # s
        self.lengths = np.linspace(lengths.shortest, lengths.longest, self.sizes.lengths + 1)  # compared, in mm
        self.limit = shown(self.cut.limit_length, MM) if self.is_drum else 0.0  # L_p,lim; a saw always reverses

    def of(self, length: float, beyond: Beyond | None = None) -> Cut:
        """Return the cut of a product length in mm, whose drum waits where the cells find the law fastest."""
        return Cut(self.tool, si(length, MM), self.line, self.law, beyond or self.given.beyond, self.peak)

    def task(self, cut: Cut) -> Task:
        """Return what a cut asks of the drive at the tool's shaft, exactly, from the law's coefficients."""
        phases = [Phase(self.law, cut.superimposed, cut.moving_time)]
        rest = cut.cycle_time - cut.moving_time
        if rest > 0.0:
            phases.append(Phase(Dwell(), 0.0, rest))
        return Task.of_load(self.load, phases, self.tool.radius)

    @property
    def case(self) -> int:
        """Which row of the cases by product length holds: shorter than L_0, as long, longer, too long to keep on."""
        if self.cut.case != "slower":
            return 1 if self.cut.case == "faster" else 2
        return 4 if self.cut.stops else 3


def does(cut: Cut) -> str:
    """Return in a word what the tool does while it re-positions."""
    return "waits" if cut.waits else "reverses" if cut.reverses else "keeps moving"
