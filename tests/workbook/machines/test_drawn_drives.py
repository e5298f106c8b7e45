"""Machines as they are built, drawn: sheets against the exact engine, and both against the equation of motion.

``python -m tests.workbook.machines.test_drawn_drives 1000`` prints the worst of each kind as a table; a word behind the
number draws others.
"""

import sys
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from filecmp import cmp
from functools import lru_cache, partial
from math import pi

import pytest

from engine.drive.drive_points import USUAL
from engine.drive.limits import at_speed
from tests.mutation import examine
from tests.mutation.bench import Bench
from tests.tiers import seed
from tests.workbook.cells import disagreeing, disagreeing_in
from tests.workbook.evaluated import by_formulon
from tests.workbook.machines.drawn_drives import TEMPLATE, drawn_machine
from tests.workbook.machines.simulated import Simulated, bus_of
from tests.workbook.machines.test_machine_drives import arm, small
from workbook.build import build, read_inputs
from workbook.judging.verify import verify
from workbook.machines.machine.exact import drives_of, limits_of, rate_of, results_of
from workbook.machines.machine.power import Mains
from workbook.reading.descriptions import read_machine, write_machine

SAME = 1e-3
"""share by which fine quadrature and the exact engine may differ: of the peak, of powers and energies of the largest"""


def exact_results(view):
    """What the exact engine finds of a drive, by the names of :class:`Simulated`."""
    found = view.driven.limit_checks.results
    power, energy = found.power, found.energy
    return {
        "rms": found.rms_torque,
        "peak": found.torque.peak,
        "speed": found.speed.peak,
        "mean speed": found.mean_speed,
        "power": power.highest.value,
        "back power": max(0.0, -power.lowest.value),
        "driving": energy.driving,
        "returned": energy.regenerated,
        "output peak": found.shaft_torque(1).peak,
        "output mean": found.mean_shaft_torque(1),
    }


def sheet_results(view):
    """What its sheet says, by the same names."""
    points, energy, behind = view.points, view.energy, view.load.output_torque
    return {
        "rms": points.rms_torque,
        "peak": view.peaks.size("T"),
        "speed": view.speed,
        "mean speed": points.mean_speed,
        "power": view.peaks.top("P"),
        "back power": max(0.0, view.peaks.top("P", -1)),
        "driving": energy.driving,
        "returned": energy.regenerated,
        "output peak": view.peaks.size("S"),
        "output mean": points.cubic_mean(behind),
    }


def deviations(some, exact):
    """By how much results are off: RMS and peaks as shares of the peak, powers and energies of the larger of both."""
    pairs = (
        ("rms", "peak"),
        ("peak", "peak"),
        ("speed", "speed"),
        ("mean speed", "speed"),
        ("output peak", "output peak"),
        ("output mean", "output peak"),
        ("power", "back power"),
        ("back power", "power"),
        ("driving", "returned"),
        ("returned", "driving"),
    )
    return {name: abs(some[name] - exact[name]) / max(exact[name], exact[other], 1e-9) for name, other in pairs}


BY_NAME = {
    "RMS torque": "rms",
    "peak torque": "peak",
    "motor speed": "speed",
    "reducer input speed": "speed",
    "reducer peak torque": "output peak",
    "reducer mean torque": "output mean",
}
"""of limits, the result that the equation of motion has of each"""


def wrong_verdicts(view, simulated):
    """Limits said to be held that the equation of motion breaks: by all, or by a sheet alone beyond its bound."""
    for limit in limits_of(view):
        asked = simulated.results[BY_NAME[limit.what]] if limit.what in BY_NAME else limit.exact.value
        share = asked * (30 / pi if limit.unit == "rpm" and limit.what in BY_NAME else 1.0) / limit.exact.limit
        if (limit.ok and share > 1.0 + SAME) or (limit.sheet.ok and share > 1.0 + limit.bound + 1e-6):
            yield f"{view.driven.called}: {limit.what} is {100.0 * share:.4g} % of its limit"


def largest_use(view, machine, rate):
    """The share of its limit that the most used limit of a drive is used by at a rate, by the equation of motion."""
    results = Simulated(view.tables.axis, machine, rate).results
    checks = at_speed(view.driven.limit_checks, rate * pi / 30).checks
    return max(results[BY_NAME[check.name]] / check.limit if check.name in BY_NAME else check.use for check in checks)


