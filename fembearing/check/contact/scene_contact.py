"""Which bearings and which contact of a scene are compared, and by which recipe it is meshed."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.contact.geometry import RACES, Race, pocket_contact, race_contact
from analytic.errors import InputError, require_non_negative
from analytic.numerics.records import Records
from analytic.pair import pair_in_series
from analytic.scene import Contact, Pair, Scene
from analytic.torque import loaded_balls_of
from analytic.words import NEWTON, NEWTON_MILLIMETRE, shown
from fembearing.mesh.recipe import Geometry, Recipe, load_recipe

Shape = Geometry | Literal["ring"]  # "ring": the real contact, and separately what the ring adds
RECIPES: dict[Shape, str] = {"real": "race", "hertzian": "hertzian", "wall": "wall", "ring": "race"}
OfPair = Literal["first", "second"]
NAMES: tuple[OfPair, OfPair] = ("first", "second")  # as in the torque of a pair
POCKET_LOAD = 28.0  # N: the largest ball-cage force that the paper reports


def contact_of(scene: Scene, *, pair: Pair, load: float | None = None) -> Contact:
    """The contact of the heaviest ball at any operating point, or the same contact under `load`, N.

    Raises InputError for another pair than inner, outer and pocket, and for the pocket of a scene without a cage.
    """
    if pair not in (*RACES, "pocket"):
        raise InputError(f"pair = {shown(pair)} is no contact of a ball; give inner, outer or pocket")
    if pair == "pocket":
        if scene.cage is None:
            raise InputError("the scene has no [cage], so there is no pocket: add an empty [cage] for the catalog's")
        return pocket_contact(scene.bearing, scene.cage, load=POCKET_LOAD if load is None else load)
    if load is not None:
        require_non_negative(load=load)
    with traced_to_load(scene, pair=pair, load=load):
        contact = heaviest_contact(scene, pair)
    return contact if load is None else replace(contact, load=float(load))  # a float32 would compute in its precision


def heaviest_contact(scene: Scene, race: Race) -> Contact:
    """The most heavily loaded ball at any operating point, on one race, with its load and contact angle there.

    Raises InputError as balls_of, for a contact beyond its shoulder, and where the shoulders are not known.
    """
    balls = balls_of(scene)
    return contact_at(scene, balls, race, heaviest_place(balls))


def heaviest_place(balls: Records) -> tuple[int, int]:
    """Operating point and column of the most heavily loaded ball, from 0: the same one on both races."""
    largest = balls["load"].max(axis=2)
    point, ball = np.unravel_index(np.argmax(largest), largest.shape)
    return int(point), int(ball)


def contact_at(scene: Scene, balls: Records, race: Race, place: tuple[int, int]) -> Contact:
    """The contact of one ball on one race, as `heaviest_contact`; place : as `heaviest_place`"""
    side, ball = RACES.index(race), balls[place]
    angle, load = float(ball["angle"][side]), float(ball["load"][side])
    return race_contact(scene.bearing, race, contact_angle=abs(angle), ball_load=load)


def balls_of(scene: Scene) -> Records:
    """(n, m) `analytic.solve.records.BALL` at every operating point, with Hertz's contacts.

    Raises InputError as friction_torque does.
    """
    if scene.arrangement is not None:
        raise InputError(
            "[arrangement] has two bearings, and contacts are those of one: leave it out and give the loads of one "
            "bearing, which `fembearing torque` prints"
        )
    return loaded_balls_of(replace(scene, effects={**scene.effects, "finite_geometry": "off"}))


@contextmanager
def traced_to_load(scene: Scene, *, pair: Pair, load: float | None) -> Iterator[None]:
    """Put the load that the user gave in front of any error that it causes."""
    try:
        yield
    except InputError as problem:
        if load is None and pair != "pocket":
            cause = f"operation.axial_load = {scene.operation.axial_load.max():g} N"
            for name, unit in (("radial_load", NEWTON), ("moment", NEWTON_MILLIMETRE)):
                largest = np.max(np.abs(getattr(scene.operation, name)))
                cause += f", operation.{name} = {unit.written(largest, 'g')}" if largest else ""
        else:
            cause = f"load = {POCKET_LOAD if load is None else load:g} N"
        raise InputError(f"{cause}: {problem}") from problem


def recipe_of(geometry: Shape, *, pair: Pair) -> Recipe:
    """The mesh recipe of a geometry. Raises InputError for an unknown one, and for a sheet in place of a race."""
    if geometry not in RECIPES:
        raise InputError(f"geometry = {shown(geometry)} is not known; give {' or '.join(RECIPES)}")
    if geometry == "wall" and pair != "pocket":
        raise InputError(f"geometry 'wall' is that of a pocket; the {pair} race has 'real' and 'hertzian'")
    return load_recipe(RECIPES[geometry])


def as_meshed(contact: Contact, *, recipe: Recipe) -> Contact:
    """The contact that a recipe meshes: the half spaces of Hertz have no shoulder."""
    return replace(contact, shoulder=math.inf, far_shoulder=math.inf) if recipe.geometry == "hertzian" else contact


def which_bearing(name: str | None) -> str:
    """What follows the name of a part of one bearing; empty where there is one."""
    return "" if name is None else f" of the {name} bearing"


def place_of(pair: str, geometry: str, bearing: str | None = None) -> str:
    """Where the ball sits, for example "ball on inner race"; bearing : "first" or "second" of a pair"""
    if pair == "pocket":
        return "ball in cage pocket, " + ("sheet on its rim" if geometry == "wall" else "thick seat")
    return f"ball on {pair} race{which_bearing(bearing)}" + (", idealised" if geometry == "hertzian" else "")


@dataclass(frozen=True, kw_only=True, eq=False)
class OneBearing:
    """One bearing at the operating points at which its inner ring presses."""

    name: OfPair | None  # None: the scene has one
    scene: Scene  # without arrangement
    points: NDArray[np.intp]  # numbers of its operating points in the scene, from 0


def bearings_of(scene: Scene) -> Iterator[OneBearing]:
    """The bearing of a scene, or those of a pair, with loads by Hertz's contacts.

    A bearing whose inner ring presses nowhere is not among them. Raises InputError as friction_torque does.
    """
    if scene.arrangement is None:
        yield OneBearing(name=None, scene=scene, points=np.arange(scene.operation.as_series().inner_speed.size))
        return
    by_hertz = replace(scene, effects={**scene.effects, "finite_geometry": "off"})
    both = pair_in_series(by_hertz, scene.arrangement, None)
    for name, points, rows in zip(NAMES, both.points, both.rows, strict=True):
        if points.size:
            operation = both.scene.operation.as_series().at(rows)
            yield OneBearing(name=name, scene=replace(scene, arrangement=None, operation=operation), points=points)
