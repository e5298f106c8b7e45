"""The list of the best pairs on the sheet Selection, and the search for them."""

import numpy as np

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.fields.units import PER_RPM, RPM, shown
from workbook.selection.pair_selection import BEST, PairSelection

CELLS = cell_tables(__file__)


def best_table(sheet: Sheet, view: PairSelection) -> None:
    """Declare the list of the best pairs."""
    cell = CELLS["best"]
    pairs, listed, motors, reducers = view.ranked[:BEST], view.listed, view.motors, view.reducers
    torque = max([*(pair.peak for pair in listed), 1e-3])

    def of(figure: str) -> list[float]:
        return filled([getattr(pair, figure) for pair in listed], BEST)

    sheet.row += 1
    cell.sharing(BEST=BEST).place(
        sheet,
        cell("motor", filled([motors.names[m] for m, _ in pairs], BEST, "–")),
        cell("reducer", filled([reducers.names[r] for _, r in pairs], BEST, "–")),
        cell("place", list(range(1, BEST + 1))),
        cell("i", filled([float(reducers.reduction[r]) for _, r in pairs], BEST)),
        cell("rms", of("rms"), scale=torque),
        cell("share", filled([view.grid.use(*pair)[1] for pair in pairs], BEST), shares=view.whole("share")),
        cell("peak", of("peak"), peaks=view.whole("peak"), scale=torque),
        cell("n", of("speed")),
        cell("inertias", of("inertias")),
        cell("spare", of("spare"), scale=torque),
        cell("holds", filled([int(pair.spare >= 0.0) for pair in listed], BEST, 0)),
        cell("mass", together(view, "size")),
        cell("cost", together(view, "cost")),
        blank="[place]>@count",
    )


def together(view: PairSelection, figure: str) -> list[float]:
    """Return the sum of a figure of motor and reducer of each of the best pairs, 0 where either has none."""
    motors, reducers = (getattr(products, figure) for products in (view.motors, view.reducers))
    sums = [motors[m] + reducers[r] for m, r in view.ranked[:BEST]]
    return filled([float(each) if np.isfinite(each) else 0.0 for each in sums], BEST)


def order_table(sheet: Sheet, view: PairSelection) -> None:
    """Declare which pairs the best are: the smallest keys, and the rows of the catalogue that these tell."""
    cell = CELLS["order"]
    pairs, across = view.ranked[:BEST], view.rooms[1]
    sheet.row += 1
    cell.place(
        sheet,
        cell("key", filled([float(view.keys[pair]) for pair in pairs], BEST), keys=view.whole("key")),
        cell("at", filled([m * across + r for m, r in pairs], BEST, 0), pairs=view.pairs),
        cell("m", filled([m + 1 for m, _ in pairs], BEST, 0), across=across),
        cell("r", filled([r + 1 for _, r in pairs], BEST, 0), across=across),
        *(
            cell("{figure}", together(view, name), figure=figure)
            for figure, name in (("mass", "size"), ("cost", "cost"))
        ),
        *figures(view),
    )


def figures(view: PairSelection) -> list[Quantity]:
    """Return the columns of a pair's figures, and of what it leaves below its motor's curve."""
    cell = CELLS["figures"]
    pairs, m, least = view.ranked[:BEST], view.motors, view.requirements.least_peak
    each = [view.grid.pair(*pair) for pair in pairs]
    asked = [view.grid.falling_demand(*pair) for pair in pairs]
    scale = max([*(abs(pair.peak) for pair in view.listed), *map(abs, asked), 1e-3])
    motors, reducers = (list(rows) for rows in zip(*pairs, strict=True)) if pairs else ([], [])
    mixed, square = view.load.mixed(view.bare)[reducers], view.load.square(view.bare)[reducers]
    return [
        cell("j", filled([pair.inertia for pair in each], BEST)),
        cell("i", filled([pair.ratio for pair in each], BEST)),
        cell("out", filled([1.0 / (pair.efficiency * pair.ratio) for pair in each], BEST)),
        cell("back", filled([pair.efficiency / pair.ratio for pair in each], BEST)),
        cell("own", filled([pair.no_load for pair in each], BEST)),
        cell("mixed", filled(mixed, BEST), scale=view.shaft.product),
        cell("square", filled(square, BEST), scale=view.shaft.torque**2),
        cell("rms", filled([pair.rms for pair in view.listed], BEST), scale=scale),
        cell("tp", filled(m.peak_torque[motors] / least, BEST)),
        cell("knee", filled(shown(m.knee[motors], RPM), BEST)),
        cell("fall", filled(shown(m.fall[motors] / least, PER_RPM), BEST)),
        cell("asked", filled(asked, BEST), scale=scale),
        cell("spare", filled([pair.spare for pair in view.listed], BEST), scale=scale),
    ]
