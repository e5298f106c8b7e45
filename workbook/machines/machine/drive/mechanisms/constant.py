"""A mechanism of a constant ratio in cells: its size, and its ratio."""

from workbook.book.declare import Quantity, calc, given
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.mechanism import Belted

RATIOS = {"lead": ("P_h", "=2*PI()/(@lead/1000)", "2π/P_h"), "roller_radius": ("R", "=1/(@roller_radius/1000)", "1/R")}
"""of the entry that sets the ratio: its symbol, the ratio in cells and in words; of all others 2/D"""


def ratio_of(size: str) -> tuple[str, str, str]:
    """Return the symbol, the formula and the equation of a ratio by the entry that sets it."""
    return RATIOS.get(size, ("D", f"=2/(@{size}/1000)", "2/D")) if size else ("", "=1", "the load turns with it")


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the row of the mechanism's size, if it has one, and of its belt."""
    m, key = driven.given, f"{key}.mechanism"
    label, symbol = type(m).model_fields[m.SIZE or "kind"].title or "", ratio_of(m.SIZE)[0]
    rows = [given(f"@{m.SIZE}", label, symbol, "mm", m.size, f"{key}.{m.SIZE}", format="0.0##")] if m.SIZE else []
    if isinstance(m, Belted):
        rows.append(given("@belt_mass", "Mass of the belt", "m_b", "kg", m.belt_mass, f"{key}.belt_mass",
                          format="0.0##", source="moves with the load; its own weight balances itself"))  # fmt: skip
    return rows


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios."""
    travels, m = driven.axis.base == "m", driven.mechanism
    _, ratio, equation = ratio_of(driven.given.SIZE)
    return [
        calc("@i2", "Ratio of the mechanism", "i_2", "rad/m" if travels else "", ratio, m.ratio_from(1),
             source=equation),
        calc("@i", "Ratio from motor to load", "i_tot", "rad/m" if travels else "", "=@i1*@i2", m.ratio,
             source="i_1 i_2"),
    ]  # fmt: skip
