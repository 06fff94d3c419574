"""Bearings that a user would try, on the command line: other materials, unknown dimensions, no cage."""

import json
from pathlib import Path
from typing import Any

import pytest

STEEL, NITRIDE, PEEK = (206e9, 0.3), (310e9, 0.26), (3.6e9, 0.38)  # E, Pa, and nu
HEAD = 'name = "tried"\ntolerance = "5 %"\n[bearing]\n'
ANGLE = 'contact_angle = { rule = "given", value = "0.3 rad" }\n'
OPERATION = '[operation]\naxial_load = "30 N"\ninner_speed = "300 rpm"\n'
BALL = (
    'ball_mass = "0.84 g"\n'
    'ball_material = { name = "Si3N4", youngs_modulus = "310 GPa", poisson_ratio = 0.26, density = "3200 kg/m^3" }\n'
)
SCENES = {
    "steel": HEAD + 'catalog = "paper_6205"\n' + ANGLE + OPERATION,
    "hybrid": HEAD + 'catalog = "paper_6205"\n' + BALL + ANGLE + OPERATION,
    "peek races": HEAD
    + 'catalog = "paper_6205"\ninner = { material = "peek" }\nouter = { material = "peek" }\n'
    + ANGLE
    + OPERATION,
    "no bore": HEAD
    + 'name = "own"\nball_count = 9\nball_diameter = "7.94 mm"\nball_mass = "2.04 g"\nball_material = "steel"\n'
    + ANGLE
    + 'inner = { bottom_radius = "15.53 mm", groove_radius = "4.13 mm", shoulder_half_width = "3.1 mm", '
    'material = "steel" }\n'
    'outer = { bottom_radius = "23.48 mm", groove_radius = "4.21 mm", shoulder_half_width = "3.1 mm", '
    'material = "steel" }\n' + OPERATION,
}


@pytest.fixture
def run(command, tmp_path: Path):
    """Runs a command on one of `SCENES`: status, standard output and standard error."""

    def run(name: str, scene: str, *options: str) -> tuple[int, str, str]:
        path = tmp_path / "scene.toml"
        path.write_text(SCENES[scene], "utf-8")
        return command(name, str(path), *options)

    return run


def contact_modulus(first: tuple[float, float], second: tuple[float, float]) -> float:
    return 1 / sum((1 - ratio**2) / modulus for modulus, ratio in (first, second))


def solved(run: Any, scene: str, *options: str) -> dict[str, Any]:
    """What --json prints; nothing else may be on either stream."""
    status, out, err = run("contact", scene, *options, "--json")
    assert (status, err) == (0, "")
    return json.loads(out)


@pytest.mark.usefixtures("coarse")
@pytest.mark.parametrize(
    ("scene", "pair", "materials"),
    [
        ("hybrid", "inner", (NITRIDE, STEEL)),
        pytest.param("peek races", "outer", (STEEL, PEEK), marks=pytest.mark.slow),
    ],
)
def test_a_race_of_other_materials_is_as_stiff_as_its_modulus(
    run, scene: str, pair: str, materials: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    """At one angle, stiffness scales as E* and peak pressure as E*^(2/3): exactly for Hertz, nearly for the groove."""
    steel, other = (solved(run, name, "--pair", pair, "--load", "12 N") for name in ("steel", scene))
    softer = contact_modulus(*materials) / contact_modulus(STEEL, STEEL)
    for name, by, power, within in (
        ("stiffness", "production", 1, 1e-9),  # round-off
        # The groove's shape moves it by 2 % at most, and of one material as of the other but for a part of that.
        ("stiffness", "reference", 1, 0.02),
        ("peak_pressure", "reference", 2 / 3, 0.02),
    ):
        ratio = other["quantities"][name][by] / steel["quantities"][name][by]
        assert ratio == pytest.approx(softer**power, rel=within)
    assert other["verdict"] == "pass"


@pytest.mark.slow
@pytest.mark.usefixtures("coarse")
def test_without_its_bore_everything_but_the_ring_is_checked(run) -> None:
    """And without a [cage] there is no pocket; standard output holds JSON alone, the warning is in it."""
    status, out, err = run("validate", "no bore", "--json")
    found = json.loads(out)
    assert (status, err) == (0, "")
    assert [(contact["pair"], contact["ring"]) for contact in found["contacts"]] == [("inner", None), ("outer", None)]
    told = " ".join(found["warnings"])
    assert "bore_diameter" in told
    assert "outside_diameter" in told


@pytest.mark.parametrize(
    ("scene", "options", "word"),
    [("no bore", ("--geometry", "ring"), "bore_diameter"), ("steel", ("--pair", "pocket"), "[cage]")],
)
def test_a_quantity_missing_in_the_scene_is_named(run, scene: str, options: tuple[str, ...], word: str) -> None:
    status, out, err = run("contact", scene, *options, "--json")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert word in err
