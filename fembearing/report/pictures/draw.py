"""Pictures of the contacts, made without a screen.

VTK draws them in a child process (`fembearing.report.pictures.render`), which also gives the numbers of the view that
turns in a browser. Where VTK cannot draw, there are no pictures, and the report says why.
"""

import json
import re
import subprocess
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from threading import Event, Timer
from typing import Any, Literal

from matplotlib.ticker import MaxNLocator

from analytic.processes import MODULE, environment
from analytic.units import MILLI, unit_for
from analytic.writing import write
from fembearing.check.contact.scene_contact import place_of
from fembearing.check.contact.solution import ContactSolution
from fembearing.report.page.view import view_page
from fembearing.report.phrases import AXES
from fembearing.report.pictures.framing import Frame, PressureScale, frame_of
from fembearing.report.report import PictureFile
from fembearing.report.sections.contacts import shoulder_lines, title_of

RENDERER = (*MODULE, "fembearing.report.pictures.render")
COLOURS = re.compile(r"\x1b\[[0-9;]*m")  # of a terminal, in what VTK says
PATIENCE = 300  # s for all pictures; they take about ten
LIFTED = 0.35  # of the ball's radius: how far it is drawn off the race

Kind = Literal["pressure", "section", "view"]


@dataclass(frozen=True, kw_only=True)
class Picture:
    """One picture in the report's folder."""

    file: Path
    kind: Kind
    contact: ContactSolution
    frame: Frame | None  # where the contact lies in it; a section is not to scale, a view turns
    caption: str

    @property
    def listed(self) -> PictureFile:
        """The picture as the document lists it."""
        contact = self.contact.numbers
        return PictureFile(
            file=self.file.name,
            kind=self.kind,
            pair=contact.pair,
            geometry=contact.geometry,
            caption=self.caption,
            bearing=contact.bearing,
        )


def draw_pictures(
    contacts: Sequence[ContactSolution],
    folder: Path,
    *,
    renderer: Sequence[str] = RENDERER,
    besides: Sequence[dict[str, Any]] = (),
    meanwhile: Callable[[], None] = lambda: None,
) -> tuple[list[Picture], str | None]:
    """Draw each contact's pressure, section and view into `folder`, its meshes into .vtu beside them.

    renderer : the command that draws; it reads the jobs from standard input
    besides : other jobs
    meanwhile : called while the renderer draws in a process of its own
    Gives the pictures; where VTK could not draw, none, and why.
    """
    jobs = [*(job for contact in contacts for job in contact_jobs(contact, folder)), *besides]
    with ThreadPoolExecutor(1) as beside:
        drawn = beside.submit(rendered, jobs, renderer)
        meanwhile()
        trouble = drawn.result()
    return [] if trouble else [
        picture for contact in contacts for picture in contact_pictures(contact, folder)
    ], trouble


def contact_pictures(contact: ContactSolution, folder: Path) -> Iterator[Picture]:
    """The pictures of one contact."""
    captions: dict[Kind, str] = {
        "pressure": _pressure_caption(contact),
        "section": _section_caption(contact),
        "view": _view_caption(contact),
    }
    for kind, caption in captions.items():
        frame = _frame(contact) if kind == "pressure" else None
        yield Picture(file=_file(contact, kind, folder), kind=kind, contact=contact, frame=frame, caption=caption)


def rendered(jobs: list[dict[str, Any]], renderer: Sequence[str]) -> str | None:
    """Run the renderer on all jobs; None, or one line on why it did not draw them all."""
    try:
        ended = _run(renderer, f"{json.dumps(jobs)}\n".encode())
    except OSError as problem:
        return f"the renderer could not be started: {problem.strerror}"
    if ended is None:
        return f"VTK did not finish within {PATIENCE} s"
    status, said = ended
    if status == 0 and all(Path(job["file"]).is_file() for job in jobs):
        for file in (Path(job["file"]) for job in jobs if job["kind"] == "view"):
            write(file, view_page(json.loads(file.read_bytes())))
        return None
    for job in jobs:
        Path(job["file"]).unlink(missing_ok=True)  # all pictures, or none
    how = f"signal {-status}" if status < 0 else f"status {status}"
    return f"VTK ended with {how}" + (f": {said[-1]}" if said else "")


def _run(renderer: Sequence[str], jobs: bytes) -> tuple[int, list[str]] | None:
    """Status of a renderer, and the lines that it wrote on standard error; None: it took too long.

    Its standard input stays open until it ends: by its end a renderer knows that this process was killed.
    """
    late = Event()
    with subprocess.Popen(
        renderer,
        env=environment(),
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        bufsize=0,
    ) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        limit = Timer(PATIENCE, lambda: (late.set(), process.kill()))
        limit.start()
        try:
            with suppress(BrokenPipeError):  # it ended without reading them
                process.stdin.write(jobs)
            said = process.stderr.read().decode("utf-8", "replace")
            status = process.wait()
        finally:
            limit.cancel()
            process.kill()
    return None if late.is_set() else (status, COLOURS.sub("", said).strip().splitlines())


