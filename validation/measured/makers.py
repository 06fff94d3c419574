"""Makers' formulas part by part: SKF's rolling and sliding, and FAG's whole torque, of seven deep groove bearings."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from analytic.catalog.bearing_rows import find_bearing
from analytic.makers import case_of, skf_parts
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from validation.catalogue.torque import scene_at
from validation.measured.anchor import Anchor
from validation.measured.fag import fag_torque
from validation.study import markdown

BEARINGS = ("6004", "6204", "6205", "6208", "6212", "6305", "6310")
LOADS = {"radial": "0.05 C radial", "axial": "0.02 C0 axial"}
SKF_FILM = 0.05  # SKF's coefficient of a full film of mineral oil
FIT = "a fit to unpublished tests of whole bearings, and to nothing here"


def makers_parts() -> Iterator[Anchor]:
    for case, load in LOADS.items():
        scenes = [scene_at(find_bearing(name), case) for name in BEARINGS]
        words = f"of {len(BEARINGS)} deep groove bearings, {load}, 1000 rpm"
        yield from _skf(scenes, words)
        total = np.sum(parts(scenes), axis=0)
        for end, theirs in zip(
            ("least", "largest"), np.hstack([fag_torque(case_of(each)) for each in scenes]), strict=True
        ):
            yield Anchor(
                what=f"torque {words}",
                source=f"FAG with the {end} factors [FAG2002]",
                kind="maker's formula",
                theirs=1e3 * theirs,
                ours=total,
                unit="N mm",
                worth=FIT,
            )


def _skf(scenes: list[Scene], words: str) -> Iterator[Anchor]:
    """Both parts of SKF's torque, N mm; ours as they are, with another law of elastic rolling, and with less."""
    theirs = 1e3 * np.hstack([skf_parts(case_of(each), lubrication="oil_bath") for each in scenes])
    houpert = [replace(each, elastic_rolling="houpert") for each in scenes]
    bare = [replace(each, effects={**each.effects, "unloaded_balls": "off"}) for each in scenes]
    for own, part, more, worth in (
        (scenes, 1, "", FIT),
        (houpert, 1, ", elastic rolling by Houpert's law", f"{FIT}; both laws have a friction coefficient of 0.05"),
        (scenes, 0, "", FIT),
        (bare, 0, ", without unloaded balls", FIT),
    ):
        if own is bare and not np.any(case_of(scenes[0]).radial_load):
            continue  # under thrust every ball is loaded
        name = ("rolling", "sliding")[part]
        yield Anchor(
            what=f"{name} {words}{more}",
            source=f"SKF's {name} part",
            kind="maker's formula",
            theirs=theirs[part],
            ours=parts(own)[part],
            unit="N mm",
            worth=worth,
        )


def sliding_page() -> Iterator[str]:
    """sliding.md, in Markdown: what the ratio of our sliding to SKF's sliding part is made of."""
    parts = ("= friction coefficient over 0.05", "x geometry", "x 0.05 over SKF's coefficient")
    yield from markdown(("load", "ours over SKF's", *parts), _split())


def _split() -> Iterator[tuple[str, ...]]:
    for case, load in LOADS.items():
        scenes = [scene_at(find_bearing(name), case) for name in BEARINGS]
        at_film_friction = [replace(each, surface=None, friction_coefficient=SKF_FILM) for each in scenes]
        # Endlessly thick oil has SKF's coefficient of a full film.
        cases = [case_of(each) for each in scenes]
        theirs, in_film = (
            1e3 * np.hstack([skf_parts(each, lubrication="oil_bath")[1] for each in of_oil])
            for of_oil in (cases, [each._replace(kinematic_viscosity=1.0) for each in cases])
        )
        ours, same_coefficient = slips(scenes), slips(at_film_friction)
        factors = ours / theirs, ours / same_coefficient, same_coefficient / in_film, in_film / theirs
        yield load, *(f"{np.min(each):.2f} to {np.max(each):.2f}" for each in factors)


def slips(scenes: list[Scene]) -> Array:
    """Sliding by spin and conformity, N mm, (scenes,)."""
    found = [friction_torque(scene).torque for scene in scenes]
    return 1e3 * np.array([present(each.spin)[0] + present(each.conformity)[0] for each in found])


def present(part: Array | None) -> Array:
    """A part of the torque that every scene here has."""
    assert part is not None
    return part


def parts(scenes: list[Scene]) -> tuple[Array, Array]:
    """Hydrodynamic rolling, and all else: sliding in the contacts and elastic rolling, N mm, each (scenes,)."""
    found = [friction_torque(scene).torque for scene in scenes]
    rolling = np.array([0.0 if each.rolling is None else each.rolling[0] for each in found])
    return 1e3 * rolling, 1e3 * (np.array([each.total[0] for each in found]) - rolling)
