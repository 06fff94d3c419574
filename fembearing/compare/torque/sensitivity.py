"""Which inputs move a scene's torque most: one at a time, to both ends of a range, by the production model.

Where the scene gives no friction, the peak pressure of both races takes the torque's place. A range names its source,
or says that it is a judgement. The ranges apply to any scene; `validation/sensitivity.py` has those of one paper's
bearing, and exchanges whole models too. Inputs are not moved together. The cage does not move: it has its closed form.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from analytic.errors import FembearingError
from analytic.oil.rolling import HYSTERESIS_LOSS
from analytic.result import COORDINATES
from analytic.scene import Array, Bearing, Material, Scene
from analytic.torque import friction_torque
from fembearing.compare.contact.hertz import hertz_quantities
from fembearing.compare.contact.scene_contact import heaviest_contact
from fembearing.quantities import unit_for

SAME = 1e-9  # relative: torques at two points that differ by less are one
RACES: tuple[Literal["inner", "outer"], ...] = ("inner", "outer")


@dataclass(frozen=True, kw_only=True)
class Output:
    """What the inputs change."""

    quantity: Literal["total_torque", "peak_pressure"]  # what is compared
    pair: Literal["inner", "outer"] | None  # None of a torque
    inner_speed: float | None  # rad/s, None of a pressure, which is the heaviest ball's at any point
    axial_load: float | None  # N, likewise
    radial_load: float | None  # N, likewise
    moment: float | None  # N m, likewise
    value: float  # N m or Pa


@dataclass(frozen=True, kw_only=True)
class Input:
    """One input with its range, SI, and what its ends do to each output, relative; None at an end that is refused."""

    name: str  # as readers see it
    unit: str  # of the next three; "1" without a dimension
    value: float  # the scene's, SI
    low: float  # end of the range, SI
    high: float  # end of the range, SI
    source: str  # of the range
    change_low: tuple[float, ...] | None  # of each output, relative
    change_high: tuple[float, ...] | None  # of each output, relative
    refused: tuple[str, ...]  # why an end was

    @property
    def swing(self) -> float:
        """The largest change of any output, relative."""
        changes = [*(self.change_low or ()), *(self.change_high or ())]
        return max(map(abs, changes), default=0.0)


@dataclass(frozen=True, kw_only=True)
class Sensitivity:
    """Outputs, and inputs from the one that moves them most."""

    outputs: tuple[Output, ...]
    inputs: tuple[Input, ...]


@dataclass(frozen=True, kw_only=True)
class Variation:
    """A range of an input, and the scene that a value of it makes."""

    name: str
    unit: str
    value: float
    low: float
    high: float
    source: str
    scene_at: Callable[[float], Scene]


def sensitivity_of(scene: Scene) -> Sensitivity:
    """Sensitivity at the slowest and the fastest operating point.

    Among points of equal speed the slowest is that with the least load and the fastest that with the largest. Where
    both have the same torque, the first is shown alone. Effects and methods stay as they were decided there.
    Raises InputError as friction_torque and heaviest_contact do for the scene itself. Where they refuse an end of a
    range, that end has the reason in place of a change.
    """
    varied, outputs_at, outputs = _torques(scene) if scene.has_friction else _pressures(scene)
    base = np.array([output.value for output in outputs])

    def change(moved: Scene) -> tuple[float, ...]:
        after = outputs_at(moved)
        return tuple(np.divide(after, base, out=np.ones_like(base), where=base != 0) - 1)

    inputs = []
    for variation in variations(varied):
        ends, refused = [], []
        for value in (variation.low, variation.high):
            try:
                ends.append(tuple(map(float, change(variation.scene_at(value)))))
            except FembearingError as problem:
                ends.append(None)
                refused.append(f"{unit_for(variation.unit, variation.value).written(value, '.4g')}: {problem}")
        described = {name: part for name, part in vars(variation).items() if name != "scene_at"}
        inputs.append(Input(**described, change_low=ends[0], change_high=ends[1], refused=tuple(refused)))
    return Sensitivity(outputs=tuple(outputs), inputs=tuple(sorted(inputs, key=lambda each: each.swing, reverse=True)))


Varied = tuple[Scene, Callable[[Scene], Array], list[Output]]  # what is varied, its outputs, and their names


def _torques(scene: Scene) -> Varied:
    order = np.lexsort((scene.operation.axial_load, np.abs(scene.operation.inner_speed)))
    ends = list(dict.fromkeys([int(order[0]), int(order[-1])]))
    # A cage whose pockets are too narrow for its balls moves with them unless both are off: minutes for each input.
    at_rest = {"cage_dynamics": "off", "ball_dynamics": "off"}
    varied = at_points(replace(scene, effects={**scene.effects, **at_rest}), ends)
    friction = friction_torque(varied)
    varied = friction.settled(varied)

    def total(moved: Scene) -> Array:
        return friction_torque(moved).torque.total

    value = total(varied)
    if np.ptp(value) <= SAME * value.max():
        varied, value = at_points(varied, [0]), value[:1]
    outputs = [
        Output(
            quantity="total_torque",
            pair=None,
            **{name: float(getattr(friction, name)[point]) for name in COORDINATES},
            value=float(value[point]),
        )
        for point in range(value.size)
    ]
    return varied, total, outputs


def _pressures(scene: Scene) -> Varied:
    def peaks(moved: Scene) -> Array:
        return np.array([hertz_quantities(heaviest_contact(moved, race)).peak_pressure for race in RACES])

    outputs = [
        Output(quantity="peak_pressure", pair=race, value=float(value), **dict.fromkeys(COORDINATES))
        for race, value in zip(RACES, peaks(scene), strict=True)
    ]
    return scene, peaks, outputs


def at_points(scene: Scene, points: list[int]) -> Scene:
    """The scene at some of its operating points, from 0."""
    operation = scene.operation
    shape = operation.inner_speed.shape
    picked = {name: np.broadcast_to(values, shape)[points] for name, values in vars(operation).items()}
    return replace(scene, operation=replace(operation, **picked))


def variations(scene: Scene) -> Iterator[Variation]:
    """Every input that the scene declares, with the range that it is tried over."""
    yield from _of_bearing(scene)
    yield from _of_operation(scene)
    yield from _of_oil(scene)
    yield from _of_surface(scene)
    yield from _of_friction(scene)


def times(
    name: str, unit: str, value: float, factors: tuple[float, float], scene_at: Callable[[float], Scene], source: str
) -> Variation:
    """From one multiple of the scene's value to another."""
    low, high = (value * factor for factor in factors)
    return Variation(name=name, unit=unit, value=value, low=low, high=high, scene_at=scene_at, source=source)


