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
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator
from contextlib import closing
from dataclasses import dataclass, field
from functools import cached_property, partial
from pathlib import Path
from typing import TypeVar

import numpy as np

from validation.stress.commands import damaged_through_commands, run, scenes_through_faces
from validation.stress.damage import damaged_input
from validation.stress.extreme import scene_input
from validation.stress.growth import FUNCTIONS, growth_of
from validation.stress.limits import ended
from validation.stress.mutation import drawn, outcomes
from validation.stress.tab import page_input
from validation.stress.watched import Input, Tried, tried
from validation.study import ROOT, markdown, out, write

Each = TypeVar("Each")
MOST_REFUSED = 0.8  # share of the inputs; with more, the draw tests little but the first check of a reader
ENOUGH = 40  # inputs for a share that means something


# How much each part does: inputs in one process, of each of scenes and damaged; scenes pasted into the page; runs of a
# command, likewise; mutants; one of so many combinations of situation and command; calls of friction_torque,
# solve_contact and each other function
LONG = {"inputs": 20_000, "pages": 20_000, "commands": 500, "mutants": 330, "every": 1, "calls": (10_000, 300, 300)}
SHORT = {"inputs": 20, "pages": 8, "commands": 2, "mutants": 0, "every": 60, "calls": (100, 6, 0)}
COUNTS = ("inputs", "pages", "commands", "mutants")  # that options change
HEAD = ("part", "first seed", "tries", "outcomes", "slowest, s", "largest, MB", "faults")


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
        return self.part, str(self.first_seed), str(self.outcomes.total()), told, *worst, str(len(self.faults))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", choices=[*PARTS, []], metavar="PARTS", help=", ".join(PARTS))
    parser.add_argument("--short", action="store_true", help="a part of everything, in two minutes")
    parser.add_argument("--seed", type=int, default=0, help="of the first input; each has its own")
    parser.add_argument("--jobs", type=int, default=1, help="processes for inputs and mutants")
    for name in COUNTS:
        parser.add_argument(f"--{name}", type=int, help=f"in place of {LONG[name]}, {SHORT[name]} short")
    parser.add_argument("--minutes", type=float, default=np.inf, help="a row ends then, with as many tries as it has")
    parser.add_argument("--out", type=Path, help="folder for stress.md and mutation.csv; nothing is written without it")
    parser.add_argument("--keep", type=Path, default=Path("stress-faults"), help="folder for inputs with a fault")
    options = parser.parse_args()
    for name, value in (SHORT if options.short else LONG).items():
        if getattr(options, name, None) is None:
            setattr(options, name, value)
    parts = options.parts or [part for part in PARTS if part != "mutation" or options.mutants]
    for package in ("analytic", "fembearing"):  # the commands keep no byte code, and would make it at each start
        compileall.compile_dir(ROOT / package, quiet=1)
    begun, rows = time.perf_counter(), []
    with tempfile.TemporaryDirectory() as folder:
        place = Place(Path(folder), options)
        for part in parts:
            for row in PARTS[part](place):
                row.first_seed = options.seed
                rows.append(row)
                for line in (" | ".join(row.cells), *(f"  {fault}" for fault in row.faults)):
                    out.print(line, soft_wrap=True)
                if options.out is not None:
                    write_page(rows, options.out)
    out.print(f"{sum(len(row.faults) for row in rows)} faults, {time.perf_counter() - begun:.0f} s")
    return int(any(row.faults for row in rows))


@dataclass
class Place:
    """Where and how much."""

    folder: Path
    options: argparse.Namespace

    def within_minutes(self, results: Generator[Each]) -> Iterator[Each]:
        """The results that come in time."""
        begun = time.monotonic()
        with closing(results):
            for each in results:
                yield each
                if time.monotonic() - begun > 60 * self.options.minutes:
                    return

    def rows(self, part: str, count: int, results: Callable[[range], Generator[Tried]]) -> Iterator[Row]:
        """The line of so many inputs; none without any."""
        if count:
            yield gathered(part, results(range(self.options.seed, self.options.seed + count)), self)

    def tries(self, make: Callable[[int], Input]) -> Callable[[range], Generator[Tried]]:
        """Inputs, each in the processes of --jobs."""
        return lambda seeds: tried(make, seeds, jobs=self.options.jobs)

    def through(self, commands: Callable[..., Generator[Tried]]) -> Callable[[range], Generator[Tried]]:
        """Inputs through commands, beside the memory of one that does little."""
        return lambda seeds: commands(seeds, self.folder, self.base)

    @cached_property
    def base(self) -> float:
        """Memory of a command that does little, bytes."""
        return run(("torque", "6205-dry"), self.folder).memory

    def keep(self, name: str, content: bytes) -> None:
        self.options.keep.mkdir(parents=True, exist_ok=True)
        (self.options.keep / name).write_bytes(content)


def scenes(place: Place) -> Iterator[Row]:
    yield from place.rows("scenes, one process", place.options.inputs, place.tries(scene_input))
    yield from place.rows("scenes, every face", place.options.commands, place.through(scenes_through_faces))


def damaged(place: Place) -> Iterator[Row]:
    make = partial(damaged_input, folder=place.folder)
    yield from place.rows("damaged, one process", place.options.inputs, place.tries(make))
    yield from place.rows("damaged, commands", place.options.commands, place.through(damaged_through_commands))


def paged(place: Place) -> Iterator[Row]:
    yield from place.rows("page, one process", place.options.pages, place.tries(page_input))


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
    for each in place.within_minutes(ended(every=place.options.every)):
        row.outcomes[each.outcome] += 1
        row.faults += [f"{each.situation}, {each.command}: {each.fault}"] if each.fault else []
    yield row


def growing(place: Place) -> Iterator[Row]:
    for number, function in enumerate(FUNCTIONS):
        if calls := place.options.calls[min(number, 2)]:
            done, gained = growth_of(function, calls, seconds=60 * place.options.minutes)
            fault = [] if gained < FUNCTIONS[function].most else [f"grows by {gained / 1e6:.1f} MB"]
            yield Row(f"growth, {function}", Counter(calls=done), fault, largest=max(gained, 0.0))


def mutated(place: Place) -> Iterator[Row]:
    row, options, table = Row("mutation"), place.options, []
    for each in place.within_minutes(outcomes(drawn(place.options.mutants, options.seed), jobs=options.jobs)):
        row.outcomes[each.outcome] += 1
        table.append(each.row)
        if each.outcome in ("survived", "error"):
            mutant = each.mutant
            row.faults.append(f"{each.outcome}: {mutant.module}:{mutant.line}, {mutant.before} -> {mutant.after}")
        if options.out is not None:
            write(table, options.out / "mutation.csv", list(table[0]))
    yield row


PARTS = {
    "scenes": scenes,
    "damaged": damaged,
    "page": paged,
    "limits": limited,
    "growth": growing,
    "mutation": mutated,
}


def write_page(rows: list[Row], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    faults = [f"- {row.part}: {' '.join(fault.split())}" for row in rows for fault in row.faults]
    lines = ["# Robustness", "", *markdown(HEAD, (row.cells for row in rows)), "", *(faults or ["No faults."])]
    (folder / "stress.md").write_text("\n".join(lines) + "\n", "utf-8")


if __name__ == "__main__":
    sys.exit(main())
