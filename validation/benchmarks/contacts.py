"""Finite elements against exact Hertz on the Hertzian idealisation: python validation/benchmarks/contacts.py

Both races of the 6205 at four loads. Seconds depend on the machine.
"""

from itertools import product

from analytic import load_scene
from fembearing import solve_contact
from validation.study import machine, out, run, show

LOADS = (50.0, 200.0, 620.0, 2000.0)  # N
QUANTITIES = {"approach": "approach", "semi_axis_rolling": "a", "semi_axis_transverse": "b", "peak_pressure": "p0"}


def main() -> None:
    scene, rows, worst = load_scene("6205-dry"), [], 0.0
    for pair, load in product(("inner", "outer"), LOADS):
        solution = solve_contact(scene, pair=pair, load=load, geometry="hertzian", tolerance=1e-4)
        errors = [1 / (1 + solution.numbers.quantities[name].difference) - 1 for name in QUANTITIES]
        worst = max(worst, *map(abs, errors))
        shown = (f"{100 * error:+.4f}" for error in errors)
        rows.append((pair, load, *shown, f"{solution.numbers.seconds:.1f}", solution.meshes[-1].unknowns))
    heads = ("pair", "load, N", *(f"{word}, %" for word in QUANTITIES.values()), "seconds", "unknowns")
    show(heads, rows, "Finite elements against exact Hertz on the Hertzian idealisation, finest level")
    out.print(f"worst: {100 * worst:.4f} %; {machine()}")


if __name__ == "__main__":
    run(main)