def about(
    name: str, unit: str, value: float, step: float, scene_at: Callable[[float], Scene], source: str
) -> Variation:
    """As far down as up."""
    return Variation(
        name=name, unit=unit, value=value, low=value - step, high=value + step, scene_at=scene_at, source=source
    )


def _of_bearing(scene: Scene) -> Iterator[Variation]:
    bearing, angle = scene.bearing, scene.contact_angle
    ball = bearing.ball_material

    def of_bodies(change: Callable[[Material], Material]) -> Scene:
        """Balls and rings alike."""
        rings = {
            race: replace(getattr(bearing, race), material=change(getattr(bearing, race).material)) for race in RACES
        }
        return of_bearing(replace(bearing, ball_material=change(ball), **rings))

    def of_bearing(changed: Bearing) -> Scene:
        return replace(scene, bearing=changed)

    yield times(
        *("Young's modulus", "Pa", ball.youngs_modulus, (0.95, 1.05)),
        lambda v: of_bodies(lambda m: replace(m, youngs_modulus=m.youngs_modulus * v / ball.youngs_modulus)),
        "of balls and rings together; bearing steel in suppliers' sheets: 190 to 210 GPa, 5 % about its middle",
    )
    yield about(
        *("Poisson's ratio", "1", ball.poisson_ratio, 0.015),
        lambda v: of_bodies(lambda m: replace(m, poisson_ratio=m.poisson_ratio + v - ball.poisson_ratio)),
        "of balls and rings together; bearing steel in suppliers' sheets: 0.27 to 0.30, 0.015 about its middle",
    )
    for race in RACES:
        groove = getattr(bearing, race)

        def of_groove(conformity: float, race: str = race) -> Scene:
            changed = replace(getattr(bearing, race), groove_radius=conformity * bearing.ball_diameter)
            return of_bearing(replace(bearing, **{race: changed}))

        yield about(
            *(f"conformity, {race}", "1", groove.groove_radius / bearing.ball_diameter, 0.005),
            of_groove,
            "groove radius over ball diameter; judgement: 0.04 mm of a groove's radius in a ball of 8 mm",
        )
    if bearing.kind == "thrust":
        return
    if angle.rule == "given":
        assert angle.value is not None
        yield times(
            *("contact angle", "rad", angle.value, (0.9, 1.1)),
            lambda v: replace(scene, contact_angle=replace(angle, value=v)),
            "judgement",
        )
    elif angle.free is not None:
        yield times(
            *("free contact angle", "rad", angle.free, (0.9, 1.1)),
            lambda v: replace(scene, contact_angle=replace(angle, free=v)),
            "judgement; dimensions that are rounded to 0.01 mm leave more",
        )
    else:
        yield about(
            *("diametral clearance", "m", bearing.diametral_clearance, 5e-6),
            lambda v: of_bearing(with_clearance(bearing, v)),
            "judgement; a class of clearance of ISO 5753 (not seen) is some 15 um wide in a bearing of this size",
        )


def with_clearance(bearing: Bearing, clearance: float) -> Bearing:
    """With another diametral clearance, m, by the outer ring's groove."""
    grown = bearing.outer.bottom_radius + (clearance - bearing.diametral_clearance) / 2
    return replace(bearing, outer=replace(bearing.outer, bottom_radius=grown))


