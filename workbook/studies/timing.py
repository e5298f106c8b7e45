"""The best timing of a machine: edges moved within their rooms, so that its largest cost is as small as can be."""

from collections.abc import Callable, Sequence

import numpy as np

from engine.drive.search import least_use
from engine.laws.base import Array
from workbook.fields.paths import Place, get
from workbook.improving import Change, Room
from workbook.studies.design import GAIN, Design

Done = Callable[[int, int, str], None]  # takes how many changes of how many are tried, and words
SLOPE = 1e-4  # of a room: by so much edges move to find a slope
WORST = 10.0  # the cost over that of the begin where there is no such machine; its margins are -1
HALVINGS = 14  # of the way to a timing that does not hold
GRIDS = (100, 30, 10, 3, 1)  # steps by which single edges move at last


def best_timing(design: Design, starts: int, done: Done) -> Design | None:
    """Return the design with its edges at the best places, which breaks nothing; None where that gains nothing.

    The largest cost of its axes is made as small as it can be, from the present places and from others in the rooms, by
    SciPy's SLSQP; what breaks a check is taken back towards the best so far, and then edges move one by one.
    """
    rooms = design.improving.timing.rooms(design.base, design.machine, design.limiting)
    if not rooms:
        return None
    search, best = TimingSearch(design, rooms), design
    for n, start in enumerate(search.starts(starts), 1):
        done(n, starts + 1, "timings from other places")
        best = search.refined(search.settled(search.solved(start), best))
    is_better = best.cost < design.cost * (1.0 - GAIN) and best.is_no_worse(design, search.broken)
    return best if is_better else None


class TimingSearch:
    """The search of the best places of edges, by how far each is moved from where it was at first."""

    def __init__(self, design: Design, rooms: Sequence[Room]) -> None:
        self.begin, self.rooms, self.broken = design, rooms, design.breaks()
        self.low, self.high = (np.array([getattr(room, end) for room in rooms]) for end in ("low", "high"))
        self.designs: dict[bytes, Design | str] = {}
        self.margins: dict[bytes, Array] = {}
        self.count = len(design.improving.timing.margins(design.machine))

    def moves(self, design: Design) -> Array:
        """Return by how much the edges of a design are moved."""
        firsts = (next(iter(room.edges.items())) for room in self.rooms)
        moved: list[float] = [get(design.machine, path) - place for path, place in firsts]
        return np.asarray(moved, dtype=np.float64)

    def starts(self, more: int) -> list[Array]:
        """Return the present moves, and others spread over the rooms."""
        from scipy.stats import qmc  # slow to import

        spread = qmc.Halton(len(self.rooms), rng=0).random(more)
        return [self.moves(self.begin), *(self.low + spread * (self.high - self.low))]

    def moved(self, moves: Array, in_steps: bool = True) -> Design | str:
        """Return the design with its edges moved, by multiples of their steps or as is; or why there is none such."""
        entries: dict[Place, float] = {}
        for room, by in zip(self.rooms, moves.tolist(), strict=True):
            entries |= room.change(room.rounded(by) if in_steps else by).entries
        return self.begin.changed(Change("timing", entries, "edge"))

    def solved(self, start: Array) -> Array:
        """Return moves near others with which the largest cost is least."""
        span = self.high - self.low

        def at(shares: Array) -> Design | str:
            if shares.tobytes() not in self.designs:
                self.designs[shares.tobytes()] = self.moved(self.low + np.clip(shares, 0.0, 1.0) * span, False)
            return self.designs[shares.tobytes()]

        def uses(shares: Array) -> Array:
            design = at(shares)
            if isinstance(design, str):
                return np.full(len(self.begin.costs) + 1, WORST)
            return np.minimum(np.array([*design.costs.values(), design.cost]) / self.begin.cost, WORST)

        def slack(shares: Array) -> Array:
            design, key = at(shares), shares.tobytes()
            if isinstance(design, str):
                return np.full(self.count, -1.0)
            if key not in self.margins:
                self.margins[key] = design.improving.timing.margins(design.machine)
            return self.margins[key]

        shares: Array = least_use(uses, np.clip((start - self.low) / span, 0.0, 1.0), slack, SLOPE)
        return np.asarray(self.low + shares * span, dtype=np.float64)

    def is_better(self, design: Design | str, than: Design) -> bool:
        """Return whether a design costs less than another, breaks nothing, and holds all margins."""
        if isinstance(design, str) or not design.cost < than.cost:
            return False
        return (
            bool(design.improving.timing.margins(design.machine).min(initial=0.0) >= 0.0)
            and design.breaks() <= self.broken
        )

    def settled(self, moves: Array, best: Design) -> Design:
        """Return the design with some moves if it is better than the best so far, or one on the way to it."""
        begin, low, high = self.moves(best), 0.0, 2.0
        for _ in range(HALVINGS):
            share = 0.5 * (low + high)
            other = self.moved(begin + share * (moves - begin))
            if isinstance(other, Design) and self.is_better(other, best):
                low, best = share, other
            else:
                high = share
            if low == 1.0:
                break
        return best

    def refined(self, best: Design) -> Design:
        """Return the best design with single edges moved by fewer and fewer steps."""
        for steps in GRIDS:
            for k, room in enumerate(self.rooms):
                for by in (-steps * room.step, steps * room.step):
                    moves = self.moves(best)
                    moves[k] += by
                    other = self.moved(moves)
                    if isinstance(other, Design) and self.is_better(other, best):
                        best = other
        return best
