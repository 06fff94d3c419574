"""Random scenes of all kinds, each from its own seed, for tests over many of them."""

from collections.abc import Iterator

import numpy as np

from analytic.scene import Scene
from analytic.scenefile.read import parse_scene

BEARINGS = ("6206", "6310/C3", "7205 BEP", "61804", "16008", "6002")
OILS = ("ISO VG 32", "ISO VG 68", "ISO VG 150")
THRUST = """
[bearing]
kind = "thrust"
ball_count = {balls}
ball_diameter = "{ball:.6g} mm"
pitch_diameter = "{pitch:.6g} mm"
inner = {{ groove_radius = "{groove:.6g} mm", shoulder_height = "{shoulder:.6g} mm" }}
outer = {{ groove_radius = "{groove:.6g} mm", shoulder_height = "{shoulder:.6g} mm" }}
"""


def drawn_scene(seed: int) -> Scene:
    """A scene of one of six kinds: dry, oiled, with a cage, with declared losses, a thrust bearing, a pair."""
    return parse_scene("\n".join(_lines(seed)), origin=f"drawn scene {seed}")


def _lines(seed: int) -> Iterator[str]:
    rng = np.random.default_rng(seed)
    kind = ("dry", "oiled", "cage", "losses", "thrust", "pair")[seed % 6]
    yield f'name = "drawn {seed}, {kind}"\ntolerance = "{rng.choice([5, 3])} %"'
    if kind == "thrust":
        ball = rng.uniform(3, 12)
        shape = {"balls": rng.integers(3, 15), "ball": ball, "pitch": ball * rng.uniform(5, 8)}
        yield THRUST.format(**shape, groove=ball * rng.uniform(0.52, 0.6), shoulder=0.2 * ball)
    else:
        yield f'[bearing]\ncatalog = "{rng.choice(BEARINGS)}"'
    if kind == "pair":
        kind_of_pair = rng.choice(["O", "X", "tandem"])
        yield f'[arrangement]\nkind = "{kind_of_pair}"\ndistance = "{rng.uniform(20, 40):.4g} mm"'
        if kind_of_pair != "tandem":
            yield f'preload = "{rng.uniform(100, 300):.4g} N"'
    yield "[operation]"
    yield f'axial_load = "{rng.uniform(50, 900):.5g} N"'
    radial = kind not in ("thrust", "pair") and rng.random() < 0.4
    if radial:
        yield f'radial_load = ["{rng.uniform(50, 900):.5g} N", "{rng.uniform(900, 1500):.5g} N"]'
        yield f'inner_speed = "{rng.uniform(30, 4000):.5g} rpm"'
    else:
        speeds = np.sort(rng.uniform(30, 2000 if kind != "thrust" else 300, rng.integers(1, 4)))
        listed = ", ".join(f'"{speed:.5g} rpm"' for speed in speeds)
        yield f"inner_speed = [{listed}]"
    if kind not in ("thrust", "pair"):
        yield "down = [0, -1, 0]"  # without it the torque is computed in six directions
    dry = kind == "dry" or rng.random() < 0.3
    if not dry:
        yield f'[lubricant]\nname = "{rng.choice(OILS)}"\ntemperature = "{rng.uniform(30, 90):.4g} degC"'
        yield '[surface]\nfinish = "ground and honed"'
    yield f"[friction]\nhysteresis_loss = {rng.uniform(0.003, 0.02):.4g}"
    if radial or kind == "pair":
        yield 'spin_rule = "balanced"'  # free balls that are loaded unequally take seconds
    if dry:
        yield f"coefficient = {rng.uniform(0.02, 0.15):.4g}"
    if kind == "cage":
        yield f'[cage]\nmass = "{rng.uniform(2, 20):.3g} g"\nmaterial = "steel"\npocket_clearance = "0.2 mm"'
        yield f'wall_thickness = "{rng.uniform(0.7, 1.1):.3g} mm"'
        yield '[effects]\ncage_dynamics = "off"'  # each motion takes seconds
    if kind == "losses":
        yield f'[losses]\nseals = "{rng.uniform(1, 30):.4g} N mm"'
