"""What `run.py` measures, and the process that measures it in one tree: python -P jobs.py TREE

The process reads names of jobs, one a line, and answers each with a line of JSON: wall and processor seconds of one
call, and the result, by which two trees are compared. PYTHONPATH decides which tree is imported. The jobs use what
every commit offers that is still compared, or the form that an older one has.
"""

import json
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import count
from pathlib import Path
from typing import Any, Literal

LEAST = 0.05  # s, of one timing: shorter calls are repeated within it
LONG = 10.0  # s; a series that takes longer is not lengthened, and its time is extrapolated
FEW, GROWTH = 10, 5  # points
POINTS = 100_000  # of a series
LOAD, SPEED = 1000.0, 52.0  # N, rad/s
SEED = 5
CAGE_TIME = 0.02  # s of motion
STATED = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")


@dataclass(frozen=True, kw_only=True)
class Work:
    """A call to be timed, and what its seconds mean."""

    call: Callable[[], float]  # returns the result
    share: float = 1.0  # the figure is this times the seconds of a call
    note: Callable[[], str] = str  # on the last call


@dataclass(frozen=True, kw_only=True)
class Job:
    """A figure that is measured within a process."""

    title: str
    work: Callable[[Path], Work]  # of the tree in this folder
    goal: float | None = None  # s
    clock: Literal["cpu", "wall"] = "cpu"  # wall for jobs on several processes
    fresh: bool = False  # whether each call is the first of its process
    once: bool = False  # too long to be repeated
    short: bool = False  # whether the short form measures it


def main() -> None:
    tree = Path(sys.argv[1])
    ready: dict[str, tuple[Work, int]] = {}
    for line in sys.stdin:
        name = line.strip()
        try:
            if name not in ready:
                ready[name] = repeated(JOBS[name], tree)
            answer = timed(*ready[name])
        except Exception as problem:  # an older tree may lack what a job needs: its row says so
            answer = {"failed": f"{type(problem).__name__}: {problem}".splitlines()[0]}
        sys.stdout.write(json.dumps(answer) + "\n")
        sys.stdout.flush()


def repeated(job: Job, tree: Path) -> tuple[Work, int]:
    """The work and the number of its calls in one timing; warm, unless its first call is the figure."""
    import analytic

    if not Path(analytic.__file__).is_relative_to(tree):
        raise RuntimeError(f"analytic comes from {analytic.__file__}, not from {tree}")
    work = job.work(tree)
    if job.fresh or job.once:
        return work, 1
    work.call()
    started = time.perf_counter()
    work.call()
    return work, max(1, round(LEAST / max(time.perf_counter() - started, 1e-7)))


def timed(work: Work, number: int) -> dict[str, Any]:
    result, wall, cpu = 0.0, time.perf_counter(), time.process_time()
    for _ in range(number):
        result = work.call()
    cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
    share = work.share / number
    return {"wall": wall * share, "cpu": cpu * share, "result": float(result), "note": work.note()}


def scene_file(tree: Path, name: str) -> Path:
    return tree / "validation" / "scenes" / f"{name}.toml"


def dry_file(tree: Path) -> Path:
    """The built-in 6205 with a given friction coefficient, which was once named 6205."""
    folder = tree / "analytic" / "catalog" / "scenes"
    return next(file for file in (folder / "6205-dry.toml", folder / "6205.toml") if file.exists())


def dry(tree: Path) -> Any:
    """The scene without its cage, balls by rule."""
    from dataclasses import replace

    from analytic import load_scene

    return replace(load_scene(dry_file(tree)), cage=None, spin_rule="balanced")


def oiled(name: str, tree: Path, *, spin_rule: str = "balanced") -> Any:
    from dataclasses import replace

    from analytic import load_scene

    return replace(load_scene(scene_file(tree, name)), spin_rule=spin_rule)


def point(scene_of: Callable[[Path], Any], tree: Path, *, radial: float = 0.0) -> Work:
    """The torque at one operating point."""
    from analytic import friction_torque

    scene = at(scene_of(tree), [LOAD], [SPEED], radial=radial)
    return Work(call=lambda: friction_torque(scene).torque.total[0])


