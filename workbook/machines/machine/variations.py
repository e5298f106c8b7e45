"""Other inputs at which ``verify`` evaluates a machine's book: every law, axis by axis, rests of every kind, shifts."""

from collections.abc import Callable, Iterable
from typing import Any, get_args

from engine.selection.pair_matrix import RANKS
from workbook.entries.facts import vary
from workbook.entries.phase import AxisPhase
from workbook.law_sheets import library
from workbook.machines.machine import drive_entries
from workbook.machines.machine.drive import by_angle
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.entries import AnyMachine, MachineSizes, rests
from workbook.machines.machine.entries_beside import TIMES, ClearanceEntry, HardStops, Vibration
from workbook.machines.machine.mechanism import MECHANISMS, SLIDING
from workbook.machines.machine.places import to_units
from workbook.motion.requirements import Smoothness, dwells_for_room
from workbook.selection.entries import Limits, OwnLimits

CYLINDER = {"diameter": 60.0, "density": 7800.0}
STRAIGHT = "=-1"  # of a page: how a straight line meets its neighbours
BESIDE_SOME = ("LIN", "PO5", "OWN", "SPL")  # laws that an axis cannot take beside any neighbours
SHIFTS = (0.0, 37.5, -20.0, 360.0, 145.25, 733.0)


def variants(machine: AnyMachine) -> list[AnyMachine]:
    """Return six machines of the same layout as ``machine``, with other inputs everywhere."""
    suited = list if any(axis.motor is None for axis in machine.axes) else suited_to("table")
    return [type(machine).model_validate(data) for data in library.variations(machine, varied, suited)]


