"""The phases of a composed motion: what is entered, what each comes to, and the workings."""

from __future__ import annotations

from collections.abc import Iterable

from workbook.book.declare import Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.entries.phase import AT_REST
from workbook.laws import phases as joined
from workbook.machines.composer.view import Composition
from workbook.motion.cells import PieceRows
from workbook.motion.ends import Ends
from workbook.motion.pieces import phase_columns
from workbook.motion.through import entries

PER, PER2, PER3 = "lift/x", "lift/x²", "lift/x³"  # units, which the engineer names: in the headers they stand as words


def phases(sheet: Sheet, machine: Composition, rows: PieceRows, handed: Ends | None) -> None:
    """Declare the phases: what is entered, what each comes to, and to the right the workings."""
    motion, n = machine.motion, machine.sizes.phases
    entered, edges = machine.given.phases, machine.motion.edges
    laws, lifts = [p.law for p in entered], [p.lift for p in entered]
    moved, (h, v, a, _) = motion.phases, motion.sizes
    spans = [p.duration for p in moved]
    begins, ends = zip(*motion.ends, strict=True)
    reached = motion.position + motion.lifts_sum
    lows, highs = zip(*motion.reaches, strict=True)

    def of(values: Iterable[float]) -> list[float]:
        return filled(values, n)

    lacking, reaching = "=[h]*(1-INDEX(law_s1,[no]))", "=[y0]+[h]*INDEX(law_s1,[no])"
    if handed:
        lacking, reaching = handed.other(lacking, "0"), handed.other(reaching, "[y0]+[h]")

    velocities, accelerations = (
        filled([getattr(p, name) for p in entered], n, None) for name in ("velocity", "acceleration")
    )
    passing = entries(velocities, accelerations, "motion.phases.*", (PER, PER2))
    spare = '[duration]=""' if handed else '[kind]="spare"'

    def own(column: str, formula: str) -> str:
        return handed.own(column, formula) if handed else formula

    def at_end(derivative: str, end: int, power: str) -> str:
        if handed is None:
            return joined.AT_END.format(f"{derivative}{end}", power)
        return f"=IF([span]>0,{handed.at_end(derivative, end)},0)"

    sheet.table(
        "phases", "Fill one row each, in order; leave spare rows empty", n,
        calc("kind", "phase", "", "", joined.kind("duration", rows.at.ends), joined.kinds(motion.phases, n)),
        given("law", "law", "", "", filled(laws, n, None), "motion.phases.*.law", choices="=law_code"),
        given("lift", "lift", "h", "", filled(lifts, n, None), "motion.phases.*.lift", format="0.0####"),
        given("duration", "duration", "δ", "x",
              filled(spans, n, None), "motion.phases.*.duration", format="0.0####"),
        result("end", "ends at", "", "x",
               "=[begin]+[span]", filled(edges[1:], n, motion.total), format="0.0####", scale=motion.total,
               source="begin + δ"),
        result("y1", "position at its end", "y", "lift",
               reaching, filled([end.y for end in ends], n, reached), format="0.0####", scale=h,
               source="y_0 + h s(1)"),
        *(passing if handed else []),
        *(handed.kinds() if handed else []),
        result("v", "greatest velocity", "y'max", PER,
               own("vmax", joined.VELOCITY), of(p.y1_max for p in moved), scale=v, source="C_v h/δ"),
        result("a", "greatest acceleration", "y''max", PER2,
               own("amax", joined.ACCELERATION), of(p.y2_max for p in moved), scale=a, source="C_a h/δ²"),
        result("j", "greatest jerk", "y'''max", PER3,
               own("jmax", joined.JERK), joined.jerks(of(p.y3_max for p in moved)), scale=motion.size(3),
               source="C_j h/δ³"),
        result("rms", "RMS acceleration", "y''rms", PER2,
               own("rms", f"={joined.RMS}"), of(p.y2_rms for p in moved), scale=a, source="C_a,rms h/δ²"),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "", joined.LAW_NUMBER, joined.law_numbers(laws, machine.laws, n), format="0"),
        calc("h", "lift used", "h", "lift",
             f"=IF({spare},0,[lift]+0)", of(lifts), scale=h, source="0 if empty"),
        calc("span", "duration used", "δ", "x",
             f"=IF({spare},0,[duration])", of(spans), scale=motion.total, source="0 if spare"),
        calc("begin", "begins at", "", "x",
             "=IF([k]=1,0,[end-1])", filled(edges[:-1], n, motion.total), scale=motion.total, source="end before"),
        calc("y0", "start position", "y_0", "lift",
             "=IF([k]=1,move_start,[y0-1]+[h-1])", filled([begin.y for begin in begins], n, reached), scale=h,
             source="lifts before"),
        *(calc(name, f"{word} position", "", "lift",
               own(name, formula.format("move_start")), filled(values, n, motion.position),
               scale=h)
          for name, word, formula, values in (("low", "lowest", joined.LOW, lows),
                                              ("high", "highest", joined.HIGH, highs))),
        calc("lack", "lack of lift", "Δy", "lift",
             lacking, of(p.lack for p in moved), scale=h,
             source="h (1 − s(1))"),
        calc("v0", "y' at its start", "", PER,
             at_end("v", 0, ""), of(begin.y1 for begin in begins), scale=v),
        calc("v1", "y' at end", "", PER,
             at_end("v", 1, ""), of(end.y1 for end in ends), scale=v),
        calc("a0", "y'' at its start", "", PER2,
             at_end("a", 0, "^2"), of(begin.y2 for begin in begins), scale=a),
        calc("a1", "y'' at end", "", PER2,
             at_end("a", 1, "^2"), of(end.y2 for end in ends), scale=a),
        *phase_columns(rows),
        rules=[AT_REST],
    )  # fmt: skip
