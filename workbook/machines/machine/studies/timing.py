"""The room for edges in a machine's timing, and the margins of orders, times of phases and gaps meanwhile."""

import math
from collections.abc import Iterable, Iterator

import numpy as np

from engine.laws.base import Array
from workbook.book.checks import ZERO
from workbook.book.sentence import figure
from workbook.entries.phase import TURN, AxisPhase
from workbook.errors import InputError
from workbook.fields.paths import Place
from workbook.fields.texts import place_of
from workbook.fields.types import ANGLE_TOLERANCE
from workbook.fields.units import DEGREE, shown, si
from workbook.improving import Room
from workbook.law_sheets.library import laws
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.entries_beside import EdgeOfPhase, Lasting
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.view import moving_axes

EDGE = 10.0  # degrees of a turn by which an edge may move where nothing is said of it
STEP = 0.01  # degrees of a turn, by multiples of which edges move
SHORTEST = 1.0  # degrees of a turn that a phase lasts at least, as far as edges move
HALF = 0.5  # of the way to the next edge of an axis, so that none passes another
GAPS = 181  # places of the cycle at which gaps are looked at
# by the place of edges, the first and the last to which they may move
Bounds = dict[float, tuple[float, float]]


def rooms(base: AnyMachine, machine: AnyMachine, name: str) -> list[Room]:
    """Return the edges that may move, from where a base has them; the axis of that name is the one that limits.

    Edges of an axis at the same place move together, and both edges of a phase that keeps its time.
    """
    if not base.timing.edges:
        i = axis_of(base, name, "edges")
        return list(rooms_of(base, i, free(base, machine, i)))
    by_axis: dict[int, Bounds] = {}
    for k, edge in enumerate(base.timing.edges):
        j, phase = phase_of(base, edge, f"edges[{k + 1}]")
        place, bounds = getattr(phase, edge.edge), by_axis.setdefault(j, {})
        low, high = bounds.get(place, (edge.earliest, edge.latest))
        bounds[place] = max(low, edge.earliest), min(high, edge.latest)
        if not bounds[place][0] <= place <= bounds[place][1]:
            problem = f"{edge.edge} of {edge.axis} phase {edge.phase} is at {figure(place)}{base.over.after}"
            raise InputError([f"timing.edges[{k + 1}]: the {problem}; expected bounds with this place between them"])
    return [room for j, bounds in by_axis.items() for room in rooms_of(base, j, bounds)]


def phase_of(machine: AnyMachine, entered: EdgeOfPhase | Lasting, where: str) -> tuple[int, AxisPhase]:
    """Return the number of the axis, from 0, and the phase that entries name; raise InputError where there is none."""
    i = axis_of(machine, entered.axis, where)
    phases = machine.axes[i].phases
    if entered.phase > len(phases):
        raise InputError([f"timing.{where}.phase: {entered.axis} has {len(phases)} phases; expected at most that"])
    return i, phases[entered.phase - 1]


def axis_of(machine: AnyMachine, name: str, where: str) -> int:
    """Return the number of the axis of a name, from 0; raise InputError where there is none."""
    names = [axis.name for axis in machine.axes]
    if (i := place_of(name, names)) < 0:
        raise InputError([f"timing.{where}: no axis is named {name!r}; expected one of {', '.join(names)}"])
    return i


def edges_of(axis: Axis, i: int) -> dict[float, dict[Place, str]]:
    """Return the edges of an axis' phases in words, by their places in the cycle and in a description."""
    edges: dict[float, dict[Place, str]] = {}
    for k, phase in enumerate(axis.phases):
        for end in ("start", "stop"):
            path = ("axes", str(i), "phases", str(k), end)
            edges.setdefault(getattr(phase, end), {})[path] = f"{end} of phase {k + 1}"
    return edges


def rooms_of(base: AnyMachine, i: int, bounds: Bounds) -> Iterator[Room]:
    """Yield the edges of an axis that move together, within the bounds of those places that have some."""
    edges = edges_of(base.axes[i], i)
    for group in places_together(base, i, edges):
        limits = [(bounds[at][0] - at, bounds[at][1] - at) for at in group if at in bounds]
        low = max((low for low, _ in limits), default=0.0)
        high = min((high for _, high in limits), default=0.0)
        if high > low:
            words = {" and ".join(edges[place].values()): place for place in group}
            moved = {path: place for place in group for path in edges[place]}
            yield Room(base.axes[i].name, words, moved, low, high, base.over.shown(STEP), base.over.after)


