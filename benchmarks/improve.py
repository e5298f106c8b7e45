"""What a law shaped for its drive and the first list of `motionbook improve` cost, in seconds of the processor."""

import math
import time
from collections.abc import Callable

from numpy.polynomial import Polynomial

from engine.drive.shaped import shape
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import read_machine
from workbook.studies.design import first_design
from workbook.studies.improve import STAGES, better, obstacles, single_gains
from workbook.templates import TEMPLATES

INERTIA = Polynomial([3.62477004e-3, -8.11242143e-5, 1.54632995e-2, -1.01883497e-2, 1.68396654e-3])  # kg m²
LOAD = Polynomial([0.10244372, 1.22240552, -0.13085737, -1.22211419, 0.62392123, -0.08375826])  # Nm
ROUNDS, DEGREES = 3, (7, 9, 11, 13)
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


def main() -> None:
    for degree in DEGREES:
        measure(f"a law of degree {degree}", lambda degree=degree: shape(bolt_torque, 3.0299, 0.07375, degree))
    design = first_design(read_machine(CUTTING), True)
    measure("what limits the cutting machine", lambda: obstacles(design))
    measure("its single changes", lambda: [*single_gains(design, THIS_PROCESS, lambda *_: None)])
    for words, kinds, _ in STAGES.values():
        measure(f"its best {words}", lambda kinds=kinds: [*better(design, kinds, THIS_PROCESS, lambda *_: None)])


if __name__ == "__main__":
    main()