def suited_to(kind: str | None) -> Callable[[dict[str, Any]], list[str]]:
    """Return a function that picks the laws that an axis can take beside any neighbours; ``kind`` is its mechanism.

    Beside a straight line a phase may move there and back: not behind every mechanism.
    """

    def suited(laws: dict[str, Any]) -> list[str]:
        pages = {name: library.page_of(name, entry) for name, entry in laws.items()}
        straight = [name for name, page in pages.items() if page.end_mode == STRAIGHT and kind not in LINKAGES]
        return straight + [name for name, page in pages.items() if page.law.code not in BESIDE_SOME]

    return suited if kind else list


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: numbers scaled each by its own factor, choices turned."""
    k, laws, sizes, master = turn % library.SIX, data["laws"], data["sizes"], data["master"]
    scale, pace = library.factors(k), next(iter(master))
    library.vary_laws(laws, k, scale, sizes["pieces"])
    choose(data, k)
    master[pace] *= next(scale)
    master |= {"compare_rate": 41.0 * k} if master.get("compare_rate") is not None else {}
    for i, axis in enumerate(data["axes"]):
        kind = axis["mechanism"]["kind"] if axis["motor"] else None
        rows = phases(i, turn, sizes["phases"], suited_to(kind)(laws))
        cuts = 2 * len(forces(i, k, 1.0)) if kind else 0
        resting = len(rests([AxisPhase(**row) for row in rows]))
        room = MachineSizes(**sizes).pieces_of(i + 1) - resting - cuts
        axis |= {
            "closes": "feed" if (i + k) % 2 else "position",
            "smoothness": library.pick_in_turn(turn + i, get_args(Smoothness)),
            "shift": SHIFTS[(i + k) % library.SIX],
            "position": 0.0 if kind in LINKAGES else (k - 2) * (7.5 + i),
            "phases": dwells_for_room(rows, laws, room),
        }
        if kind:
            axis["rate"] = (None, 31.0, 260.5)[(i + k) % 3]
            drive(axis, i, k, sizes, data["selection"])
        else:
            axis["closes"] = ("feed", "open", "position", "open", "feed", "position")[(i + k) % library.SIX]
            for n, phase in enumerate(axis["phases"]):
                phase |= library.passing(k, n, laws, 0.01)
        loose = axis["backlash"] or {}
        vary(loose, drive_entries.Backlash, i + k)
        loose["works"] = len(axis["load"]["windows"]) or None
        vary(axis["stops"] or {}, HardStops, i + k)
        vary(axis["vibration"] or {}, Vibration, i + k)
    vary_drives_together(data, k)
    for i, clearance in enumerate(data["clearances"]):
        vary(clearance, ClearanceEntry, i + k)
        for n, pair in enumerate(clearance["pairs"]):
            pair |= {"at": 1.1 * pair["at"] - k, "free": pair["free"] + 3.0 * (n % (k + 2))}
    for i, switch in enumerate(data["switches"]):
        switch["on"] = times(i, k)
    if pace == "cycle":
        to_units(data, master["unit"], master[pace])
    return data


def vary_drives_together(data: dict[str, Any], k: int) -> None:
    """Give a machine that has drives another supply, creeping and gravity."""
    driven = [axis for axis in data["axes"] if axis["motor"] is not None]
    if driven:
        vary(data["power"], drive_entries.PowerEntry, k)
        data["creep_forces"] = ("off", "on")[k % 2]
    data |= {"gravity": 9.81 - 0.7 * k} if any(axis["unit"] == "mm" for axis in driven) else {}


def choose(data: dict[str, Any], k: int) -> None:
    """Turn how peak torques of the catalogue fall, if they do; the axis of Selection, its rank, and limits of pairs."""
    products, names = data["selection"], [axis["name"] for axis in data["axes"] if axis["motor"]]
    if any(map(drive_entries.falling, products["motors"])) if products["falling"] is None else products["falling"]:
        products["falling"] = True
        for n, motor in enumerate(products["motors"]):
            level = (n + k) % 4 == 3
            motor["full_torque_to"] = None if level else motor["max_speed"] * (0.02 + 0.15 * ((n + k) % library.SIX))
            motor["end_torque"] = None if level else motor["peak_torque"] * 0.23 * ((n + 2 * k) % 4)
    if products["axis"] is not None:
        products |= {
            "axis": names[k % len(names)],
            "rank": RANKS[k % len(RANKS)],
            "greatest_margin": (1e6, 300.0, 1e9, 1e6, 10.0, 1e9)[k],
        }
    if names:
        vary(data["limits"], Limits, k)


def times(i: int, k: int) -> list[dict[str, float | None]]:
    """Return times of being on: up to the table's last, a time across the end, an empty one; always on, and never."""
    if (i + k) % library.SIX in (1, 4):
        return [{"start": 0.0, "stop": 360.0}] if (i + k) % library.SIX == 1 else []
    begins = [60.0 * t + 17.0 * k + 3.5 * i for t in range(TIMES if k == 0 else 1 + (i + k) % 4)]
    times_on: list[dict[str, float | None]] = [
        {"start": (x + 40.0) % 360, "stop": (x + 71.25 + k) % 360} for x in begins
    ]
    if len(times_on) > 2:
        times_on[1] = {"start": None, "stop": None}
    return times_on


def move_between(phases: list[dict[str, Any]], low: float, high: float, k: int) -> None:
    """Let the phases that move go between both positions, from 0 and, but once, back to it."""
    moving, at = [phase for phase in phases if phase["lift"]], 0.0
    for n, phase in enumerate(moving):
        goal = low + (high - low) * (1.0 if n == 0 else (0.45 * n + 0.1 * k) % 1.0)
        phase["lift"] = (0.0 if n == len(moving) - 1 and k != 3 else goal) - at
        at += phase["lift"]


