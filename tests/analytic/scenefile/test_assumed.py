"""The table [assumed]: inputs that nobody knows, with their sources; the built-in scene names all of its own."""

import pytest

from analytic.scenefile.inputs import stated_inputs
from analytic.scenefile.read import load_scene
from tests.analytic.scenefile.scene_texts import OILED, refusal, scene

ASSUMED = OILED + '[assumed]\nlubricant.temperature = "a guess"\nsurface.boundary_friction = "a book"\n'


def test_an_assumed_input_has_its_value_and_its_source() -> None:
    plain, told = ({each.key: each for each in stated_inputs(scene(text))} for text in (OILED, ASSUMED))
    assert set(told) - set(plain) == {"lubricant.temperature", "surface.boundary_friction"}
    parsed = scene(ASSUMED)
    assert parsed.lubricant is not None
    assert parsed.surface is not None
    temperature, friction = told["lubricant.temperature"], told["surface.boundary_friction"]
    assert (temperature.value, temperature.unit) == (parsed.lubricant.temperature, "K")
    assert (temperature.status, temperature.source) == ("assumed", "a guess")
    assert (friction.value, friction.unit, friction.source) == (parsed.surface.boundary_friction, "1", "a book")
    assert all(told[key] == plain[key] for key in plain)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('cage.start = "slowly"', ("assumed.cage.start", "does not have; leave it out")),
        ('operation.radial_load = "a guess"', ("assumed.operation.radial_load", "does not have")),
        ("surface.hardness = 7.8", ("assumed.surface.hardness = 7.8", "give printable text")),
        ('surface.hardnes = "a book"', ("assumed.surface.hardnes", "did you mean hardness?")),
        ('model.film = "a book"', ("assumed.model", "unknown key")),
    ],
)
def test_what_cannot_be_assumed_is_refused_in_one_line(line: str, words: tuple[str, ...]) -> None:
    message = refusal(f"{OILED}[assumed]\n{line}\n")
    assert "\n" not in message
    for word in words:
        assert word in message


def test_the_built_in_scene_names_everything_that_the_paper_leaves_open() -> None:
    built_in = load_scene("paper_6205")
    inputs = {each.key: each for each in stated_inputs(built_in)}
    left_open = {f"lubricant.{key}" for key in ("viscosity", "pressure_viscosity", "limiting_shear")}
    left_open |= {f"surface.{key}" for key in ("hardness", "boundary_friction", "autocorrelation.length")}
    left_open |= {"friction.hysteresis_loss", "bearing.ball_material"}
    left_open |= {f"cage.{key}" for key in ("pocket_clearance", "wall_thickness", "friction_coefficient", "start")}
    assert {key for key in left_open if inputs[key].status != "assumed"} == set()
    assert all(each.source for each in inputs.values())
    assert [key for key, each in inputs.items() if each.status == "given"] == ["surface.rms_roughness"]
    assert inputs["cage.pocket_clearance"].value == pytest.approx(0.2e-3, rel=1e-9)  # round-off of a difference
    assert (inputs["cage.start"].value, inputs["cage.start"].unit) == ("rest", "")
