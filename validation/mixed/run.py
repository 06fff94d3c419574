"""The share of the load on asperities over lambda, beside measured and quoted laws: python validation/mixed/run.py

The heaviest ball of a 6206 under 2 kN presses on the inner race, in ground and in ground and honed finish, with the
film that a speed gives to smooth surfaces at 70 degC, without heat and starvation. lambda is this film over the rms
height of both surfaces. The program prints tables of shares, with the ends of the 95 % interval of `model.gap` and the
slope at which the elastic law itself would carry the measured share, and draws mixed.png into this folder. The laws are
those of published/load_sharing.csv.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.special import erf, erfc, ndtri

from analytic import load_scene
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.oil.film import FilmAsymptotes, Inflow, asymptotes_of
from analytic.oil.mixed import mixed_contact
from analytic.oil.variation import GAP_SPREAD
from analytic.scene import Array, Scene
from analytic.surface.gap import SMOOTH_GAP, GapNumbers, gap_law
from analytic.surface.roughness import gap_roughness
from validation.study import Out, Row, figure, published, run, save, show

HERE = Path(__file__).parent
FINISHES = ("ground", "ground and honed")
LAMBDAS = (0.25, 0.5, 0.95, 1.3, 1.8, 2.3, 3.0)
LOAD = 4.37 * 2000 / 9  # N, of the heaviest of nine balls [Stribeck1907]
END = GAP_SPREAD * float(ndtri(0.975))  # of model.gap, the upper end of its 95 %
LAWS = published("load_sharing.csv")  # as they are printed, measured ones first
SPEEDS = np.geomspace(1e-5, 1e4, 2000)  # m/s, among which that of a film is found


def share_by(law: Row, film_ratio: Array) -> Array:
    """s by a printed law, a row of LAWS; NaN outside its range. film_ratio : lambda."""
    names = {"l": film_ratio, "erf": erf, "erfc": erfc, "exp": np.exp, "sqrt": np.sqrt}
    inside = (float(law["from"]) <= film_ratio) & (film_ratio <= float(law["to"]))
    return np.where(inside, eval(law["formula"], {"__builtins__": {}}, names), np.nan)


@dataclass(frozen=True, kw_only=True, eq=False)
class RoughContact:
    """The inner race in one finish."""

    finish: str
    scene: Scene
    contact: ContactNumbers
    gap: GapNumbers
    truncated: GapNumbers  # the other law of the gap
    rms: float  # of both surfaces, m
    slope: float  # rms gradient of both

    def film(self, speed: Array) -> FilmAsymptotes:
        """Of smooth surfaces; speed : of entrainment, m/s."""
        oil = self.scene.lubricant
        return asymptotes_of(self.contact, Inflow(speed, oil.viscosity, oil.pressure_viscosity, compressible=True))

    def share(self, film_ratio: Array, step: float = 0.0, *, truncated: bool = False) -> Array:
        """s at lambda; step : of model.gap."""
        smooth = mixed_contact(self.contact, self.film(SPEEDS), SMOOTH_GAP).film_thickness
        speed = np.exp(np.interp(np.log(film_ratio * self.rms), np.log(smooth), np.log(SPEEDS)))
        gap = self.truncated if truncated else self.gap
        return mixed_contact(self.contact, self.film(speed), gap=gap, share_step=step).asperity_share


def rough_contact(finish: str) -> RoughContact:
    """A finish of the catalogue."""
    loads = {"radial_load": "2 kN", "speed": "1500 rpm", "oil": "ISO VG 46", "temperature": "70 degC"}
    scene = load_scene("6206", settings={"surface.finish": finish}, **loads)
    bearing, roughness = scene.bearing, gap_roughness(scene.surface)
    rolling, transverse = race_curvatures(bearing, "inner", contact_angle=0.0)
    bodies = (bearing.ball_material, bearing.inner.material)
    modulus = contact_modulus(*bodies)
    gap, truncated = (
        gap_law(surface, roughness, modulus=modulus, bodies=bodies)
        for surface in (scene.surface, replace(scene.surface, gap="truncated"))
    )
    both = roughness.ball + roughness.race
    return RoughContact(
        finish=finish,
        scene=scene,
        contact=elliptic_contact(
            curvature_rolling=rolling, curvature_transverse=transverse, load=LOAD, modulus=modulus
        ),
        gap=gap,
        truncated=truncated,
        rms=both.rms_roughness,
        slope=float(np.sqrt(2 * both.slope)),
    )


def main(out: Out = HERE) -> None:
    contacts = [rough_contact(finish) for finish in FINISHES]
    report(contacts)
    draw(contacts, out / "mixed.png")


def report(contacts: list[RoughContact]) -> None:
    film_ratio = np.array(LAMBDAS)
    heads, rows = ("lambda", *(f"{each:g}" for each in LAMBDAS)), []
    for each in contacts:
        rows += [
            (each.finish, *_percent(each.share(film_ratio))),
            ("  interval, low", *_percent(each.share(film_ratio, -END))),
            ("  interval, high", *_percent(each.share(film_ratio, END))),
            ("  truncated", *_percent(each.share(film_ratio, truncated=True))),
        ]
    rows += [(law["short"], *_percent(share_by(law, film_ratio))) for law in LAWS]
    show(heads, rows, "Share of the load on asperities, %")
    measured = share_by(LAWS[1], film_ratio)
    slopes = [
        (f"{each.finish}, has {each.slope:.4f}", *(f"{s:.2g}" for s in each.slope * measured / each.share(film_ratio)))
        for each in contacts
    ]
    show(heads, slopes, "rms slope for the share of T&S Gauss")


def _percent(shares: Array) -> list[str]:
    return ["" if np.isnan(share) else f"{100 * share:.2g}" for share in shares]


def draw(contacts: list[RoughContact], path: Path) -> None:
    drawn = figure(8.4, 4.6)
    film_ratio = np.linspace(0.05, 3.0, 200)
    styles = {"measured friction": ("C3", "-"), "measured contact resistance": ("C1", "-"), "quoted": ("0.45", ":")}
    for axes, each in zip(drawn.subplots(1, 2, sharey=True), contacts, strict=True):
        low, high = (100 * each.share(film_ratio, step) for step in (-END, END))
        axes.fill_between(film_ratio, low, high, color="C0", alpha=0.2, lw=0, label="95 % of model.gap")
        axes.semilogy(film_ratio, 100 * each.share(film_ratio), color="C0", lw=2, label="product")
        for number, law in enumerate(LAWS):
            colour, line = styles[law["kind"]]
            is_quoted, first = law["kind"] == "quoted", LAWS[number - 1]["kind"] != "quoted"
            label = "quoted laws" if is_quoted and first else None if is_quoted else law["law"]
            dashed = "--" if law["kind"] == "measured friction" and number else line
            axes.plot(film_ratio, 100 * share_by(law, film_ratio), color=colour, ls=dashed, lw=1.3, label=label)
        axes.set(title=each.finish, xlabel="lambda, smooth film over rms height", xlim=(0, 3), ylim=(0.01, 110))
        axes.grid(alpha=0.25)
    drawn.axes[0].set_ylabel("load on asperities, %")
    drawn.axes[0].legend(frameon=False, loc="lower left", fontsize=8)
    save(drawn, path)


if __name__ == "__main__":
    run(main)
