"""Where do contacts and checks spend their time? python validation/benchmarks/where.py

Each case runs in a new process on one thread, once timed and once profiled. The table has the processor seconds of the
whole, and of its parts by their share of the profile; meshes, stiffness, factors and pixels are those of contacts,
rings and friction together. The machine should be idle for figures to quote.
"""

import json
import os
import subprocess
import sys

from validation.study import machine, out, run, show

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
CONTACT = 'fembearing.solve_contact(dry, pair="inner", load={load}, accuracy=1e-3)'
SERIES = 'fembearing.solve_load_series(dry, pair="inner", loads=numpy.geomspace(100.0, 600.0, 40), accuracy=5e-4)'
CHECK = "fembearing.validate({scene!r}, **{given!r})"
OILED = {"radial_load": 2000.0, "speed": 157.0}
CASES = {  # statements that are not timed, and what is
    "first contact": ("", CONTACT.format(load=620.0)),
    "next load": (CONTACT.format(load=620.0), CONTACT.format(load=663.0)),
    "series of 40 loads": ("", SERIES),
    "check of 6205-dry": ("", CHECK.format(scene="6205-dry", given={})),
    "check of 6206 with oil": ("", CHECK.format(scene="6206", given=OILED)),
}
PARTS = {  # functions, with their files, whose time is that of a part
    "loads of the balls": ("torque.py loaded_balls_of",),
    "meshes": ("pair.py pair_mesh", "ball.py flat_ball", "twin.py flat_race", "ring.py ring_piece"),
    "stiffness": ("condensation.py held_stiffness",),
    "factors": ("topology.py complement", "topology.py solution"),
    "pixels": ("pixel_contact.py press_pair",),
    "films": ("scene_film.py film_of", "scene_film.py film_change"),
    "friction": ("scene_creep.py creep_of",),
    "torque": ("scene_torque.py torque_of_scene", "torque_change.py change_of_torque", "sensitivity.py sensitivity_of"),
}
PROGRAM = """
import concurrent.futures, cProfile, json, pstats, sys, time
class Serial:  # a profile sees one thread
    def __init__(self, *_): ...
    def __enter__(self): return self
    def __exit__(self, *_): ...
    def map(self, function, *given): return map(function, *given)
    def shutdown(self, **_): ...
    def submit(self, function, *given, **named):
        done = concurrent.futures.Future()
        try: done.set_result(function(*given, **named))
        except Exception as problem: done.set_exception(problem)
        return done
concurrent.futures.ThreadPoolExecutor = Serial
import analytic, fembearing, numpy
dry = analytic.load_scene("6205-dry")
before, call, profiled, parts = json.load(sys.stdin)
exec(before)
profile, begun = cProfile.Profile(), time.process_time()
if profiled: profile.runctx(call, globals(), locals())
else: eval(call)
found = {"whole": time.process_time() - begun}
if profiled:
    stats = pstats.Stats(profile).stats
    spent = {f"{file.rsplit('/', 1)[-1]} {name}": value[3] for (file, _, name), value in stats.items()}
    found |= {part: sum(spent.get(name, 0.0) for name in names) for part, names in parts.items()}
    found["whole"] = max(value[3] for value in stats.values())
print(json.dumps(found))
"""


def measured(before: str, call: str, *, profiled: bool) -> dict[str, float]:
    given = json.dumps([before, call, profiled, PARTS])
    command = [sys.executable, "-P", "-c", PROGRAM]
    done = subprocess.run(command, input=given, capture_output=True, text=True, check=True, env=os.environ | ONE_THREAD)
    return json.loads(done.stdout.splitlines()[-1])


def main() -> None:
    rows = []
    for case, (before, call) in CASES.items():
        whole = measured(before, call, profiled=False)["whole"]
        found = measured(before, call, profiled=True)
        shares = [found[part] / found["whole"] for part in PARTS]
        rows.append((case, f"{whole:.2f}", *(f"{share * whole:.2f}" if share > 0.005 else "" for share in shares)))
    show(("case", "whole, s", *PARTS), rows, "Processor seconds, one thread")
    out.print(machine())


if __name__ == "__main__":
    run(main)