def _of_operation(scene: Scene) -> Iterator[Variation]:
    operation = scene.operation
    largest = {
        name: float(np.max(np.abs(getattr(operation, name)))) for name in ("axial_load", "radial_load", "moment")
    }
    first = "axial_load" if largest["axial_load"] else "radial_load" if largest["radial_load"] else "moment"
    value = largest[first]
    together = [name.replace("_", " ") for name, most in largest.items() if most]

    def loaded(changed: float) -> Scene:
        moved = {name: getattr(operation, name) * (changed / value) for name in largest}
        return replace(scene, operation=replace(operation, **moved))

    if value:
        words = together[0] if len(together) == 1 else f"{together[0]}, with it {' and '.join(together[1:])}"
        yield times(words, "N m" if first == "moment" else "N", value, (0.9, 1.1), loaded, "judgement")


def _of_oil(scene: Scene) -> Iterator[Variation]:
    oil = scene.lubricant
    if oil is None:
        return

    def at(name: str) -> Callable[[float], Scene]:
        return lambda value: replace(scene, lubricant=replace(oil, **{name: value}))

    yield times(
        *("viscosity", "Pa s", oil.viscosity, (0.9, 1.1), at("viscosity")),
        "a grade of ISO 3448 (not seen) is 10 % about its middle",
    )
    yield about("oil temperature", "K", oil.temperature, 5.0, at("temperature"), "judgement, at the inlet of a contact")
    yield times(
        *("pressure-viscosity", "1/Pa", oil.pressure_viscosity, (0.7, 1.3), at("pressure_viscosity")),
        "mineral oils of 0.03 to 0.05 Pa s: 14 to 28 1/GPa (Stachowiak and Batchelor, Engineering Tribology, table "
        "2.3)",
    )
    yield times(
        *("Eyring stress", "Pa", oil.eyring_stress, (0.5, 2.0), at("eyring_stress")),
        "usual are 2 to 10 MPa, no source seen",
    )
    yield times(
        *("limiting shear", "1", oil.limiting_shear, (0.75, 1.25), at("limiting_shear")),
        "over the pressure; usual are 0.05 to 0.08, no source seen",
    )


def _of_surface(scene: Scene) -> Iterator[Variation]:
    surface, oil = scene.surface, scene.lubricant
    if surface is None or oil is None:  # the torque does not ask for it
        return

    def at(name: str) -> Callable[[float], Scene]:
        return lambda value: replace(scene, surface=replace(surface, **{name: value}))

    if surface.rms_roughness is not None and surface.autocorrelation is not None:
        rough, correlation, ball = surface.rms_roughness, surface.autocorrelation, surface.ball_rms_roughness

        def rougher(value: float) -> Scene:
            other = None if ball is None else ball * value / rough
            return replace(scene, surface=replace(surface, rms_roughness=value, ball_rms_roughness=other))

        def longer(value: float) -> Scene:
            scaled = replace(correlation, length=value, spacing=correlation.spacing * value / correlation.length)
            return replace(scene, surface=replace(surface, autocorrelation=scaled))

        if rough:
            yield times("rms roughness", "m", rough, (0.8, 1.2), rougher, "of ball and race together; judgement")
        yield times(
            *("autocorrelation length", "m", correlation.length, (0.5, 2.0), longer),
            "with its spacing; judgement",
        )
    yield times(
        *("boundary friction", "1", surface.boundary_friction, (0.7, 1.3), at("boundary_friction")),
        "usual are 0.08 to 0.15, no source seen",
    )
    if surface.hardness is not None:
        yield times(
            *("hardness", "Pa", surface.hardness, (0.87, 1.13), at("hardness")),
            "60 to 67 HRC, suppliers' sheets of bearing steel; table to GPa not seen",
        )


def _of_friction(scene: Scene) -> Iterator[Variation]:
    if not scene.has_friction:
        return
    if scene.friction_coefficient is not None:
        yield times(
            *("friction coefficient", "1", scene.friction_coefficient, (0.8, 1.2)),
            lambda v: replace(scene, friction_coefficient=v),
            "judgement",
        )
    if scene.hysteresis_loss is not None:
        low, high = HYSTERESIS_LOSS
        yield Variation(
            name="hysteresis loss",
            unit="1",
            value=scene.hysteresis_loss,
            low=min(low, scene.hysteresis_loss),
            high=max(high, scene.hysteresis_loss),
            scene_at=lambda v: replace(scene, hysteresis_loss=v),
            source="in use for bearing steel, none of them measured",
        )
    for name in ("seals", "drag"):
        value = getattr(scene.losses, name)
        if value:

            def declared(changed: float, name: str = name) -> Scene:
                return replace(scene, losses=replace(scene.losses, **{name: changed}))

            yield times(f"declared {name}", "N m", value, (0.8, 1.2), declared, "judgement")
