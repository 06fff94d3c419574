"""Makers' formulas part by part: SKF's rolling and sliding, and FAG's whole torque, of seven deep groove bearings."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from analytic.catalog.bearing_rows import find_bearing
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from fembearing.verify.torque.catalogue_models import case_of, skf_parts
from validation.catalogue.torque import scene_at
from validation.measured.anchor import Anchor
from validation.measured.fag import fag_torque

BEARINGS = ("6004", "6204", "6205", "6208", "6212", "6305", "6310")
LOADS = {"radial": "0.05 C radial", "axial": "0.02 C0 axial"}
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


def parts(scenes: list[Scene]) -> tuple[Array, Array]:
    """Hydrodynamic rolling, and all else: sliding in the contacts and elastic rolling, N mm, each (scenes,)."""
    found = [friction_torque(scene).torque for scene in scenes]
    rolling = np.array([0.0 if each.rolling is None else each.rolling[0] for each in found])
    return 1e3 * rolling, 1e3 * (np.array([each.total[0] for each in found]) - rolling)