def called(scene_of: Callable[[Path], Any], tree: Path, *, radial: float = 0.0) -> Work:
    """The torque at one operating point by the callable for a time step."""
    from analytic import torque_function

    torque = torque_function(scene_of(tree))
    return Work(call=lambda: torque(axial_load=LOAD, inner_speed=SPEED, radial_load=radial))


def at(scene: Any, axial: Any, speed: Any, *, radial: float) -> Any:
    from dataclasses import replace

    import numpy as np

    from analytic.scene import Operation

    operation = Operation(axial_load=np.array(axial), inner_speed=np.array(speed), radial_load=radial)
    return replace(scene, operation=operation)


def series(scene_of: Callable[[Path], Any], tree: Path, *, points: int = POINTS, radial: float = 0.0) -> Work:
    """The torque at random operating points; of those that take too long, some."""
    import numpy as np

    from analytic import friction_torque

    scene, random = scene_of(tree), np.random.default_rng(SEED)
    axial, speed = random.uniform(100, 2000, points), random.uniform(10, 150, points)

    def torque(some: int) -> float:
        return friction_torque(at(scene, axial[:some], speed[:some], radial=radial)).torque.total[0]

    some, seconds = 0, 0.0
    while some < points and seconds < LONG:
        some = min(points, max(FEW, GROWTH * some))
        started = time.perf_counter()
        torque(some)
        seconds = time.perf_counter() - started
    note = "" if some == points else f"from {some} points"
    return Work(call=partial(torque, some), share=points / some, note=lambda: note)


def contact(tree: Path, *, pair: Any, accuracy: float, warm: bool) -> Work:
    """A contact of a ball in its true groove; each call has another load.

    warm : whether a like contact was solved before; else only an idealised one, coarsely
    """
    from analytic import load_scene
    from fembearing import solve_contact

    scene = load_scene(dry_file(tree))
    solve_contact(scene, pair=pair, load=50.0, accuracy=0.5, geometry="hertzian")
    loads = (620.0 * (1 + 0.07 * number) for number in count())
    if warm:
        solve_contact(scene, pair=pair, load=next(loads), accuracy=accuracy)

    stated = 0.0

    def approach() -> float:
        nonlocal stated
        solution = solve_contact(scene, pair=pair, load=next(loads), accuracy=accuracy)
        stated = max(solution.estimates[name].total for name in STATED)
        return solution.reference.approach

    return Work(call=approach, note=lambda: f"states {100 * stated:.3f} %")


def predicted(samples: int, tree: Path) -> Work:
    """The 95 % interval of the torque and its Sobol indices."""
    from analytic import load_scene, predict

    scene = load_scene(scene_file(tree, "6205_physical"))
    return Work(call=lambda: predict(scene, samples=samples).total.high[0])