class Drawn:
    """A machine of a number, with its drives as their sheets and as the equation of motion have them."""

    def __init__(self, number, text):
        self.number, self.machine = number, drawn_machine(number, text)
        self.views = list(drives_of(self.machine))
        self.simulated = [Simulated(view.tables.axis, self.machine) for view in self.views]


@lru_cache(maxsize=100)
def drawn_again(number, text):
    """A drawn machine, of which some tests ask for few and others for all."""
    return Drawn(number, text)


def machines(*day, night):
    """Numbers of drawn machines and what they are drawn from: by night another each time."""
    by_night = (pytest.param((k, seed("drawn")), marks=pytest.mark.nightly, id=f"night {k}") for k in range(night))
    return [*(pytest.param((number, "drawn"), id=str(number)) for number in day), *by_night]


@pytest.fixture(scope="module", params=machines(*range(60), night=180))
def drawn(request):
    """One machine after another, for all tests of it."""
    return drawn_again(*request.param)


def test_the_exact_engine_and_the_equation_of_motion_agree(drawn):
    for view, one in zip(drawn.views, drawn.simulated, strict=True):
        off = deviations(one.results, exact_results(view))
        assert {name: share for name, share in off.items() if share > SAME} == {}


def test_an_arm_that_a_table_moves_is_cut_at_the_points_of_the_table():
    points = [
        {"angle": angle, "position": angle + bend} for angle, bend in ((0, 0), (20, 3), (50, -4), (80, 2), (120, 0))
    ]
    moved = {"mechanism": {"kind": "table", "efficiency": 0.9, "points": points}, "closes": "position"}
    machine = small(arm((20.0, 140.0, 90.0, "CIC"), (190.0, 330.0, -90.0, "MTP"), **moved))
    for view in drives_of(machine):
        off = deviations(Simulated(view.tables.axis, machine).results, exact_results(view))
        assert {name: share for name, share in off.items() if share > SAME} == {}


def test_every_result_is_as_exact_as_its_sheet_states(drawn):
    """Where it is cut wherever it turns round: a check of the sheet says where it is not."""
    views = [view for view in drawn.views if is_cut_everywhere(view)]
    assert [line for view in views for line in results_of(view)] == []


def test_no_sheet_says_ok_where_the_equation_of_motion_says_fail(drawn):
    both = zip(drawn.views, drawn.simulated, strict=True)
    assert [line for view, one in both for line in wrong_verdicts(view, one)] == []


@pytest.mark.parametrize("drawn", machines(*range(0, 60, 10), night=36), indirect=True)
def test_the_highest_rate_of_a_sheet_is_that_of_the_equation_of_motion(drawn):
    """All limits are held there and a per cent above it one is not, or verify tells the exact rate."""
    for view in drawn.views:
        highest = view.rates.high
        if not isinstance(highest, str) and not list(rate_of(view)):
            assert largest_use(view, drawn.machine, highest) <= 1.0 + SAME
            assert largest_use(view, drawn.machine, 1.01 * highest) > 1.0 - SAME


def test_a_common_bus_takes_no_more_than_its_bounds(drawn):
    """To what the sheets of its drives state of their powers, where they are cut wherever they turn round."""
    if len(drawn.views) > 1 and all(is_cut_everywhere(view) for view in drawn.views):
        bus, found = Mains(drawn.views, drawn.machine.power), bus_of(drawn.simulated, drawn.machine.power.efficiency)
        assert found.peak <= bus.cuts.peak_most * (1.0 + USUAL.peak_power)
        assert found.burnt_peak <= bus.cuts.burnt_most * (1.0 + USUAL.peak_power) + 1e-6 * bus.cuts.peak_most
        known = USUAL.energy * bus.without.mains
        assert bus.without.mains - bus.saved_most - known <= found.mean <= bus.without.mains + known


@pytest.mark.parametrize("numbered", machines(2, 11, 32, night=17))
def test_every_cell_of_drawn_machines_and_of_a_variation_agrees_with_the_engine(numbered):
    """A drawn machine has what drives can have, mixed: stages, windows, brakes, viscous friction, falling curves."""
    number, _ = numbered
    machine = drawn_machine(*numbered)
    for one in (machine, TEMPLATE.variants(machine)[number % 6]):
        by_hand = disagreeing_in(TEMPLATE, one, by_formulon) if number % 4 == 3 else disagreeing(TEMPLATE, one)
        wrong, count = by_hand
        assert wrong == []
        assert count > 2000