def drive(axis: dict[str, Any], i: int, k: int, sizes: dict[str, Any], products: dict[str, Any]) -> None:
    """Give an axis another drive of its kind: loads that resist and that drive, parts on each shaft, every limit."""
    motors, reducers = products["motors"], products["reducers"]
    mechanism, load = axis["mechanism"], axis["load"]
    kind = mechanism["kind"]
    vary(mechanism, MECHANISMS[kind], i + k)
    if mechanism.get("belt_on_bed") is not None:
        mechanism["belt_on_bed"] = 0.375 * (mechanism["belt_mass"] or 0.0)
    if kind in LINKAGES:
        other, low, high = LINKAGES[kind].varied(i, k, sizes["positions"])
        mechanism |= other
        move_between(axis["phases"], low, high, k)
    if kind in SLIDING:
        mechanism |= by_angle.varied(i, k)
    travels = axis["unit"] == "mm" or kind in SLIDING
    vary(load, drive_entries.AxisLoad, i + k, drive_entries.lacking(travels, load["viscous"]))
    load["windows"] = forces(i, k, 400.0 if travels else 6.0)
    axis["parts"] = parts(k, sizes["rotors"])
    vary(axis["reducer"], drive_entries.Reducer, i + k)
    axis["reducer"]["name"] = reducers[(7 * i + k) % len(reducers)]["name"] if (i + k) % 3 == 2 else ""
    for n, stage in enumerate(axis["stages"], k + i):
        vary(stage, drive_entries.StageEntry, n)
        teeth = {"teeth_driver": 18.0 + n, "teeth_driven": 31.0 + 3 * n}
        stage |= {"ratio": 0.6 + 0.7 * n} | dict.fromkeys(teeth) if n % 2 else {"ratio": None} | teeth
    vary(axis["limits"], OwnLimits, i + k)
    vary(axis["motor"], drive_entries.AxisMotor, i + k)
    axis["motor"]["name"] = motors[(5 * i + k) % len(motors)]["name"] if (i + k) % 3 == 1 else ""


def parts(k: int, room: int) -> list[dict[str, Any]]:
    """Return parts on the motor's shaft and on the mechanism's, by inertia or as cylinders; once ``room`` of them."""
    cylinder, rows = CYLINDER | {"length": 100.0 + 15 * k, "bore": 20.0 if k % 2 else None}, []
    for j in range(room if k == 0 else k % 3):
        shaft = ("motor", "mechanism")[(j + k) % 2]
        part = {"name": f"part {j + 1}", "count": 1.0 + j, "shaft": shaft}
        geared = {"teeth_driver": 40.0 + j, "teeth_driven": 23.0 + k} if (j // 2 + k) % 2 else {}
        rows.append(part | (cylinder if (j + k) % 3 == 1 else {"inertia": 20.0 * (j + k)}) | geared)
    return rows


def forces(i: int, k: int, size: float) -> list[dict[str, Any]]:
    """Return process forces up to the table's last row: of both kinds and signs, also across the end of the cycle."""
    kinds, windows = (
        ("always", "moving"),
        ((20.0, 95.5, 1.0), (300.0, 40.0, -0.7), (0.0, 360.0, 0.3), (88.25, 88.25, 2.0)),
    )
    return [
        {"start": start, "stop": stop, "force": share * size, "resists": kinds[(i + k + n) % 2]}
        for n, (start, stop, share) in enumerate(windows[: drive_entries.WINDOWS if k == 2 else (i + k) % 3])
    ]


def phases(axis: int, turn: int, room: int, laws: Iterable[str]) -> list[dict[str, Any]]:
    """Return phases up to the table's last row in turn, with laws and lifts of every kind; some rests are left out."""
    k = turn % library.SIX
    count = room if k == 0 else min(room, 2 + (axis + k) % 5)
    step = 360.0 / count
    edges = [0.0, *((i + 0.1 * ((i + k) % 3)) * step for i in range(1, count)), 360.0]
    rows = []
    for i in range(count):
        rest = (i + axis) % 4 == 3
        if rest and i and (axis + k) % 2:
            continue
        lift = 0.0 if rest else (40.0 + 11 * axis + 3 * i) * (-1) ** (i + k)
        law = "DWL" if rest else library.pick_in_turn(axis + turn + i, laws)
        stop = edges[i + 1] - (3.7 if (i + k) % 3 == 1 else 0.0)
        rows.append({"start": edges[i], "stop": stop, "lift": lift, "law": law})
    return rows