def places_together(base: AnyMachine, i: int, places: Iterable[float]) -> list[list[float]]:
    """Return the places of an axis' edges by groups that move together: those of a phase that keeps its time."""
    groups = [{place} for place in places]
    for k, lasting in enumerate(base.timing.lasting):
        j, phase = phase_of(base, lasting, f"lasting[{k + 1}]")
        if j == i and lasting.least is None:
            joined = {place for group in groups if group & {phase.start, phase.stop} for place in group}
            groups = [*(group for group in groups if not group & joined), joined]
    return [sorted(group) for group in groups]


def free(base: AnyMachine, machine: AnyMachine, i: int) -> Bounds:
    """Return how far the inner edges of an axis may move where nothing is said of them: in the order of all edges."""
    over = base.over
    step, near, cycle = over.shown(EDGE), over.shown(ANGLE_TOLERANCE), over.shown(TURN)
    others = [at % cycle for k, axis in enumerate(machine.axes) if k != i for at in places_of(axis)]
    edges, bounds = edges_of(base.axes[i], i), Bounds()
    for place in (place for place in edges if near < place < cycle - near):
        ways = []
        for way in (-1.0, 1.0):
            apart = [way * (at - place) for at in (0.0, cycle, *edges) if way * (at - place) > near]
            passed = [(way * (other - place - base.axes[i].shift)) % cycle for other in others]
            passed = [0.0 if distance > cycle - near else distance for distance in passed]
            ways.append(place + way * min([HALF * min(apart, default=cycle), step, *passed]))
        bounds[place] = ways[0], ways[1]
    return bounds


def places_of(axis: Axis) -> Iterator[float]:
    """Yield the places of the edges of an axis' phases and process forces, in the unit of the cycle."""
    for phase in axis.phases:
        yield from (phase.start + axis.shift, phase.stop + axis.shift)
    for window in axis.load.windows:
        yield from (window.start, window.stop)


def order_margins(machine: AnyMachine) -> list[tuple[float, str]]:
    """Return by how much each order holds, as a share of the other axis' travel, and its sentence."""
    axes, margins = moving_axes(machine, laws(machine.laws)), []
    for k, order in enumerate(machine.timing.orders):
        where = f"orders[{k + 1}]"
        i, phase = phase_of(machine, order, where)
        other = axes[axis_of(machine, order.other, f"{where}.other")]
        angle = (machine.over.degrees(getattr(phase, order.edge) + machine.axes[i].shift)) % TURN
        at = float(shown(other.at(si(np.array([angle]), DEGREE)).y[0], other.unit))
        bounds = [(1.0, order.above, "above"), (-1.0, order.below, "below")]
        each = [(way * (at - bound), f"{word} {figure(bound)}") for way, bound, word in bounds if bound is not None]
        if not each:
            raise InputError([f"timing.{where}: expected a position that the other axis is above or below"])
        margin, words = min(each)
        size = float(shown(np.ptp(other.motion.reach), other.unit)) or 1.0
        edge = f"{order.edge} of {order.axis} phase {order.phase}"
        sentence = f"timing.{where}: {order.other} is at {at:.6g} {other.given.unit} at the {edge}; expected {words}"
        margins.append((margin / size, sentence))
    return margins


def process_rate(machine: AnyMachine) -> float:
    """Return the highest rate (1/s) at which all phases last as long as they must; infinite where none must."""
    rates = [math.inf]
    for k, lasting in enumerate(machine.timing.lasting):
        _, phase = phase_of(machine, lasting, f"lasting[{k + 1}]")
        if lasting.least is not None:
            rates.append(machine.over.degrees(phase.stop - phase.start) / TURN / lasting.least)
    return min(rates)


def margins(machine: AnyMachine) -> Array:
    """Return shares by which all holds that must while edges move: below 0 it does not.

    Orders; phases that last a degree, each behind the last; gaps at places of the cycle, and the least of each.
    """
    over, shares = machine.over, [margin for margin, _ in order_margins(machine)]
    for axis in machine.axes:
        shares += [(over.degrees(phase.stop - phase.start) - SHORTEST) / TURN for phase in axis.phases]
        edges = (place for phase in axis.phases for place in (phase.start, phase.stop))
        shares += (np.diff([0.0, *edges, over.shown(TURN)])[::2] / over.shown(TURN)).tolist()
    rows = axes_of(machine) if machine.clearances else []
    for number, clearance in enumerate(machine.clearances, 1):
        gap = ClearanceView(clearance, number, rows)
        at_places = gap.gaps(np.linspace(0.0, TURN, GAPS)).tolist()
        shares += [(value - clearance.least) / gap.size for value in (gap.exact, gap.least, *at_places)]
    return np.array(shares) + ZERO
