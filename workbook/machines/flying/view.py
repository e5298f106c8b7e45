"""The engine's view of flying machining, and what only the engine can say of its entries."""

from math import hypot

import numpy as np

from engine.drive import Load
from engine.flying.cut import LONGER, SAME_LENGTH, Beyond, Cut, Tool, flying_saw, rotary_drum
from engine.laws import Dwell, Law
from engine.laws.inverse import is_monotone, velocity_extremes
from engine.laws.points import fastest
from engine.motion import Phase
from engine.selection.task import Task
from workbook.book.sentence import figure
from workbook.entries.types import END_TOLERANCE, DesignError
from workbook.entries.units import DEGREE, KG_CM2, MM, MM_PER_TURN, PER_MINUTE, RPM, shown, si
from workbook.laws.entries import Laws
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.machines.flying.entries import DRUM, CutterEntry, FlyingCutter

REST = 1e-9  # dimensionless velocity at which a law is at rest
LEAST_CV = 1.001  # below, no product is too long to keep moving


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
    def scales(self) -> dict[str, float]:
        """How large figures are, by unit: what the line speed over a length makes of it, β = J_L (v²/(L R_t))²."""
        length, radius = max(self.tool.design_length, self.cut.product_length), self.tool.radius
        turning = self.line**2 / length / radius
        return {
            "s": self.cut.cycle_time, "m": length, "mm": shown(length, MM), "m/s": self.line,
            "m/s²": self.line**2 / length, "m/s³": self.cut.size(3), "°": shown(length / radius, DEGREE),
            "rpm": shown(self.line / radius, RPM), "rad/s": self.line / radius, "rad/s²": turning,
            "Nm": hypot(self.load.inertia * turning, self.load.torque), "W/s": self.load.inertia * turning**2,
        }  # fmt: skip

    @property
    def case(self) -> int:
        """Which row of the cases by product length holds: shorter than L_0, as long, longer, too long to keep on."""
        if self.cut.displacement >= 0.0:
            return 1 if self.cut.displacement else 2
        return 4 if self.cut.speed_range[0] <= SAME_LENGTH * self.line else 3


def does(cut: Cut) -> str:
    """Return in a word what the tool does while it re-positions."""
    return "waits" if cut.waits else "reverses" if cut.reverses else "keeps moving"


def check(machine: FlyingCutter) -> None:
    """Raise DesignError for a law that does not do, and for products that leave no time to re-position."""
    cutter = machine.cutter
    require_law(cutter.law, machine.laws)
    least = shown(LONGER * tool_of(cutter).tool_length, MM)
    for entry, length in (("product_length", cutter.product_length), ("lengths.shortest", cutter.lengths.shortest)):
        if length < least:
            said = f"a product of {figure(length)} mm; expected at least {figure(least)} mm"
            raise DesignError(f"cutter.{entry}", said, "length", least + least)


def require_law(code: str, given: Laws) -> None:
    """Raise DesignError unless the law goes from rest at 0 to rest at 1, speeds up once and slows down once."""
    law = laws(given)[code]
    speeds = law.v(velocity_extremes(law))
    top, falls = int(np.argmax(speeds)), np.diff(speeds)
    rests = max(abs(law.start.v), abs(law.end.v)) <= REST and abs(law.end.s - 1) <= END_TOLERANCE
    once = min(falls[:top].min(initial=0.0), -falls[top:].max(initial=0.0)) >= -REST
    if not (is_monotone(law) and rests and once and law.coefficients.cv >= LEAST_CV):
        raise DesignError("cutter.law", f"the law {code} does not: see its sheet, or Laws", "law", RISING[0])
