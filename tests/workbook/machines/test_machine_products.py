"""Motor and reducer of a machine's drives: by name or as entered, one entry decides, and their limits."""

import pytest

from engine.drive.limits import CYCLES, REDUCER_TORQUE
from tests.workbook.cells import computed, entered
from tests.workbook.machines.test_machine import TEMPLATE, driven, small
from workbook.build import failing_checks
from workbook.machines.machine.drive.max_rate import LIMITS as LIMITS_OF_RATE
from workbook.machines.machine.drive_entries import UNTOLD
from workbook.machines.machine.exact import drives_of, exact_rates
from workbook.reading.descriptions import make_machine, read_machine
from workbook.selection.catalogue_files import committed_motors, committed_reducers
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

PHASES = ((30, 90, 2.0, "CIC"), (180, 200, -2.0, "MTP"))
MOTOR, REDUCER = committed_motors()[3], committed_reducers()[4]
FIGURES = {"inertia": MOTOR.inertia, "rated_torque": MOTOR.rated_torque, "peak_torque": MOTOR.peak_torque,
           "max_speed": MOTOR.max_speed}  # fmt: skip


def failed(machine):
    """The labels of the checks that fail."""
    return [line.partition(": ")[2].partition(":")[0] for line in failing_checks(TEMPLATE.declare(machine))]


def test_a_name_is_the_figures_of_the_catalogue_whatever_else_is_entered():
    others = {"inertia": 90000.0, "rated_torque": 1e-3, "peak_torque": 1e-3, "max_speed": 1.0}
    named = small([driven(*PHASES, motor=others | {"name": MOTOR.name.upper()},
                              reducer={"name": REDUCER.name, "ratio": 99.0})])  # fmt: skip
    told = small([driven(*PHASES, motor=FIGURES,
                             reducer={"ratio": REDUCER.reduction, "efficiency": REDUCER.efficiency,
                                      "inertia": REDUCER.inertia, "no_load_torque": REDUCER.no_load_torque,
                                      "peak_torque": REDUCER.max_torque,
                                      "max_speed": REDUCER.max_speed})])  # fmt: skip
    one, other = computed(TEMPLATE, named), computed(TEMPLATE, told)
    for name in ("jtot", "tmax", "tmin", "rms", "speed", "smax", "res_rms", "res_peak", "res_speed", "ok_rms"):
        assert one(f"drive1_{name}") == other(f"drive1_{name}"), name
    assert entered(TEMPLATE, named) == (named, [])


def test_copper_losses_of_the_catalogue_count_unless_others_are_entered():
    """Mean power is that without them and P_Cu/T_N² T_rms²: 1.5 · 0.94 Ω · (10.6 A)² · 1.393 = 0.221 kW of BH20S."""
    motor = next(one for one in committed_motors() if one.name.startswith("HDT BH20S"))
    assert motor.copper_losses == pytest.approx(1.5 * 0.94 * 10.6**2 * (1 + 0.00393 * 100) / 1000, abs=5e-4)

    def power(own):
        """Mean power (kW) and T_rms (Nm) of a drive with this motor, and losses of one's own."""
        value = computed(TEMPLATE, small([driven(*PHASES, motor={"name": motor.name, "copper_losses": own})]))
        return value("drive1_power"), value("drive1_rms")

    bare, rms = power(0.0)
    for own, losses in ((None, motor.copper_losses), (0.5, 0.5)):
        assert power(own)[0] - bare == pytest.approx(losses * (rms / motor.rated_torque) ** 2, rel=1e-9)


def test_a_name_that_no_product_has_is_refused():
    with pytest.raises(ValueError, match="no motor of the catalogue is named 'HG-0'"):
        small([driven(*PHASES, motor={"name": "HG-0"})])


def test_a_motor_neither_named_nor_entered_makes_an_unfinished_design():
    data = small([driven(*PHASES)]).model_dump()
    data["axes"][0]["motor"]["peak_torque"] = None
    machine = make_machine(TEMPLATE, data, str)
    assert [fault.key for fault in machine.design.faults] == ["axes.0.motor.peak_torque"]


