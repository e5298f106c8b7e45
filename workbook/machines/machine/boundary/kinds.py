"""What each step begins and ends with, in cells: velocities, accelerations, and their kinds by VDI 2143."""

from __future__ import annotations

from workbook.book.declare import Quantity, calc, constant, result
from workbook.machines.machine.boundary.handing import Handing

WORDS = "begin", "end"


def kinds(one: Handing) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and of the kinds of both."""
    at = one.rows.at
    peaks = [(f"peak{order}", f"INDEX([{at.phases}.{name}],[k])") for order, name in enumerate(at.peaks, 1)]
    each = one.of(lambda step: step.phase.y1_max), one.of(lambda step: step.phase.y2_max)
    return [
        constant("k", "row", "k", "", list(range(1, one.room + 1))),
        *(calc(name, f"greatest {word}, or 1", "", at.unit(order), f"=IF({peak}>0,{peak},1)",
               [value or 1.0 for value in values], scale=one.motion.size(order))
          for order, ((name, peak), word, values) in enumerate(
              zip(peaks, ("velocity", "acceleration"), each, strict=True), 1)),
        *rates(one), *settled(one),
        *(result(f"{word}s", f"kind of its {word}", "", "",
                 f'=IF(INDEX([{at.phases}.span],[k])=0,"",CHOOSE(1+[moves{i}]+2*[bends{i}],"R","G","U","B"))',
                 one.of(lambda step, i=i: step.kinds[i], ""), align="center",  # type: ignore[misc]
                 source="R rest, G velocity, U reversal, B both")
          for i, word in enumerate(WORDS)),
    ]  # fmt: skip


def rates(one: Handing) -> list[Quantity]:
    """Return the columns of what the law has at both ends."""
    at, size, motion = one.rows.at, one.motion.size, one.motion.ends
    no, rate = f"INDEX([{at.phases}.no],[k])", f"INDEX([{at.phases}.rate],[k])"

    def end(column: str) -> str:
        return f"INDEX([{at.ends}.{column}],[k])"

    def acceleration(i: int) -> str:
        return f"=(INDEX(law_a{i},{no})*{end(f'h{i}')}+{end(f'b{i}')})*{rate}^2"

    return [
        *(calc(f"v{i}", f"velocity at its {word}", "", at.unit(1),
               f"=INDEX(law_v{i},{no})*{end(f'h{i}')}*{rate}+{end(f'd{i}')}",
               one.spread([(found.begin, found.end)[i].y1 for found in motion]), scale=size(1))
          for i, word in enumerate(WORDS)),
        *(calc(f"a{i}", f"acceleration at its {word}", "", at.unit(2), acceleration(i),
               one.spread([(found.begin, found.end)[i].y2 for found in motion]), scale=size(2))
          for i, word in enumerate(WORDS)),
    ]  # fmt: skip


def settled(one: Handing) -> list[Quantity]:
    """Return the columns of whether a step moves, and whether it has an acceleration, where it begins and ends.

    What is asked for counts, where a neighbour or an entry settles it; else what the law has.
    """
    found = []
    for i, word in enumerate(WORDS):
        for name, what, own, asked, peak, letters in (
            ("moves", "has a velocity", "v", "w", 1, "GB"), ("bends", "has an acceleration", "a", "q", 2, "UB")
        ):  # fmt: skip
            rate = f"IF(INDEX([{one.asked}.settled{i}],[k])=1,INDEX([{one.asked}.{asked}{i}],[k]),[{own}{i}])"
            found.append(
                calc(f"{name}{i}", f"{what} at its {word}", "", "", f"=IF(ABS({rate})>check_zero*[peak{peak}],1,0)",
                     one.of(lambda step, i=i, letters=letters: int(step.kinds[i] in letters)),  # type: ignore[misc]
                     format="0")
            )  # fmt: skip
    return found
