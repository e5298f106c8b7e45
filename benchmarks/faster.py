"""The highest rate of machines as they are, with the best laws, the best timing and both, as a table of the docs.

Each is built at the rate that it reaches and verified there: what does not agree, and checks that fail, stand below.
"""

import sys
import tempfile
from pathlib import Path

from workbook.build import build
from workbook.description.editing import edit_text
from workbook.judging.verify import verify
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import read_machine
from workbook.studies.design import RATE, Design, first_design
from workbook.studies.improve import STAGES, better
from workbook.templates import TEMPLATES

NAMES = ("cutting-machine", "machine", "crank-press", "machine-linkages")
TRIED = {name: stage for name, stage in STAGES.items() if name != "motors"}


def confirmed(design: Design, path: Path, rate: float, folder: Path) -> list[str]:
    """Build the book of a design at a rate and verify it; return a line for each finding and check that fails."""
    text = edit_text(path.read_text("utf-8"), {**design.changes, RATE: rate}.items())
    description = folder / path.name
    description.write_text(text, encoding="utf-8")
    failing = build(read_machine(description), book := description.with_suffix(".xlsx"), overwrite=True)
    return [*map(str, verify(book).findings), *failing]


def main(names: list[str]) -> None:
    print(f"| template | highest rate | {' | '.join(f'best {words}' for words, *_ in TRIED.values())} |")
    print(f"|---|{'---|' * (1 + len(TRIED))}")
    remarks = []
    with tempfile.TemporaryDirectory() as folder:
        for name in names or NAMES:
            path = TEMPLATES["machine"].description.with_name(f"{name}.toml")
            best = {"": first_design(read_machine(path))}
            for stage, (_, kinds, begin) in TRIED.items():
                best[stage] = best[begin]
                for other in better(best[begin], kinds, THIS_PROCESS, lambda *_: None):
                    best[stage] = other
            rates = {stage: design.rate_to_write for stage, design in best.items()}
            before = rates[""]
            cells = [f"{rate:.1f}" + (f" ({rate / before - 1:+.1%})" if stage else "") for stage, rate in rates.items()]
            print(f"| {name} | {' | '.join(cells)} |", flush=True)
            for stage, design in best.items():
                for line in confirmed(design, path, rates[stage], Path(folder)):
                    remarks.append(f"{name}, {stage or 'as it is'}: {line}")
    print(*remarks or ["", "All agree, and all checks hold."], sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
