"""``python -m tests.mutation``: put faults into the templates' formulas, one at a time, and count what verify finds."""

import argparse
import os
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from itertools import chain, islice
from pathlib import Path

from rich.console import Console

from tests.mutation import looks, names
from tests.mutation.bench import Bench, smaller
from tests.mutation.examine import Tally, Verdict, examined, names_it_first
from tests.mutation.machines import machines
from tests.mutation.mutants import Mutant
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

Job = tuple[str, argparse.Namespace, int]  # description, options, which share of the mutants
Result = tuple[list[Verdict], list[tuple[Mutant, bool]]]


def options(arguments: list[str] | None = None) -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutation", description=__doc__)
    parser.add_argument("machines", nargs="*", default=list(TEMPLATES), metavar="MACHINE",
                        help="names of committed descriptions (default: the first of each template)")  # fmt: skip
    parser.add_argument("--all", action="store_true", help="every mutant of every cell, instead of a sample")
    parser.add_argument("--sample", type=int, default=3000, metavar="N", help="mutants a template (default 3000)")
    parser.add_argument("--seed", type=int, default=1, help="another sample, and other random machines")
    parser.add_argument("--values-only", action="store_true", help="leave the text of formulas aside")
    parser.add_argument("--whole", type=int, default=25, metavar="N",
                        help="ask all of verify about every N-th mutant, 0: about none (default 25)")  # fmt: skip
    parser.add_argument("--random", type=int, default=60, metavar="N",
                        help="random machines at which to look for survivors (default 60)")  # fmt: skip
    parser.add_argument("--names", type=int, default=20, metavar="N",
                        help="faults a template in names of blocks, columns and inputs (default 20 each)")  # fmt: skip
    parser.add_argument("--looks", type=int, default=80, metavar="N",
                        help="other number formats a template (default 80), beside labels, charts, parts")  # fmt: skip
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N", help="processes")
    parser.add_argument("--show", type=int, default=100, metavar="N", help="survivors to print (default 100)")
    return parser.parse_args(arguments)


def bench_of(name: str, **sizes: int) -> Bench:
    """Return the book of a committed description, with small tables."""
    machine = smaller(read_machine(FOLDER / f"{name}.toml"), **sizes)
    return Bench(TEMPLATES[machine.template], machine)


def work(job: Job) -> Result:
    """Judge one share of a template's mutants."""
    name, given, share = job
    bench = bench_of(name)
    mutants = bench.orchard.every() if given.all else bench.orchard.sample(given.sample, given.seed)
    mine = list(islice(mutants, share, None, given.jobs))
    elsewhere = [bench.inputs(m) for m in machines(bench.machine, given.random, given.seed)]
    verdicts = list(examined(bench, mine, elsewhere))
    asked = [v.mutant for v in verdicts[:: given.whole] if v.found(given.values_only)] if given.whole else []
    return verdicts, [(m, names_it_first(bench.verified(m, not given.values_only), m)) for m in asked]


def misnamed(job: Job) -> list[tuple[str, bool]]:
    """Judge one share of the faults in a template's names: each in words, and whether it is found."""
    name, given, share = job
    bench = bench_of(name, cycle=12, law=4)
    count = len(names.blocks(bench)) if given.all else given.names
    faults = chain(
        names.shifted(bench, names.blocks(bench), count, given.seed),
        names.shifted(bench, names.columns(bench), count, given.seed),
        islice(names.swapped(bench, given.seed), count),
    )
    return [(str(f), names.outcome(bench, f) != "agrees") for f in islice(faults, share, None, given.jobs)]


def misshown(job: Job) -> list[tuple[str, bool]]:
    """Judge faults in what a template's book shows, and how: each in words, and whether it is found."""
    name, given, _ = job
    with tempfile.TemporaryDirectory() as folder:
        return list(looks.outcomes(name, Path(folder), given.looks, given.seed))


def main() -> int:
    """Judge and print; exit code 1 if a mutant or a name survives, or another cell is named first."""
    given, console = options(), Console()
    jobs = [(name, given, share) for name in given.machines for share in range(given.jobs)]
    tally = Tally(given.values_only)
    with ProcessPoolExecutor(given.jobs) as pool:
        results = list(pool.map(work, jobs))
        renamed = list(chain.from_iterable(pool.map(misnamed, jobs)))
        shown = list(pool.map(misshown, [(name, given, 0) for name in given.machines]))
    tally.verdicts = list(chain.from_iterable(verdicts for verdicts, _ in results))
    tally.whole = list(chain.from_iterable(whole for _, whole in results))
    tally.show(console, given.show)
    lost = [words for words, found in renamed if not found]
    console.print(f"{len(renamed) - len(lost)} of {len(renamed)} faults in names are found", highlight=False)
    seen = list(chain.from_iterable(shown))
    unseen = [words for words, found in seen if not found]
    console.print(f"{len(seen) - len(unseen)} of {len(seen)} faults in what is shown, and how, are found",
                  highlight=False)  # fmt: skip
    lost += unseen
    for words in lost[: given.show]:
        console.print(f"Not found: {words}", highlight=False, markup=False, soft_wrap=True)
    return int(bool(tally.survivors or tally.not_first or lost))


if __name__ == "__main__":
    sys.exit(main())