def test_selection_finds_a_motor_for_a_drive_that_has_none_yet():
    data = small([driven(*PHASES)]).model_dump() | {"selection": {"axis": "A1"}}
    del data["axes"][0]["motor"]
    machine = make_machine(TEMPLATE, data, str)
    assert {fault.message for fault in machine.design.faults} == {UNTOLD}
    value = computed(TEMPLATE, machine, by_cells=True)
    assert (value("drive1_ok_told"), value("sel_ok"), value("sel_motor") != "none") == ("FAIL", "OK", True)


@pytest.mark.parametrize(("limit", "value"), [("peak_torque", "drive1_smax"), ("max_speed", "drive1_speed")])
def test_a_limit_of_the_reducer_is_held_up_to_what_it_is_and_no_further(limit, value):
    free = {"ratio": 3.0, "efficiency": 0.9}
    reached = computed(TEMPLATE, small([driven(*PHASES, reducer=free)]))(value)
    for share, holds in ((1.0 + 1e-9, True), (1.0 - 1e-9, False)):
        machine = small([driven(*PHASES, reducer=free | {limit: reached * share})])
        assert any("the reducer's" in line for line in failed(machine)) is not holds


@pytest.mark.parametrize(("full", "highest"), [(0.6, 0.5**0.5), (0.8, 0.8), (1.0, 1.0), (2.0, 1.0)])
def test_beyond_its_cycles_an_hour_the_reducer_s_torque_counts_over_the_factor(full, highest):
    """Of a load that only accelerates S grows as N²: T_2B is met at N, T_2B/2 at N/√2; T_2B holds up to ``full`` N."""
    free = {"ratio": 3.0, "efficiency": 0.9}
    asked = computed(TEMPLATE, small([driven(*PHASES, reducer=free)]))
    rate, torque = asked("drive1_rate"), asked("drive1_smax") * (1.0 + 1e-12)
    limits = {"peak_torque": torque, "cycle_factor": 2.0, "full_cycles": 60.0 * rate * full}
    machine = small([driven(*PHASES, reducer=free | limits)])
    value, holds = computed(TEMPLATE, machine), full >= 1.0
    assert value("drive1_reducer_held") == pytest.approx(torque if holds else torque / 2.0, rel=1e-15)
    assert any("the reducer's" in line for line in failed(machine)) is not holds
    estimates = (value("drive1_held", "rate")[LIMITS_OF_RATE["name"].index(name)] for name in (REDUCER_TORQUE, CYCLES))
    assert min(estimates) == pytest.approx(highest * rate, rel=1e-9)
    (view,) = drives_of(machine)
    exact = exact_rates(view)
    assert (exact.high, exact.high_limit) == (pytest.approx(highest * rate, rel=1e-7), REDUCER_TORQUE)
    assert 0.99 * exact.high <= value("drive1_highest") <= exact.high * (1.0 + 1e-9)


def test_the_factor_of_the_catalogue_counts_beyond_a_thousand_cycles_an_hour_in_drive_and_selection():
    """What the drive's reducer may carry is what the pairs of the sheet Selection are held to."""
    name = committed_reducers()[1].name
    data = small([driven(*PHASES, reducer={"name": name})]).model_dump() | {"selection": {"axis": "A1"}}
    for rate, factor in ((1000.0 / 60.0, 1.0), (1001.0 / 60.0, 2.0)):
        value = computed(TEMPLATE, make_machine(TEMPLATE, data | {"master": data["master"] | {"rate": rate}}, str))
        assert value("drive1_reducer_peak") / value("drive1_reducer_held") == factor
        assert value("sel_reducers", "fs")[:3] == [1.0, factor, factor]  # the first is none
        assert value("sel_reducers", "held")[1] == value("drive1_reducer_held")


def test_the_figures_in_use_are_printed():
    used = TEMPLATES["machine"].declare(read_machine(FOLDER / "machine.toml")).blocks["drive1_rated"]
    assert used.row <= used.sheet.print_rows


@pytest.mark.parametrize("name", ["machine", "flying-cutter"])
def test_the_table_of_what_each_pair_fails_is_printed_whole(name):
    blocks = TEMPLATES[name].declare(read_machine(FOLDER / f"{name}.toml")).blocks
    matrix = [block for called, block in blocks.items() if called.startswith("sel_why")]
    sheet = matrix[0].sheet
    assert max(block.row + block.size - 1 for block in matrix) <= sheet.print_rows
    assert max(max(block.columns.values()) for block in matrix) <= sheet.print_columns
