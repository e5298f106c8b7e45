"""What a law shaped for its drive and the lists of `motionbook improve` cost, in seconds of the processor.

Beside them, how long SciPy's differential evolution takes on the same objective to come within 1 % of the same design.
"""

import math
import time
from collections.abc import Callable

from numpy.polynomial import Polynomial
from scipy.optimize import differential_evolution

from engine.drive.shaped import Splines
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import read_machine
from workbook.studies.design import first_design
from workbook.studies.improve import STAGES, STARTS, better, obstacles, single_gains
from workbook.studies.timing import TimingSearch, best_timing
from workbook.templates import TEMPLATES

INERTIA = Polynomial([3.62477004e-3, -8.11242143e-5, 1.54632995e-2, -1.01883497e-2, 1.68396654e-3])  # kg m²
LOAD = Polynomial([0.10244372, 1.22240552, -0.13085737, -1.22211419, 0.62392123, -0.08375826])  # Nm
LIFT, TIME = 3.0299, 0.07375  # rad, s
ROUNDS, DEGREES = 3, (7, 9, 11, 13)
NEAR, GENERATIONS = 1.01, 2000  # of the least cost: so near is there; of the evolution, at most
CUTTING = TEMPLATES["machine"].description.with_name("cutting-machine.toml")


def bolt_torque(y, v, a):
    """The torque of the machine of Van Oosterwyck et al."""
    return LOAD(y) + INERTIA(y) * a + 0.5 * INERTIA.deriv()(y) * v**2


def measure(words: str, task: Callable[[], object]) -> None:
    """Print the least time of the rounds, the first of which also imports."""
    least = math.inf
    for _ in range(ROUNDS):
        begin = time.process_time()
        task()
        least = min(least, time.process_time() - begin)
    print(f"{words:40} {least:6.3f} s")


def evolve(cost, bounds, least: float) -> None:
    """Print how long differential evolution takes to come near the least cost, and how many designs it tries."""
    begin = time.process_time()
    found = differential_evolution(
        cost,
        bounds,
        maxiter=GENERATIONS,
        polish=False,
        tol=0.0,
        seed=0,
        callback=lambda intermediate_result: intermediate_result.fun <= NEAR * least,
    )
    spent = time.process_time() - begin
    over = 100.0 * (found.fun / least - 1.0)
    print(f"{'  by differential evolution':40} {spent:6.3f} s, {found.nfev} designs, {over:.1f} % above")


def evolve_law(degree: int) -> None:
    """Shape a law by evolution, its coefficients as far beyond 0 and 1 as the rise is wide."""
    family = Splines(degree)
    tables = family.tables(family.inner, (LIFT, LIFT / TIME, LIFT / TIME**2))
    least = family.shape(bolt_torque, LIFT, TIME).rms_torque
    evolve(lambda chosen: family.torque_over(bolt_torque, tables, chosen), [(-1.0, 2.0)] * family.even.size, least)


def evolve_timing(design) -> None:
    """Find the best timing by evolution, in steps, of a design whose checks hold as far as they did."""
    rooms = design.improving.timing.rooms(design.base, design.machine, design.limiting)
    search, best = TimingSearch(design, rooms), best_timing(design, STARTS, lambda *_: None)

    def cost(moves) -> float:
        other = search.moved(moves)
        return other.cost if search.is_better(other, design) else 2.0 * design.cost

    evolve(cost, [(room.low, room.high) for room in rooms], best.cost)


def main() -> None:
    for degree in DEGREES:
        measure(f"a law of degree {degree}", lambda degree=degree: Splines(degree).shape(bolt_torque, LIFT, TIME))
        evolve_law(degree)
    measure("a law of eight pieces of degree 5", lambda: Splines(5, pieces=8).shape(bolt_torque, LIFT, TIME))
    design = first_design(read_machine(CUTTING))
    measure("what limits the cutting machine", lambda: obstacles(design))
    measure("its single changes", lambda: [*single_gains(design, THIS_PROCESS, lambda *_: None)])
    for words, kinds, _ in STAGES.values():
        measure(f"its best {words}", lambda kinds=kinds: [*better(design, kinds, THIS_PROCESS, lambda *_: None)])
        if words == "timing":
            evolve_timing(design)


if __name__ == "__main__":
    main()
