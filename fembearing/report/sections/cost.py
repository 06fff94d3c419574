"""What accuracy costs: error, bound and price of each method, as a table and as a file for other programs."""

import csv
from collections.abc import Iterator, Sequence
from dataclasses import asdict, fields
from io import StringIO
from itertools import groupby
from operator import itemgetter

from fembearing.check.cost.ladder import Ladder, Method
from fembearing.report.document import Group, Head, Row, Section, Table, Text
from fembearing.report.phrases import capital, shown
from fembearing.report.report import Report

DIGITS = (0.1, 0.01, 0.001, 0.0001)  # tolerances whose choices are shown, whatever the tolerance
HEADS = (
    Head("method", "name"),
    *(
        Head(name, fixed=True, wide=name == "spread")
        for name in ("error", "bound", "seconds", "spread", "first", "GiB")
    ),
    Head("unknowns", wide=True),
)
NOTE = (
    ">: the cheapest method known to be within the tolerance. FE: finite elements. Bound: on the error, known without "
    "the reference. Seconds: median of the repeats; first: the call before them; GiB: largest resident memory."
)


def cost_table(ladders: Sequence[Ladder]) -> Table:
    """A group for each quantity, a row for each method."""
    groups = [Group([*map(_row, each.methods)], capital(each.quantity), [*_notes(each)]) for each in ladders]
    return Table("Methods", HEADS, groups, [NOTE])


def cost_section(document: Report) -> Section:
    """The ladders of a check."""
    ran, whole = "" if document.cost.measured else ", and each method ran once", document.cost.seconds
    words = (
        "Error of a contact: the worst of semi-axes, peak pressure and approach, against the extrapolated values of "
        f"the same contact, whose uncertainty the appendix on meshes gives. Times exclude the sizing of the mesh{ran}. "
        f"The whole check took {whole:.1f} s."
    )
    return Section("Cost of accuracy", [cost_table(document.cost.ladders), Text(words, quiet=True)])


def cost_csv(ladders: Sequence[Ladder]) -> str:
    """Every method as a line of comma-separated values, SI, errors relative; an absent ladder with its reason."""
    text = StringIO()
    columns = [part.name for part in fields(Method)]
    writer = csv.DictWriter(text, ("quantity", "reference", *columns), restval="", lineterminator="\n")
    writer.writeheader()
    for ladder in ladders:
        of = {"quantity": ladder.quantity, "reference": ladder.reference}
        writer.writerows(of | asdict(method) for method in ladder.methods)
        if ladder.absent is not None:
            writer.writerow(of | {"reference": f"absent: {ladder.absent}"})
    return text.getvalue()


def short_name(method: str) -> str:
    """The name of a method for narrow places."""
    return method.replace("finite elements, ", "FE, ").replace("corrected for finite geometry", "corrected")


def _row(method: Method) -> Row:
    return [
        f"{'> ' if method.chosen else ''}{short_name(method.name)}",
        "failed" if method.failed else shown(method.error, ".2g", 100, " %", absent="reference"),
        shown(method.bound, ".2g", 100, " %", absent=""),
        shown(method.seconds, ".2g", absent=""),
        shown(method.spread, ".1g", absent=""),
        shown(method.warm_up, ".1g", absent=""),
        shown(method.memory, ".2f", 2**-30, absent=""),
        str(method.unknowns or ""),
    ]


def _notes(ladder: Ladder) -> Iterator[str]:
    if ladder.absent is not None:
        yield f"Does not apply: {ladder.absent}."
        return
    yield from (f"{method.name} failed: {method.failed}" for method in ladder.methods if method.failed)
    yield f"Price of the next digit: {'; '.join(_prices(ladder))}."
    yield f"Reference: {ladder.reference}."


def _prices(ladder: Ladder) -> Iterator[str]:
    """Which method each of DIGITS takes, and how many times as much as the one before."""
    before = None
    for method, run in groupby(((digit, ladder.cheapest(digit)) for digit in DIGITS), key=itemgetter(1)):
        tolerances = ", ".join(f"{100 * digit:g}" for digit, _ in run)
        if method is None or method.seconds is None:
            yield f"{tolerances} %: none"
            return
        more = "" if before is None else f", {method.seconds / before:.2g} times as much"
        yield f"{tolerances} %: {short_name(method.name)}, {method.seconds:.2g} s{more}"
        before = method.seconds
