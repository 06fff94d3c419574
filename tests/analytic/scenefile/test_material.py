"""Materials by name, whole and completed, in scenes and from Python."""

import pytest

import analytic
from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Material
from tests.analytic.scenefile.scene_texts import changed, refusal, scene

BEARING = 'catalog = "paper_6205"'


def ball(material: str) -> Material:
    return scene(changed(BEARING, f"{BEARING}\nball_material = {material}")).bearing.ball_material


def test_a_named_material_is_that_of_the_prints() -> None:
    steel = ball('"100Cr6"')
    assert (steel.youngs_modulus, steel.poisson_ratio, steel.density) == (208e9, 0.3, 7830.0)
    assert steel.thermal_expansion == pytest.approx(12.5e-6, rel=1e-12)  # round-off
    assert steel == ball('"52100"') == ball('"aisi 52100"') == analytic.material("100cr6")
    assert analytic.material("Si3N4") != analytic.material("silicon_nitride")


def test_a_table_completes_a_material_of_the_catalog() -> None:
    completed = ball('{ name = "440C", poisson_ratio = 0.284, thermal_expansion = "9.9e-6 1/K" }')
    assert (completed.youngs_modulus, completed.poisson_ratio, completed.density) == (200e9, 0.284, 7680.0)
    assert completed.thermal_expansion == pytest.approx(9.9e-6, rel=1e-12)
    assert "given: poisson_ratio, thermal_expansion" in completed.source
    assert analytic.material("440C", poisson_ratio=0.284, thermal_expansion=9.9e-6) == completed


def test_a_material_that_lacks_a_constant_names_it() -> None:
    message = refusal(changed(BEARING, f'{BEARING}\nball_material = "440C"'))
    assert "bearing.ball_material = '440C' has no sourced poisson_ratio" in message
    assert "{ name = '440C', poisson_ratio = 0.29 }" in message
    assert "poisson_ratio is missing" in refusal(changed(BEARING, f'{BEARING}\nball_material = {{ name = "M50" }}'))
    with pytest.raises(InputError, match="material 'brass' has no sourced poisson_ratio"):
        analytic.material("brass")


@pytest.mark.parametrize("name", catalog.names("materials"))
def test_every_material_of_the_catalog_is_read(name: str) -> None:
    read = analytic.material(name, poisson_ratio=0.31)
    assert read.poisson_ratio == 0.31
    assert 1e9 < read.youngs_modulus < 400e9
    assert 1000 < read.density < 9000
    assert read.thermal_expansion is None or 2e-6 < read.thermal_expansion < 20e-6
