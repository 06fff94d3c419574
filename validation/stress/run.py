"""Does anything get through? python validation/stress/run.py [--short] [PARTS]

    scenes    extreme but valid scenes: their torque in this process, and through every command of a scene
    damaged   damaged scenes, grids, height maps and meshes, in this process and through commands
    limits    memory, file size, full disk, permissions, home, locale, streams, files that are none
    page      extreme and damaged scenes in the page of `fembearing app`
    growth    memory of a process after many calls
    mutation  one operator of the source changed at a time: do the tests of its folder see it?

Without PARTS all run, for hours; with --short all but mutation, in two minutes. Prints a table, and writes it to
stress.md in the folder --out, beside mutation.csv. Faults are printed with the seed that makes them again, and inputs
that led to one are kept in the folder --keep. Exit status: 0 no fault, 1 a fault.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy loads its threads

import argparse
import compileall
import csv
import shlex
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator
from contextlib import closing
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TypeVar

import numpy as np

from validation.stress.commands import ROOT, run
from validation.stress.damage import Files
from validation.stress.extreme import scene_input
from validation.stress.faces import damaged_through_commands, scenes_through_faces
from validation.stress.growth import FUNCTIONS, growth_of
from validation.stress.limits import ended
from validation.stress.mutation import drawn, outcomes
from validation.stress.tab import page_input
from validation.stress.watched import Input, Tried, tried

Each = TypeVar("Each")
MOST_REFUSED = 0.8  # share of the inputs; with more, the draw tests little but the first check of a reader
ENOUGH = 40  # inputs for a share that means something


@dataclass(frozen=True)
class Budget:
    """How much each part does."""

    inputs: int  # in one process, of each of scenes and damaged
    pages: int  # scenes pasted into the page
    commands: int  # runs of a command, likewise
    every: int  # of the combinations of situation and command, one of so many
    calls: tuple[int, int, int]  # of friction_torque, solve_contact and each other function
    mutants: int


LONG = Budget(inputs=20_000, pages=20_000, commands=500, every=1, calls=(10_000, 300, 300), mutants=330)
SHORT = Budget(inputs=20, pages=8, commands=2, every=60, calls=(100, 6, 0), mutants=0)


@dataclass
class Row:
    """One line of the table."""

    part: str
    outcomes: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    slowest: float = 0.0  # s of the processor
    largest: float = 0.0  # bytes above the base
    first_seed: int = 0

    @property
    def cells(self) -> tuple[str, ...]:
        told = ", ".join(f"{count} {outcome}" for outcome, count in sorted(self.outcomes.items()))
        worst = (f"{self.slowest:.1f}" if self.slowest else "", f"{self.largest / 1e6:.0f}" if self.largest else "")
        tries = (str(self.first_seed), str(self.outcomes.total()), told)
        return self.part, *tries, *worst, str(len(self.faults))


COUNTS = ("inputs", "pages", "commands", "mutants")  # of a budget, which options change
HEAD = ("part", "first seed", "tries", "outcomes", "slowest, s", "largest, MB", "faults")


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", choices=[*PARTS, []], metavar="PARTS", help=", ".join(PARTS))
    parser.add_argument("--short", action="store_true", help="a part of everything, in two minutes")
    parser.add_argument("--seed", type=int, default=0, help="of the first input; each has its own")
    parser.add_argument("--jobs", type=int, default=1, help="processes for inputs and mutants")
    for name in COUNTS:
        parser.add_argument(
            f"--{name}", type=int, help=f"in place of {getattr(LONG, name)}, {getattr(SHORT, name)} short"
        )
    parser.add_argument("--functions", nargs="*", choices=[*FUNCTIONS], help="of growth; all without it")
    parser.add_argument("--minutes", type=float, default=np.inf, help="a row ends then, with as many tries as it has")
    parser.add_argument("--before", default="", help="what the tests of a mutant are started by, as 'nice -n 15'")
    parser.add_argument("--out", type=Path, help="folder for stress.md and mutation.csv; nothing is written without it")
    parser.add_argument("--keep", type=Path, default=Path("stress-faults"), help="folder for inputs with a fault")
    options = parser.parse_args(argv)
    size = SHORT if options.short else LONG
    given = {name: getattr(options, name) for name in COUNTS}
    budget = Budget(**vars(size) | {name: value for name, value in given.items() if value is not None})
    parts = options.parts or [part for part in PARTS if part != "mutation" or budget.mutants]
    for package in ("analytic", "fembearing"):  # the commands keep no byte code, and would make it at each start
        compileall.compile_dir(ROOT / package, quiet=1)
    begun, rows = time.perf_counter(), []
    with tempfile.TemporaryDirectory() as folder:
        place = Place(Path(folder), options, budget)
        for part in parts:
            for row in PARTS[part](place):
                row.first_seed = options.seed
                rows.append(row)
                say(" | ".join(row.cells), *(f"  {fault}" for fault in row.faults))
                if options.out is not None:
                    write(rows, options.out)
    say(f"{sum(len(row.faults) for row in rows)} faults, {time.perf_counter() - begun:.0f} s")
    return int(any(row.faults for row in rows))


def say(*lines: str) -> None:
    sys.stdout.writelines(f"{line}\n" for line in lines)
    sys.stdout.flush()


@dataclass
class Place:
    """Where and how much."""

    folder: Path
    options: argparse.Namespace
    budget: Budget

    def within_minutes(self, results: Generator[Each]) -> Iterator[Each]:
        """The results that come in time."""
        begun = time.monotonic()
        with closing(results):
            for each in results:
                yield each
                if time.monotonic() - begun > 60 * self.options.minutes:
                    return

    def seeds(self, count: int) -> range:
        """Those of so many inputs."""
        return range(self.options.seed, self.options.seed + count)

    def tries(self, make: Callable[[int], Input], count: int) -> Generator[Tried]:
        """So many inputs, each in the processes of --jobs."""
        return tried(make, self.seeds(count), jobs=self.options.jobs)

    @cached_property
    def base(self) -> float:
        """Memory of a command that does little, bytes."""
        return run(("torque", "6205-dry"), self.folder).memory

    def keep(self, name: str, content: bytes) -> None:
        self.options.keep.mkdir(parents=True, exist_ok=True)
        (self.options.keep / name).write_bytes(content)


def scenes(place: Place) -> Iterator[Row]:
    if place.budget.inputs:
        yield gathered("scenes, one process", place.tries(scene_input, place.budget.inputs), place)
    if place.budget.commands:
        found = scenes_through_faces(place.seeds(place.budget.commands), place.folder, place.base)
        yield gathered("scenes, every face", found, place)


def damaged(place: Place) -> Iterator[Row]:
    files = Files(place.folder)
    if place.budget.inputs:
        yield gathered("damaged, one process", place.tries(files.input, place.budget.inputs), place)
    if place.budget.commands:
        found = damaged_through_commands(place.seeds(place.budget.commands), files, place.base)
        yield gathered("damaged, commands", found, place)


def paged(place: Place) -> Iterator[Row]:
    if place.budget.pages:
        yield gathered("page, one process", place.tries(page_input, place.budget.pages), place)


def gathered(part: str, results: Generator[Tried], place: Place) -> Row:
    row = Row(part)
    for each in place.within_minutes(results):
        row.outcomes["faults" if each.is_fault else each.outcome] += 1
        row.slowest, row.largest = max(row.slowest, each.seconds), max(row.largest, each.memory)
        if each.is_fault:
            row.faults.append(f"seed {each.seed}, {each.kind}: {each.outcome}")
            place.keep(f"{each.seed}-{each.kind.replace(' ', '-')}", each.content)
    refused, tries = row.outcomes["refused"], row.outcomes.total()
    if tries >= ENOUGH and refused > MOST_REFUSED * tries:
        row.faults.append(f"{100 * refused / tries:.0f} % are refused: the draw tests little else")
    return row


def limited(place: Place) -> Iterator[Row]:
    row = Row("limits")
    for each in place.within_minutes(ended(every=place.budget.every)):
        row.outcomes[each.outcome] += 1
        row.faults += [f"{each.situation}, {each.command}: {each.fault}"] if each.fault else []
    yield row


def growing(place: Place) -> Iterator[Row]:
    chosen = place.options.functions or FUNCTIONS
    for number, function in enumerate(FUNCTIONS):
        calls = place.budget.calls[min(number, 2)]
        if calls == 0 or function not in chosen:
            continue
        done, gained = growth_of(function, calls, seconds=60 * place.options.minutes)
        fault = [] if gained < FUNCTIONS[function].most else [f"grows by {gained / 1e6:.1f} MB"]
        yield Row(f"growth, {function}", Counter(calls=done), fault, largest=max(gained, 0.0))


def mutated(place: Place) -> Iterator[Row]:
    row, options, table = Row("mutation"), place.options, []
    chosen = drawn(place.budget.mutants, options.seed)
    for each in place.within_minutes(outcomes(chosen, jobs=options.jobs, before=shlex.split(options.before))):
        row.outcomes[each.outcome] += 1
        table.append(each.row)
        if each.outcome in ("survived", "error"):
            mutant = each.mutant
            row.faults.append(f"{each.outcome}: {mutant.module}:{mutant.line}, {mutant.before} -> {mutant.after}")
        if options.out is not None:
            options.out.mkdir(parents=True, exist_ok=True)
            with (options.out / "mutation.csv").open("w", newline="") as file:
                writer = csv.DictWriter(file, list(table[0]))
                writer.writeheader()
                writer.writerows(table)
    yield row


PARTS = {
    "scenes": scenes,
    "damaged": damaged,
    "page": paged,
    "limits": limited,
    "growth": growing,
    "mutation": mutated,
}


def write(rows: list[Row], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    table = [HEAD, ["---"] * len(HEAD), *(row.cells for row in rows)]
    faults = [f"- {row.part}: {' '.join(fault.split())}" for row in rows for fault in row.faults]
    lines = ["# Robustness", "", *(f"| {' | '.join(cells)} |" for cells in table), "", *(faults or ["No faults."])]
    (folder / "stress.md").write_text("\n".join(lines) + "\n", "utf-8")


if __name__ == "__main__":
    sys.exit(main())
