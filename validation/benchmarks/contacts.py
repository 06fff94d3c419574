"""Accuracy and cost of the contacts: python validation/benchmarks/contacts.py

Prints the extra time of forty loads over one, the errors of the finite elements against exact Hertz on the Hertzian
idealisation, and the errors of the Hertz formulas against 50 digits. Times depend on the machine.
"""

import statistics
import time

import mpmath
import numpy as np

from analytic import hertz_contact, load_scene
from fembearing import solve_contact, solve_load_series
from validation.study import machine, out, run, show

LOADS = (50.0, 200.0, 620.0, 2000.0)  # N
RATIOS = (1.0, 1.0 + 1e-12, 1.37, 9.4, 310.0, 2.3e4, 1e6)
REPEATS = 3


def main() -> None:
    out.print(machine())
    time_load_series()
    errors_of_idealisation()
    errors_of_hertz()


def time_load_series() -> None:
    """Forty loads within a factor of six against one in their middle, warm; then within a factor of a hundred."""
    scene = load_scene("6205-dry")
    series = {"1": [245.0], "40": np.geomspace(100, 600, 40), "40 wide": np.geomspace(10, 1000, 40)}
    for pair in ("inner", "outer"):
        solve_load_series(scene, pair=pair, loads=series["1"])
        seconds, meshes, law = {}, {}, None
        for name, loads in series.items():
            runs = [solve_load_series(scene, pair=pair, loads=loads) for _ in range(REPEATS)]
            seconds[name] = statistics.median(run.seconds for run in runs)
            meshes[name], law = runs[0].meshes, runs[0].law
        out.print(
            f"{pair}: one load {seconds['1']:.2f} s; 40 from 100 to 600 N {seconds['40'] - seconds['1']:.2f} s more on "
            f"{meshes['40']} mesh, 40 from 10 to 1000 N {seconds['40 wide'] - seconds['1']:.2f} s more on "
            f"{meshes['40 wide']} (medians of {REPEATS}); "
            f"there n = {law.exponent:.4f} +- {law.exponent_uncertainty:.4f}"
        )


def errors_of_idealisation() -> None:
    scene = load_scene("6205-dry")
    names = ("approach", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure")
    heads = ("approach, %", "a, %", "b, %", "p0, %")
    rows, worst = [], 0.0
    for pair in ("inner", "outer"):
        for load in LOADS:
            solution = solve_contact(scene, pair=pair, load=load, geometry="hertzian", tolerance=1e-4)
            found = solution.numbers
            errors = {name: 1 / (1 + found.quantities[name].difference) - 1 for name in names}
            worst = max(worst, *map(abs, errors.values()))
            shown = [f"{100 * errors[name]:+.4f}" for name in names]
            rows.append((pair, load, *shown, f"{found.seconds:.1f}", solution.meshes[-1].unknowns))
    title = "Finite elements against exact Hertz on the Hertzian idealisation, finest level"
    show(("pair", "load, N", *heads, "seconds", "unknowns"), rows, title)
    out.print(f"worst: {100 * worst:.4f} %")


def errors_of_hertz() -> None:
    """Errors against the defining equation in 50 digits, each curvature ratio in both orientations."""
    load, modulus, curvature = 620.0, 113.2e9, 37.0
    worst = 0.0
    with mpmath.workdps(80):  # the textbook form loses digits near the circle; 50 remain
        for ratio in RATIOS:
            axis, pressure, approach = reference(ratio, load, modulus, curvature)
            for swapped in (False, True):
                pair = (curvature, ratio * curvature) if swapped else (ratio * curvature, curvature)
                contact = hertz_contact(curvature_x=pair[0], curvature_y=pair[1], load=load, modulus=modulus)
                major = contact.semi_axis_x if swapped else contact.semi_axis_y
                errors = (
                    mpmath.mpf(float(major)) / axis - 1,
                    mpmath.mpf(float(contact.peak_pressure)) / pressure - 1,
                    mpmath.mpf(float(contact.approach)) / approach - 1,
                )
                worst = max(worst, *(abs(float(error)) for error in errors))
    out.print(f"Hertz against 50 digits, curvature ratios {RATIOS[0]:g} to {RATIOS[-1]:g}: worst {worst:.1e}")
    count = 10**6
    curvatures = np.geomspace(37.0, 3.7e7, count)
    hertz_contact(curvature_x=curvatures[:9], curvature_y=37.0, load=load, modulus=modulus)
    start = time.perf_counter()
    hertz_contact(curvature_x=curvatures, curvature_y=37.0, load=load, modulus=modulus)
    out.print(f"one million Hertz contacts: {time.perf_counter() - start:.2f} s")


def reference(ratio: float, load: float, modulus: float, curvature: float) -> tuple[mpmath.mpf, ...]:
    """Major semi-axis, peak pressure and approach from the elliptic integrals as in textbooks."""
    exact = mpmath.mpf(ratio)

    def integrals(logarithm: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
        m = 1 - mpmath.exp(-2 * logarithm)
        return mpmath.ellipk(m), mpmath.ellipe(m)

    def misfit(logarithm: mpmath.mpf) -> mpmath.mpf:
        first, second = integrals(logarithm)
        return (mpmath.exp(2 * logarithm) * second - first) / (first - second) / exact - 1

    aim = mpmath.log(exact)
    logarithm = mpmath.findroot(misfit, (aim / 2, aim * 2 / 3), solver="anderson", tol=1e-30) if ratio > 1 else aim
    first, second = integrals(logarithm)
    elongation = mpmath.exp(logarithm)
    major = mpmath.cbrt(3 * elongation**2 * second * load / (mpmath.pi * modulus * curvature * (1 + exact)))
    pressure = 3 * load / (2 * mpmath.pi * major**2 / elongation)
    return major, pressure, 3 * load * first / (2 * mpmath.pi * modulus * major)


if __name__ == "__main__":
    run(main)
