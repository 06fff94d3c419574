"""The central film against measured films: python validation/film/run.py [--out FOLDER]

A steel ball rolls on a glass disc under oil, and interferometry gives the film in the middle. The comparison follows
[ASME2009]: the error E = S - D of the computed against the measured film is that of the formula to within
u_val = sqrt(u_num^2 + u_input^2 + u_D^2). All uncertainties are standard ones. The program prints a table and the
conclusions for the formula, and draws film.png into this folder.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import elliptic_contact
from analytic.oil.ehl_fit import film_correction, regime_of
from analytic.oil.film import FILM_FACTORS, FORMULA_UNCERTAINTY, Inflow, central_film
from validation.study import PUBLISHED, Out, figure, out, run, save, show

HERE = Path(__file__).parent
DATA = PUBLISHED / "film_measured_25C.csv"
RADIUS, LOAD = 9.525e-3, 20.0  # m, N
YOUNGS_MODULI, POISSON_RATIOS = (200e9, 70e9), (0.25, 0.21)  # of steel and glass, Pa
INPUTS = {
    "viscosity": 0.03793,  # Pa s
    "pressure_viscosity": 1.4e-8,  # 1/Pa
    "load": LOAD,
    "modulus": 1 / sum((1 - nu**2) / e for e, nu in zip(YOUNGS_MODULI, POISSON_RATIOS, strict=True)),
}
# Assumed relative standard uncertainties, because none is stated. The pressure-viscosity coefficient was not measured;
# mineral oils of this viscosity have some 1.4 to 2.2e-8 1/Pa (no source seen). Viscosity changes by 4 % per kelvin.
INPUT_UNCERTAINTIES = {"viscosity": 0.02, "pressure_viscosity": 0.15, "load": 0.01, "modulus": 0.02}
SPEED_UNCERTAINTY = 0.01  # relative, standard, assumed too
SCATTER_SPEEDS, SCATTER = (0.05, 0.1), (1.1e-9, 18e-9)  # m/s, m: stated up to the first and above the second
LEAST_SPEED = 0.02  # m/s: below, films of 15 nm and less scatter


class Spread(NamedTuple):
    """How measured films lie about the computed ones: ln(D/S), with the errors of inputs and measurement."""

    points: int
    bias: float  # exp of the mean: measured over computed film
    deviation: float  # standard deviation
    root_mean_square: float
    covered: int  # points within FILM_FACTORS


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """Each (n,), SI."""

    speed: np.ndarray
    measured: np.ndarray  # D
    computed: np.ndarray  # S
    measurement_uncertainty: np.ndarray  # u_D
    input_uncertainty: np.ndarray  # u_input
    judged: np.ndarray  # bool: faster than LEAST_SPEED

    @property
    def error(self) -> np.ndarray:
        """E, m."""
        return self.computed - self.measured

    @property
    def uncertainty(self) -> np.ndarray:
        """u_val, m; u_num, the round-off of a formula, is negligible."""
        return np.hypot(self.measurement_uncertainty, self.input_uncertainty)

    @property
    def relative(self) -> np.ndarray:
        """E/D."""
        return self.error / self.measured

    def spread(self, rows: np.ndarray) -> Spread:
        """Of these points; rows : bool, (n,)."""
        log_ratio = np.log(self.measured / self.computed)[rows]
        low, high = np.log(FILM_FACTORS)
        return Spread(
            points=log_ratio.size,
            bias=float(np.exp(log_ratio.mean())),
            deviation=float(log_ratio.std(ddof=1)),
            root_mean_square=float(np.sqrt(np.mean(log_ratio**2))),
            covered=int(np.sum((low <= log_ratio) & (log_ratio <= high))),
        )


def film(speed: np.ndarray, **changed: float) -> np.ndarray:
    """Central film as the torque takes it, m, with some inputs changed."""
    inputs = INPUTS | changed
    contact = elliptic_contact(
        curvature_rolling=1 / RADIUS, curvature_transverse=1 / RADIUS, load=inputs["load"], modulus=inputs["modulus"]
    )
    oil = {"viscosity": inputs["viscosity"], "pressure_viscosity": inputs["pressure_viscosity"]}
    closed = central_film(contact, entrainment_speed=speed, compressible=True, **oil).thickness
    regimes = [regime_of(contact, Inflow(float(u), *oil.values(), True, np.inf)) for u in speed]
    return closed * np.exp([film_correction(regime) for regime in regimes])


def compare() -> Comparison:
    speed, nanometres = np.loadtxt(DATA, delimiter=",", skiprows=6, unpack=True)
    computed = film(speed)
    changes = [  # half of the difference between the films with an input increased and decreased by its uncertainty
        (film(speed, **{name: INPUTS[name] * (1 + u)}) - film(speed, **{name: INPUTS[name] * (1 - u)})) / 2
        for name, u in INPUT_UNCERTAINTIES.items()
    ]
    changes.append((film(speed * (1 + SPEED_UNCERTAINTY)) - film(speed * (1 - SPEED_UNCERTAINTY))) / 2)
    return Comparison(
        speed=speed,
        measured=nanometres * 1e-9,
        computed=computed,
        measurement_uncertainty=np.interp(speed, SCATTER_SPEEDS, SCATTER),  # between the two, not stated: linear
        input_uncertainty=np.sqrt(np.sum(np.square(changes), axis=0)),
        judged=speed >= LEAST_SPEED,
    )


def report(found: Comparison) -> None:
    rows = []
    parts = (found.error, found.measurement_uncertainty, found.input_uncertainty, found.uncertainty)
    for row, d in enumerate(found.measured):
        error, *uncertainties = (100 * part[row] / d for part in parts)
        ratio = abs(error) / uncertainties[-1]
        note = "within u_val" if ratio <= 1 else "within 2 u_val" if ratio <= 2 else "beyond 2 u_val"
        lengths = f"{found.speed[row]:.4f}", f"{1e9 * d:.1f}", f"{1e9 * found.computed[row]:.1f}", f"{error:+.1f}"
        judgement = f"{ratio:.2f}", note if found.judged[row] else "scatters"
        rows.append((*lengths, *(f"{each:.1f}" for each in uncertainties), *judgement))
    show(("u, m/s", "D, nm", "S, nm", "E/D, %", "u_D, %", "u_input, %", "u_val, %", "|E|/u_val", ""), rows)
    judged, fast = found.judged, found.speed >= SCATTER_SPEEDS[1]
    relative, ratio = found.relative[judged], np.abs(found.error / found.uncertainty)[judged]
    measured_power, computed_power = (
        np.polyfit(np.log(found.speed[judged]), np.log(values[judged]), 1)[0]
        for values in (found.measured, found.computed)
    )
    out.print(
        f"{judged.sum()} of {judged.size} points are judged, {LEAST_SPEED:g} m/s and faster; "
        f"{np.sum(ratio <= 1)} lie within u_val, {np.sum(ratio <= 2)} within 2 u_val."
    )
    out.print(
        f"E/D: mean {100 * relative.mean():+.1f} %, from {100 * relative.min():+.1f} to {100 * relative.max():+.1f} %; "
        f"at {SCATTER_SPEEDS[1]:g} m/s and faster {100 * found.relative[fast].mean():+.1f} +- "
        f"{100 * found.relative[fast].std(ddof=1):.1f} %."
    )
    out.print(f"Power of speed: measured {measured_power:.3f}, computed {computed_power:.3f}.")
    for words, some in (("All", judged | True), ("Judged", judged), ("Slower, not judged", ~judged)):
        spread = found.spread(some)
        out.print(
            f"{words}: {spread.points} films, D/S {spread.bias:.3f} on average, ln(D/S) has the standard deviation "
            f"{spread.deviation:.3f} and the root mean square {spread.root_mean_square:.3f}; {spread.covered} of "
            f"{spread.points} within {FILM_FACTORS[0]:.2f} to {FILM_FACTORS[1]:.2f}."
        )
    out.print(f"The formula carries {FORMULA_UNCERTAINTY:g} as its standard deviation of ln(film).")


def draw(found: Comparison, path: Path) -> None:
    drawn = figure(6.4, 6.4)
    films, errors = drawn.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    low, high = found.computed - 2 * found.input_uncertainty, found.computed + 2 * found.input_uncertainty
    films.fill_between(found.speed, 1e9 * low, 1e9 * high, color="C0", alpha=0.25, lw=0, label="its inputs, 95 %")
    films.loglog(found.speed, 1e9 * found.computed, color="C0", label="formula")
    bars = 1e9 * 2 * found.measurement_uncertainty
    films.errorbar(
        found.speed, 1e9 * found.measured, bars, fmt="k.", ms=4, lw=0.7, label="measured, stated scatter, 95 %"
    )
    films.set(ylabel="central film, nm", ylim=(1, 400))
    films.legend(frameon=False)
    band = 200 * found.uncertainty / found.measured
    errors.fill_between(found.speed, -band, band, color="0.85", lw=0, label="2 u_val")
    errors.plot(found.speed, 100 * found.relative, "k.", ms=4, label="E/D")
    errors.axvline(LEAST_SPEED, color="0.5", lw=0.7, ls=":")
    errors.set(xlabel="entrainment speed, m/s", ylabel="E/D, %", ylim=(-80, 100))
    errors.legend(frameon=False)
    save(drawn, path)


def main(folder: Out = HERE) -> None:
    found = compare()
    report(found)
    draw(found, folder / "film.png")


if __name__ == "__main__":
    run(main)
