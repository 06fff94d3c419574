"""Fit of the correction of Hertz to the solves: python validation/correction/fit.py

Chooses terms and coefficients for each quantity from the set `fit` of solves.csv, tests them on the sets `held out` and
`bearing`, prints their errors, and writes analytic/catalog/corrections/finite_geometry.toml. Takes a second.

Least squares, weighted with the uncertainties of the solves. Terms are added one at a time, each the candidate that
lowers the leave-one-out error most (exact: the error at a point that the fit leaves out is its residual over 1 -
leverage). The fit keeps the fewest terms whose mean square leave-one-out error is within one standard error of the
least, or as small as the errors of the solves: further terms would follow the errors of the meshes.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from analytic import catalog
from analytic.contact.finite_geometry_fit import OFF_SHOULDER, SMALL, Bases, ContactShape, shape_bases
from validation.correction.solve import BOX, HERE, QUANTITIES, RANGE, read_rows
from validation.study import numbers, run, show

STORED = catalog.path("corrections", "finite_geometry")
MOST_TERMS = 40
PARALLEL = 0.03  # least part of a column, of its length, that is independent of the chosen ones; less amplifies noise
LEAST_UNCERTAINTY = 3e-4  # half-width of a solve; below it the misfit of the fit dominates the error
NOISE = 0.25  # mean square error of a solve in units of its 95 % half-width, which is two standard deviations
Array = NDArray[np.float64]
Powers = dict[str, int]


def monomial(bases: tuple[Bases, Bases], powers: Mapping[str, int]) -> Array:
    """The product of the bases named in `powers`, each to its power, averaged over both sides."""
    products = [np.prod([getattr(side, name) ** power for name, power in powers.items()], axis=0) for side in bases]
    return np.mean(products, axis=0)


@dataclass(frozen=True)
class Solves:
    """One set of solves; arrays (n,)."""

    shape: ContactShape
    ratio: dict[str, Array]  # finite elements over Hertz
    uncertainty: dict[str, Array]  # half-width
    solver: set[str]


@dataclass(frozen=True)
class Fit:
    """The fit of one quantity."""

    terms: list[Powers]
    coefficients: Array
    left_out: Array  # (n,) leave-one-out errors

    def error(self, solves: Solves, quantity: str) -> Array:
        bases = shape_bases(solves.shape)
        change = sum(c * monomial(bases, term) for c, term in zip(self.coefficients, self.terms, strict=True))
        return 1 + change - solves.ratio[quantity]

    def errors(self, held_out: Solves, bearings: Solves, quantity: str) -> Iterator[tuple[str, Array]]:
        """Of contacts that the fit leaves out one by one, and of both sets that it does not know."""
        yield "left out", self.left_out
        yield "held out", self.error(held_out, quantity)
        yield "bearing", self.error(bearings, quantity)


def main() -> None:
    fitted = solves_of("fit", "shoulders")
    held_out, bearings = solves_of("held out", "shoulders held out"), solves_of("bearing")
    fits = {name: fit_of(fitted, name) for name in QUANTITIES}
    STORED.parent.mkdir(exist_ok=True)
    STORED.write_text("\n".join(toml(fits, fitted, held_out, bearings)) + "\n", "utf-8")
    heads = ("quantity", "terms", "set", "contacts", "Hertz rms", "rms", "95 %", "worst", "solves +-")
    shown = []
    for name, fit in fits.items():
        for (group, error), solves in zip(
            fit.errors(held_out, bearings, name), (fitted, held_out, bearings), strict=True
        ):
            each = (rms(solves.ratio[name] - 1), *spread(error).values(), float(np.median(solves.uncertainty[name])))
            terms = len(fit.terms) if solves is fitted else ""
            shown.append((name, terms, group, error.size, *(f"{100 * value:.3f} %" for value in each)))
    show(heads, shown, "Relative error of the corrected Hertz against finite elements")


def solves_of(*groups: str) -> Solves:
    """The converged solves of some sets; those that lie in the box, but for the set `beyond`."""
    rows = [row for row in read_rows() if row["set"] in groups and not row["trouble"]]
    if "beyond" not in groups:
        rows = [row for row in rows if float(row["size"]) <= BOX["size"][1]]
        rows = [row for row in rows if float(row["shoulder"]) >= OFF_SHOULDER * float(row["size"])]
    return Solves(
        shape=ContactShape(**{name: numbers(rows, name) for name in (*BOX, "far_shoulder", "contact_angle")}),
        ratio={name: numbers(rows, name) for name in QUANTITIES},
        uncertainty={name: numbers(rows, f"{name}_uncertainty") for name in QUANTITIES},
        solver={row["solver"] for row in rows},
    )


def candidates() -> Iterator[Powers]:
    """Candidate terms, each of which vanishes with the size.

    First order: displacements that are independent of the size of the contact (ball to its middle plane, race to its
    far field, with the effect of curvatures and shoulder), the logarithm, and the surfaces that the load draws together
    on a slope. Higher order: the shape of the gap, with its dependence on the elasticity of the bodies.
    """
    race: list[Powers] = [{}, *({name: 1} for name in ("rolling_curvature", "openness", "shoulder_curvature"))]
    yield {"relative_load": 1, "log_drift": 1}
    for kind in ("share", "drift", "bulk"):
        yield {"relative_load": 1, f"ball_{kind}": 1}
        for part in (*race, {"shoulder_curvature": 2}):
            yield {"relative_load": 1, f"race_{kind}": 1} | part
    for power in range(3):
        slender = {"axis_ratio": power} if power else {}
        yield {"size": 1, "ball_drift": 1} | slender
        for part in race[:2]:
            yield {"size": 1, "race_drift": 1} | part | slender
    curvatures: list[Powers] = [*race[:3], {"rolling_curvature": 2}, race[1] | race[2]]
    elastic: list[Powers] = [{}, {"ball_share": 1}, {"ball_drift": 1}, {"race_drift": 1}]
    for size, power, curvature, part in product((2, 3, 4), range(3), curvatures, elastic):
        yield {"size": size} | curvature | ({"axis_ratio": power} if power else {}) | part
    for size in (2, 3, 4):
        for shoulder in range(1, size + 1):
            yield {"size": size, "shoulder_curvature": shoulder, "race_share": 1}
            for slope in (1, 2):
                yield {"size": size, "shoulder_curvature": shoulder, "land_slope": slope, "race_share": 1}
    for kind, shoulder, slope in product(("share", "drift", "bulk"), (1, 2), (1, 2)):
        yield {"relative_load": 1, f"race_{kind}": 1, "shoulder_curvature": shoulder, "land_slope": slope}


def fit_of(solves: Solves, quantity: str) -> Fit:
    """The fit of one quantity by the procedure at the head of this file."""
    terms, bases = list(candidates()), shape_bases(solves.shape)
    weight = 1 / np.maximum(solves.uncertainty[quantity], LEAST_UNCERTAINTY)
    columns = np.column_stack([monomial(bases, term) for term in terms])
    change = solves.ratio[quantity] - 1
    chosen = chosen_terms(columns * weight[:, None], change * weight)
    weighted = columns[:, chosen] * weight[:, None]
    kept, *_ = np.linalg.qr(weighted)
    coefficients, *_ = np.linalg.lstsq(weighted, change * weight, rcond=None)
    residual = columns[:, chosen] @ coefficients - change
    leverage = np.sum(kept**2, axis=1)
    return Fit(terms=[terms[n] for n in chosen], coefficients=coefficients, left_out=residual / (1 - leverage))


def chosen_terms(columns: Array, values: Array) -> list[int]:
    """The columns (n, m) that explain the values (n,), in the order of their choice."""
    rest = columns / np.linalg.norm(columns, axis=0)
    residual, leverage = values, np.zeros(values.size)
    chosen, mean, error = [], [float(np.mean(values**2))], [0.0]
    for _ in range(min(MOST_TERMS, values.size // 4)):
        length = np.linalg.norm(rest, axis=0)
        unit = rest / np.maximum(length, PARALLEL)
        left_out = (residual[:, None] - unit * (residual @ unit)) / (1 - leverage[:, None] - unit**2)
        score = np.where(length > PARALLEL, np.mean(left_out**2, axis=0), np.inf)
        best = int(np.argmin(score))
        chosen.append(best)
        mean.append(float(score[best]))
        error.append(float(np.std(left_out[:, best] ** 2) / np.sqrt(values.size)))
        taken = unit[:, best]
        residual, leverage = residual - taken * (taken @ residual), leverage + taken**2
        rest = rest - np.outer(taken, taken @ rest)
    least = int(np.argmin(mean))
    return chosen[: int(np.argmax(np.array(mean) <= max(mean[least] + error[least], NOISE)))]


def uncertainty_of(fit: Fit, solves: Solves, quantity: str) -> float:
    """Half-width, 95 %, over all but the smallest contacts: leave-one-out error plus uncertainty of the solves."""
    large = np.asarray(solves.shape.size) >= SMALL
    interpolation = float(np.quantile(np.abs(fit.left_out[large]), 0.95))
    return interpolation + float(np.median(solves.uncertainty[quantity][large]))


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def spread(error: Array) -> dict[str, float]:
    size = np.abs(error)
    return {"rms": rms(error), "quantile_95": float(np.quantile(size, 0.95)), "worst": float(size.max())}


def toml(fits: dict[str, Fit], fitted: Solves, held_out: Solves, bearings: Solves) -> Iterator[str]:
    """The stored file, line by line."""
    (head, *rest) = (line for line in (HERE / "solves.csv").read_text("utf-8").splitlines() if line.startswith("#"))
    yield "# Correction of Hertz for the true shape of ball and groove, written by validation/correction/fit.py"
    yield "# from solves.csv, read by analytic/contact/finite_geometry.py. Errors and uncertainties are relative."
    dates = sorted({row["date"] for row in read_rows()})
    yield ""
    yield "[provenance]"
    yield f'about = "{head[2:]}"'
    for line in rest:
        name, _, value = line[2:].partition(": ")
        yield f'{name} = "{value}"'
    yield f'solver = "{", ".join(sorted(fitted.solver | held_out.solver | bearings.solver))}"'
    yield f'dates = "{dates[0]} to {dates[-1]}"'
    yield 'fit = "python validation/correction/fit.py"'
    sizes = (np.size(each.shape.size) for each in (fitted, held_out, bearings))
    yield "solves = {{ fit = {}, held_out = {}, bearing = {} }}".format(*sizes)
    yield ""
    yield "[range]"
    for name, (low, high) in RANGE.items():
        yield f"{name} = [{low:g}, {high:g}]"
    for name, fit in fits.items():
        yield ""
        yield f"[quantity.{name}]"
        yield f"uncertainty = {uncertainty_of(fit, fitted, name):.2g} # half-width, 95 %"
        yield f"numerical_uncertainty = {np.median(fitted.uncertainty[name]):.2g} # of a solve, median"
        for label, error in fit.errors(held_out, bearings, name):
            parts = ", ".join(f"{key} = {value:.2g}" for key, value in spread(error).items())
            yield f"{label.replace(' ', '_')} = {{ {parts} }}"
        yield "terms = ["
        for coefficient, powers in zip(fit.coefficients, fit.terms, strict=True):
            inner = ", ".join(f"{base} = {power}" for base, power in powers.items())
            yield f"  {{ coefficient = {coefficient:.8g}, powers = {{ {inner} }} }},"
        yield "]"


if __name__ == "__main__":
    run(main)