def cage_step(tree: Path) -> Work:
    """One time step of the motion of a cage with nine balls."""
    from math import pi

    from analytic import load_scene

    try:
        from analytic.cage.motion import CageMotion
        from analytic.cage.torque import driven_cage
        from analytic.loads.kinematics import ball_kinematics
    except ImportError:  # before the packages of the model
        from analytic.cage_motion import CageMotion  # pyright: ignore[reportMissingImports]
        from analytic.cage_torque import driven_cage  # pyright: ignore[reportMissingImports]
        from analytic.kinematics import ball_kinematics  # pyright: ignore[reportMissingImports]

    scene, angle, speed = load_scene(dry_file(tree)), 0.18, 500 * pi / 30
    bearing = scene.bearing
    assert scene.cage is not None
    moving = ball_kinematics(
        inner_speed=speed,
        inner_angle=angle,
        outer_angle=angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    cage = driven_cage(
        bearing,
        scene.cage,
        friction_coefficient=scene.friction_coefficient or 0.1,
        inner_speed=speed,
        orbit_speed=float(moving.cage_speed),
        ball_speed=float(moving.ball_speed),
        contact_angle=angle,
    )
    motion = CageMotion(cage, begin="whirl", seed=0)
    steps = round(motion.advance(CAGE_TIME).duration / motion.step)
    return Work(call=lambda: motion.advance(CAGE_TIME).force, share=1 / steps)


JOBS = {
    "contact": Job(
        title="contact in the true groove to 0.1 %, the first of its process",
        work=partial(contact, pair="inner", accuracy=1e-3, warm=False),
        goal=0.5,
        clock="wall",  # both bodies at once
        fresh=True,
    ),
    "next_contact": Job(
        title="the same, the next load",
        work=partial(contact, pair="inner", accuracy=1e-3, warm=True),
        goal=0.2,
        clock="wall",  # both bodies at once
        short=True,
    ),
    "contact_outer": Job(
        title="contact of the outer race to 0.1 %, the first of its process",
        work=partial(contact, pair="outer", accuracy=1e-3, warm=False),
        goal=0.5,
        clock="wall",  # both bodies at once
        fresh=True,
    ),
    "fine_contact": Job(
        title="contact in the true groove to 0.05 %, the first of its process",
        work=partial(contact, pair="inner", accuracy=5e-4, warm=False),
        goal=1.5,
        clock="wall",  # both bodies at once
        fresh=True,
    ),
    "dry_point": Job(
        title="torque point, built-in with a coefficient, balls by rule",
        work=partial(point, dry),
        goal=0.1e-3,
        short=True,
    ),
    "calibrated_point": Job(
        title="torque point, 6205_paper_calibrated, balls by rule",
        work=partial(point, partial(oiled, "6205_paper_calibrated")),
        goal=0.15e-3,
        short=True,
    ),
    "physical_point": Job(
        title="torque point, 6205_physical, balls by rule",
        work=partial(point, partial(oiled, "6205_physical")),
        goal=0.5e-3,
        short=True,
    ),
    "dry_call": Job(
        title="one call of torque_function, built-in with a coefficient",
        work=partial(called, dry),
        goal=0.1e-3,
    ),
    "calibrated_call": Job(
        title="one call of torque_function, 6205_paper_calibrated",
        work=partial(called, partial(oiled, "6205_paper_calibrated")),
        goal=0.15e-3,
    ),
    "physical_call": Job(
        title="one call of torque_function, 6205_physical",
        work=partial(called, partial(oiled, "6205_physical")),
        goal=0.5e-3,
    ),
    "radial_call": Job(
        title="one call of torque_function, 6205_physical with 1000 N of radial load",
        work=partial(called, partial(oiled, "6205_physical"), radial=1000.0),
        goal=1e-3,
    ),
    "free_point": Job(
        title="torque point, 6205_physical, free balls",
        work=partial(point, partial(oiled, "6205_physical", spin_rule="free")),
        short=True,
    ),
    "radial_point": Job(
        title="torque point, 6205_physical with 1000 N of radial load, balls by rule",
        work=partial(point, partial(oiled, "6205_physical"), radial=1000.0),
        goal=1e-3,
        short=True,
    ),
    "radial_series": Job(
        title="100 000 such points",
        work=partial(series, partial(oiled, "6205_physical"), radial=1000.0),
        goal=60.0,
    ),
    "thrust_series": Job(
        title="100 000 thrust points, 6205_physical, balls by rule",
        work=partial(series, partial(oiled, "6205_physical")),
        goal=0.5,
    ),
    "free_series": Job(
        title="100 000 thrust points, 6205_physical, free balls",
        work=partial(series, partial(oiled, "6205_physical", spin_rule="free")),
        goal=0.5,
    ),
    "short_series": Job(
        title="200 thrust points, 6205_physical, balls by rule",
        work=partial(series, partial(oiled, "6205_physical"), points=200),
        short=True,
    ),
    "interval": Job(
        title="95 % interval from 1000 samples of 6205_physical",
        work=partial(predicted, 1000),
        goal=2.0,
        clock="wall",
        once=True,
    ),
    "indices": Job(
        title="Sobol indices from 4096 samples of 6205_physical",
        work=partial(predicted, 4096),
        goal=5.0,
        clock="wall",
        once=True,
    ),
    "cage_step": Job(
        title="time step of a cage with nine balls",
        work=cage_step,
        short=True,
    ),
}


if __name__ == "__main__":
    main()