def contact_jobs(contact: ContactSolution, folder: Path) -> list[dict[str, Any]]:
    """What the renderer draws of one contact: pressure, section and view."""
    meshes = {side: str(path) for side, path in contact.write_meshes(folder).items()}
    found, shoulder = contact.numbers, contact.numbers.shoulder
    common = {
        **meshes,
        **_scale(contact)._asdict(),
        "title": _title(contact),
        "hertz": [found.hertz.semi_axis_rolling, found.hertz.semi_axis_transverse],
        "computed": [found.reference.semi_axis_rolling, found.reference.semi_axis_transverse],
        "centroid": 0.0 if shoulder is None else shoulder.centroid.reference,
        "shoulders": [] if shoulder is None else shoulder.cuts,
        "half": contact.meshes[-1].pair.footprint.half,
    }
    near = "The pocket" if contact.contact.pair == "pocket" else "The race"
    return [
        {
            **common,
            "kind": "pressure",
            "file": str(_file(contact, "pressure", folder)),
            "frame": asdict(_frame(contact)),
        },
        {
            **common,
            "kind": "section",
            "file": str(_file(contact, "section", folder)),
            "near": f"{near} near the contact",
            "lifted": _lifted(contact),
        },
        {**common, "kind": "view", "file": str(_file(contact, "view", folder))},
    ]


def _title(contact: ContactSolution) -> str:
    found = contact.numbers
    return title_of(found.pair, found.geometry, found.contact_angle, f"{found.load:.4g} N", found.bearing)


def _place(contact: ContactSolution) -> str:
    return place_of(contact.numbers.pair, contact.numbers.geometry, contact.numbers.bearing)


def _lifted(contact: ContactSolution) -> float:
    """How far the ball is drawn off what it touches, m: no farther than half the width of that."""
    return min(LIFTED * contact.contact.ball_radius, float(contact.meshes[-1].pair.lower.mesh.doflocs[1].max()))


def _file(contact: ContactSolution, kind: Kind, folder: Path) -> Path:
    return folder / f"{contact.stem}-{kind}.{'html' if kind == 'view' else 'png'}"


def _frame(contact: ContactSolution) -> Frame:
    """Room for both ellipses."""
    both = contact.numbers.hertz, contact.numbers.reference
    return frame_of(
        semi_axis_rolling=max(part.semi_axis_rolling for part in both),
        semi_axis_transverse=max(part.semi_axis_transverse for part in both),
    )


def _scale(contact: ContactSolution) -> PressureScale:
    """Colours up to the computed peak, with round ticks."""
    peak = contact.numbers.reference.peak_pressure
    unit, factor, _ = unit_for("Pa", peak)
    ticks = MaxNLocator(5).tick_values(0, peak * factor)
    return PressureScale(unit, factor, peak * factor, [float(tick) for tick in ticks if tick <= peak * factor])


def _pressure_caption(contact: ContactSolution) -> str:
    """What the pressure picture shows, and how far Hertz's ellipse is off."""
    across = contact.numbers.quantities["semi_axis_transverse"].difference
    return (
        f"Contact pressure by finite elements, seen along the load and drawn to scale, {_place(contact)}. "
        f"Grey: mesh. Red: Hertz's ellipse, transverse semi-axis {abs(across):.1%} "
        f"{'larger' if across > 0 else 'smaller'} than the computed one (black). The painted edge is as sharp as one "
        f"cell. {_shoulder_caption(contact)}{AXES}."
    )


def _shoulder_caption(contact: ContactSolution) -> str:
    """What a shoulder does to the contact; empty where it ends before it."""
    if contact.numbers.shoulder is None:
        return ""
    lines = " ".join(shoulder_lines(contact.numbers))
    return f"{lines} Orange: the shoulder; the black ellipse has the semi-axes of the load about its centroid. "


def _section_caption(contact: ContactSolution) -> str:
    """What the section shows, and what is not to scale in it."""
    body = "pocket" if contact.contact.pair == "pocket" else "race"
    return (
        f"The meshed bodies cut along the plane x = 0, {_place(contact)}. Left: the ball, drawn "
        f"{MILLI.written(_lifted(contact), '.2g')} off its {body}. Right: the loaded part of the {body}; the cells "
        "follow the contact's ellipse and shrink towards its edge."
    )


def _view_caption(contact: ContactSolution) -> str:
    """How to turn the view, and what it shows."""
    body = "pocket" if contact.contact.pair == "pocket" else "race"
    return (
        f"Rotatable view, {_place(contact)}: drag it, or click it and use arrow keys and wheel. Both loaded surfaces "
        f"to scale, not deformed: from above the {body} is solid and the ball clear, from below the reverse. Nodes "
        "with a pressure: corners of the cells, middles of their sides and faces. Colours and lines as in the still "
        "picture above."
    )