@pytest.mark.parametrize("numbered", machines(night=4))
def test_every_mutant_of_the_sheet_of_a_drawn_drive_is_found(numbered):
    bench = Bench(TEMPLATE, drawn_machine(*numbered))
    drives = {block.sheet.title for name, block in bench.declared.blocks.items() if name.startswith("drive1_")}
    mutants = [one for one in bench.orchard.sample(600, numbered[0]) if one.address.sheet in drives]
    assert len(mutants) > 50
    assert [
        str(v.mutant) for v in examine.examined(bench, mutants, []) if not v.found(False) and not v.is_harmless
    ] == []


@pytest.mark.parametrize("numbered", machines(18, night=5))
def test_the_book_of_a_drawn_machine_verifies_and_gives_back_what_was_entered(numbered, tmp_path):
    machine = drawn_machine(*numbered)
    path, again = tmp_path / "book.xlsx", tmp_path / "again.xlsx"
    build(machine, path)
    assert [str(one) for one in verify(path).findings] == []
    back, notes = read_inputs(path)
    assert (back, notes) == (machine, [])
    build(back, again)
    assert cmp(again, path, shallow=False)


@pytest.mark.parametrize("numbered", machines(*range(10), night=0))
def test_a_drawn_machine_comes_back_from_its_description(numbered, tmp_path):
    machine = drawn_machine(*numbered)
    path = tmp_path / "machine.toml"
    path.write_text(write_machine(machine), encoding="utf-8")
    assert read_machine(path) == machine


def is_cut_everywhere(view):
    """Whether a drive is cut wherever it turns round: a check of its sheet says where it is not."""
    return view.turns_cut == len(view.tables.turns)


def examined(number, text):
    """Of the drives of a machine: how many, how many are not cut everywhere, deviations, and what breaks a bound."""
    drawn, shares = Drawn(number, text), []
    both = list(zip(drawn.views, drawn.simulated, strict=True))
    for view, simulated in both:
        exact, kind = exact_results(view), view.driven.given.kind
        ways = {"motion": simulated.results} | ({"sheet": sheet_results(view)} if is_cut_everywhere(view) else {})
        for way, some in ways.items():
            shares += [(name, way, share, number, kind) for name, share in deviations(some, exact).items()]
    wrong = [f"{number}: {line}" for view, simulated in both for line in wrong_verdicts(view, simulated)]
    cut = [view for view in drawn.views if is_cut_everywhere(view)]
    return (
        len(both),
        len(both) - len(cut),
        shares,
        wrong,
        [f"{number}: {line}" for view in cut for line in results_of(view)],
    )


def main(count, text="drawn"):
    """Print the worst deviation of each result of so many machines, of the sheets and of the equation of motion."""
    worst, drives, uncut, wrong, beyond = defaultdict(lambda: (0.0, 0, "")), 0, 0, [], []
    with ProcessPoolExecutor() as pool:
        for driven, not_cut, shares, false, off in pool.map(partial(examined, text=text), range(count), chunksize=4):
            drives, uncut, wrong, beyond = drives + driven, uncut + not_cut, wrong + false, beyond + off
            for name, way, *found in shares:
                worst[name, way] = max(worst[name, way], tuple(found))
    print(f"{count} machines with {drives} drives: {len(wrong)} limits are said to be held that the equation of motion")
    print(
        f"breaks, {len(beyond)} results are farther off than their sheet states. {uncut} drives turn round more often"
    )
    print("than their sheets cut them, as a check there says: they are not in the column of the sheets.\n")
    for line in [*wrong, *beyond]:
        print(f"- {line}")
    print("| result | of the sheets | machine | of the equation of motion | machine |\n|---|---|---|---|---|")
    for name in dict.fromkeys(name for name, _ in worst):
        columns = (
            f"{100 * share:.4f} % | {number}, {kind}"
            for share, number, kind in (worst[name, way] for way in ("sheet", "motion"))
        )
        print(f"| {name} | {' | '.join(columns)} |")


if __name__ == "__main__":
    main(int(sys.argv[1]), *sys.argv[2:])
