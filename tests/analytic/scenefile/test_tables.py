"""Tables of a scene: seats and pair, thrust bearings, surfaces, losses, reach of the oil, spreads, sources, report."""

import re
from math import pi, sqrt

import numpy as np
import pytest

from analytic import catalog
from analytic.mounting.clearance import Mounting, mounted
from analytic.prediction.spreads import uncertain_inputs
from analytic.scene import (
    Arrangement,
    Losses,
    Lubricant,
    Reach,
    ReportDetails,
    Scene,
    ShearedLand,
    ShearedPockets,
    Surface,
)
from analytic.scenefile.inputs import stated_inputs
from analytic.scenefile.parts import lubricant, material
from analytic.scenefile.read import load_scene, scene_of
from analytic.torque import friction_torque
from fembearing.provenance import provenance_of
from tests.analytic.scenefile.scene_texts import MINE, OILED, PLAIN, changed, refusal, scene
from tests.analytic.specimens import present
from tests.refusals import refused


def says(text: str, *patterns: str) -> str:
    """The message of one line that refuses the text; it matches each pattern."""
    message = refusal(text)
    assert message.isprintable()
    assert [each for each in patterns if not re.search(each, message)] == [], message
    return message


SCENE = """\
name = "installed"
tolerance = "5 %"
[bearing]
catalog = "6205"
{bearing}
[operation]
axial_load = "{load} N"
inner_speed = "1000 rpm"
[friction]
coefficient = 0.1
"""
SEATS = '[mounting]\nshaft_interference = "12 um"\nhousing_interference = "-5 um"\n'
WARM = 'inner_temperature = "75 degC"\nouter_temperature = "65 degC"\n'


def installed(more: str, *, bearing: str = "", load: float = 500) -> Scene:
    return scene(SCENE.format(bearing=bearing, load=load) + more)


def test_a_scene_holds_the_bearing_in_operation_and_its_clearances() -> None:
    plain, found = (
        installed("").bearing,
        installed(SEATS + WARM + 'shaft_bore = "8 mm"\nmounting_temperature = "22 degC"\n'),
    )
    steel = material("steel")
    mounting = Mounting(
        shaft_material=steel,
        housing_material=steel,
        shaft_interference=12e-6,
        housing_interference=-5e-6,
        shaft_bore=8e-3,
        inner_temperature=348.15,
        outer_temperature=338.15,
        mounting_temperature=295.15,
    )
    warm, clearances = mounted(plain, mounting)
    assert found.clearances == clearances
    assert found.bearing == warm
    assert found.bearing.diametral_clearance == clearances.operating < clearances.mounted < clearances.unmounted
    assert clearances.unmounted == plain.diametral_clearance
    assert installed("").clearances is None


def test_the_pocket_keeps_its_size() -> None:
    cage = '[cage]\npocket_clearance = "0.2 mm"\nwall_thickness = "0.9 mm"\nmass = "6 g"\nmaterial = "peek"\n'
    cold, warm = (installed(more + cage).cage for more in ("", SEATS + WARM))
    assert cold == warm


def test_a_nominal_angle_gives_the_clearance_that_the_seats_change() -> None:
    found = installed(SEATS, bearing='contact_angle = { nominal = "15 deg" }')
    assert found.clearances is not None
    distance = installed("").bearing.groove_centre_distance
    np.testing.assert_allclose(found.clearances.unmounted, 2 * distance * (1 - np.cos(np.radians(15))), rtol=1e-9)


def test_an_arrangement_is_read() -> None:
    found = installed('[arrangement]\nkind = "X"\noffset = "8 um"\ndistance = "40 mm"\n')
    assert found.arrangement == Arrangement(kind="X", offset=8e-6, distance=40e-3)
    assert installed('[arrangement]\nkind = "O"\npreload = "100 N"\n', load=0).operation.axial_load[0] == 0


@pytest.mark.parametrize(
    ("more", "bearing", "words"),
    [
        (SEATS, 'contact_angle = { free = "12 deg" }', r"bearing\.contact_angle\.free = '12 deg' leaves the clearance"),
        (SEATS, 'contact_angle = { rule = "given", value = "12 deg" }', r"fixes the contact angle, which \[mounting\]"),
        (SEATS + 'inner_temperature = "75 degC"\n', "", r"mounting\.outer_temperature is missing"),
        (SEATS + 'ball_temperature = "75 degC"\n', "", r"mounting\.ball_temperature = '75 degC' goes with"),
        (SEATS + 'shaft_bore = "30 mm"\n', "", r"mounting\.shaft_bore = '30 mm' must be below bearing.bore_diameter"),
        ('[mounting]\nshaft_interference = "12"\n', "", r"mounting\.shaft_interference = '12' .*12 um"),
        (SEATS + WARM + 'shaft_material = "peek"\n', "",
            r"mounting\.shaft_material = 'peek' 'peek' of the shaft has no"),
        ('[mounting]\nshaft_fit = "k5"\n', "",
            r"mounting\.shaft_fit = 'k5' is an unknown key; did you mean shaft_interference\?"),
        ('[mounting]\nhousing_fit = "H7"\n', "", r"did you mean housing_interference\?"),
        ('[arrangement]\nkind = "O"\n', "", r"arrangement = .* needs one of preload and offset"),
        ('[arrangement]\nkind = "tandem"\npreload = "9 N"\n', "", r"arrangement\.preload = '9 N' does not go"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\noffset = "3 um"\n', "",
            r"arrangement\.offset = '3 um' and preload both give the clamping of the pair; leave one of them out"),
        ('[arrangement]\nkind = "DB"\npreload = "9 N"\n', "", r"arrangement\.kind = 'DB' is .*; give \"O\" \(.*, DB\)"),
        ('[arrangement]\nkind = "DT"\npreload = "9 N"\n', "", r"arrangement\.kind = 'DT' is .* \"tandem\" \(DT\)"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\ndistance = "9 mm"\n', "",
            r"arrangement\.distance = '9 mm' must be at least bearing.width 15 mm"),
        ('[arrangement]\nkind = "O"\noffset = "3 mm"\n', "", r"arrangement\.offset = '3 mm' must be at most 685\.7 um"),
        ('[arrangement]\nkind = "X"\noffset = "0.5 mm"\n', 'inner = { shoulder_half_width = "2 mm" }',
            r"arrangement\.offset = '0.5 mm' must be at most .* um: there the balls reach a shoulder"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\n', 'contact_angle = { rule = "given", value = "12 deg" }',
            r"bearing\.contact_angle\.rule = 'given' fixes the contact angle, which the loads of a pair change"),
    ],
)  # fmt: skip
def test_a_mistake_of_seats_or_pair_is_one_line(more: str, bearing: str, words: str) -> None:
    says(SCENE.format(bearing=bearing, load=500) + more, words)


def test_the_largest_offset_is_that_of_the_shoulder() -> None:
    """The line between the groove centres is then at asin(w/r_g); |axial| = (A0 - P_d/2) tan of it, less the play."""
    found = installed("", bearing='inner = { shoulder_half_width = "2 mm" }').bearing
    distance, play = found.groove_centre_distance, found.diametral_clearance / 2
    steep, loose = np.arcsin(2e-3 / found.inner.groove_radius), np.arccos(1 - play / distance)
    most = 2 * (distance - play) * (np.tan(steep) - np.tan(loose)) * 1e6
    for offset, is_refused in ((most * 1.001, True), (most * 0.999, False)):
        more = f'[arrangement]\nkind = "O"\noffset = "{offset:.6f} um"\n'
        text = SCENE.format(bearing='inner = { shoulder_half_width = "2 mm" }', load=500) + more
        if is_refused:
            says(text, f"at most {most:.4g} um")
        else:
            scene(text)


THRUST = """\
name = "thrust"
tolerance = "4 %"
[bearing]
kind = "thrust"
ball_count = 13
ball_diameter = "7.1 mm"
pitch_diameter = "39 mm"
conformity = 0.53
[operation]
axial_load = "700 N"
inner_speed = "90 rpm"
[friction]
coefficient = 0.1
"""


def test_the_circle_of_the_balls_is_that_of_both_grooves() -> None:
    read = scene(THRUST)
    bearing = read.bearing
    assert (bearing.kind, bearing.inner, bearing.pitch_diameter) == ("thrust", bearing.outer, 39e-3)
    assert bearing.inner.bottom_radius == 19.5e-3
    np.testing.assert_allclose(bearing.inner.groove_radius, 0.53 * 7.1e-3, rtol=1e-15)  # one rounding
    assert (read.contact_angle.rule, read.contact_angle.value) == ("given", np.pi / 2)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('pitch_diameter = "39 mm"', "", "bearing.pitch_diameter is missing"),
        ('"39 mm"', '"7 mm"', "bearing.pitch_diameter.*must exceed ball_diameter 7.1 mm"),
        ("conformity = 0.53", "", "groove_radius is missing"),
        ("conformity = 0.53", 'conformity = 0.53\nclearance = "5 um"', 'bearing.clearance.*kind = "radial"'),
        ("conformity = 0.53", 'conformity = 0.53\ncontact_angle = { nominal = "60 deg" }',
            'bearing.contact_angle.*kind = "radial"'),
        ("conformity = 0.53", 'conformity = 0.53\nouter = { bottom_radius = "19 mm" }',
            'bearing.outer.bottom_radius.*kind = "radial"'),
        ("conformity = 0.53", "inner = { conformity = 0.53 }\nouter = { conformity = 0.54 }",
            "bearing.outer.groove_radius.*two equal grooves"),
        ("conformity = 0.53",
            'conformity = 0.53\ninner = { shoulder_height = "3.6 mm" }\nouter = { shoulder_height = "3.6 mm" }',
            "washers touch"),
        ("conformity = 0.53", 'conformity = 0.53\nbore_diameter = "40 mm"', "bearing.bore_diameter.*below"),
        ("conformity = 0.53", 'conformity = 0.53\noutside_diameter = "38 mm"', "bearing.outside_diameter.*exceed"),
        ('"90 rpm"', '"90 rpm"\nradial_load = "2 N"', "operation.radial_load.*axial_load alone"),
        ('"90 rpm"', '"90 rpm"\nmoment = "-2 N m"', "operation.moment.*axial_load alone"),
        ('"90 rpm"', '"90 rpm"\ntilt = "1 mrad"', "operation.tilt.*washers are parallel"),
        ("[friction]", '[mounting]\nshaft_interference = "5 um"\n[friction]', "mounting.*not modelled for a thrust"),
        ("[friction]", '[arrangement]\nkind = "O"\npreload = "5 N"\n[friction]', "arrangement.*not modelled for a"),
        ('kind = "thrust"', 'kind = "axial"', "bearing.kind"),
    ],
)  # fmt: skip
def test_what_does_not_go_with_washers_is_refused_in_one_line(old: str, new: str, words: str) -> None:
    says(changed(old, new, THRUST), words)


CAGE = """\
[cage]
pocket_clearance = "0.2 mm"
wall_thickness = "0.6 mm"
mass = "3 g"
material = "peek"
"""


@pytest.mark.parametrize("key", ['start = "rest"', 'land = { ring = "outer", clearance = "0.3 mm", width = "5 mm" }'])
def test_a_cage_rests_on_its_balls(key: str) -> None:
    assert scene(THRUST + CAGE).cage is not None
    says(THRUST + CAGE + key, f"cage.{key.split()[0]}.*not modelled in a thrust bearing")


def surface(text: str) -> Surface:
    return present(scene(f"{PLAIN}[surface]\n{text}").surface)


def test_ra_becomes_the_rms_of_gaussian_heights() -> None:
    heights = np.random.default_rng(7).normal(scale=0.31, size=400_000)  # um
    ra = float(np.mean(np.abs(heights)))
    read = surface(f'Ra = "{ra!r} um"')
    # A mean of 400 000 scatters by 0.76/sqrt(400 000) = 0.12 %; four times that.
    assert read.rms_roughness == pytest.approx(np.std(heights) * 1e-6, rel=0.005)
    assert read.origins["rms_roughness"].status == "given"
    assert read.origins["autocorrelation.length"].status == "assumed"
    assert read.ball_rms_roughness is None


def test_a_finish_is_within_its_limits_and_says_that_it_is_assumed() -> None:
    finishes = catalog.rows("finishes")
    assert len(finishes) == 3
    for name, row in finishes.items():
        middle, low, high = (float(row[f"{column} [um]"]) for column in ("Ra", "low", "high"))
        assert low < middle < high
        read = surface(f'finish = "{name}"\nball_rms_roughness = "0.011 um"')
        assert present(read.rms_roughness) / sqrt(pi / 2) == pytest.approx(middle * 1e-6, rel=1e-12)  # round-off
        origin = read.origins["rms_roughness"]
        assert origin.status == "assumed"
        # a uniform distribution between both limits of Ra, of which Sq is sqrt(pi/2) times
        spread = (high - low) * 1e-6 / sqrt(12) * sqrt(pi / 2)
        assert present(origin.uncertainty) == pytest.approx(spread, rel=1e-12)
        length = read.origins["autocorrelation.length"]
        assert present(length.uncertainty) == pytest.approx(30e-6 / sqrt(12), rel=1e-12)  # 10 to 40 um
        assert (read.ball_rms_roughness, read.origins["ball_rms_roughness"].status) == (0.011e-6, "given")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('finish = "mirror"', ("surface.finish = 'mirror'", "ground, ground and honed, superfinished")),
        ('rms_roughness = "0.1 um"', ("surface.autocorrelation is missing", "Ra or finish")),
        ("", ("exactly one of rms_roughness, Ra, finish and height_map",)),
        ('Ra = "0.1 um"\nasperities = "greenwood_williamson"', ("asperities", "leave it out")),
        ('height_map = { path = "a.npy" }', ("surface.height_map.spacing is missing",)),
        ('height_map = { path = "a.x3p" }', ("surface.height_map.path = 'a.x3p'",)),
        (
            'height_map = { path = "a.npy", spacing = "1 um" }\n'
            'autocorrelation = { kind = "gaussian", length = "33 um", spacing = "3 um" }',
            ("surface.autocorrelation does not go with height_map",),
        ),
    ],
)
def test_a_mistake_of_a_surface_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    says(f"{PLAIN}[surface]\n{text}", *map(re.escape, words))


SEALED = """
name = "sealed"
tolerance = "5 %"
[bearing]
catalog = "6205-2RS1"
inner.shoulder_diameter = "34 mm"
[operation]
axial_load = "200 N"
inner_speed = "300 rpm"
[friction]
coefficient = 0.1
[losses]
seals = "estimate"
"""


def test_a_scene_file_declares_losses() -> None:
    found = scene(MINE + '[losses]\nseals = "5 N mm"\ndrag = "0.3 N cm"\n')
    assert found.losses == Losses(seals=5e-3, drag=3e-3)
    assert scene(MINE).losses == Losses()


def test_the_oil_outside_the_contacts_is_read() -> None:
    found = scene(
        MINE + '[losses]\noil_share = "3 %"\noil_flow = "0.6 l/min"\n'
        'land = { ring = "outer", diameter = "45 mm", clearance = "0.3 mm", width = "4 mm" }\n'
        'pockets = { clearance = "0.2 mm", thickness = "1.7 mm" }\n'
    ).losses
    land = ShearedLand(ring="outer", diameter=45e-3, clearance=0.3e-3, width=4e-3)
    assert (found.land, found.pockets) == (land, ShearedPockets(clearance=0.2e-3, thickness=1.7e-3))
    assert (found.oil_share, found.oil_flow) == (0.03, pytest.approx(1e-5, rel=1e-14))  # one rounding


def test_estimated_seals_touch_the_inner_shoulder() -> None:
    """0.023 d^2.25 + 2 N mm of RS1 seals [SKF2018], d of 34 mm: given, or by the chord of the groove there."""
    found = scene(SEALED)
    expected = 1e-3 * (0.023 * 34**2.25 + 2)
    assert found.losses.seals == pytest.approx(expected, rel=1e-10)  # the shoulder passes through its half-width
    origin = found.losses.origins["seals"]
    assert origin.status == "assumed"
    assert origin.source == "SKF's formula for RS1 seals [SKFSeals], on a diameter of 34 mm"


BALL_RADIUS = 3.969e-3  # m, of a 6205


def oil_of(**keys: object) -> Lubricant:
    document = {
        "name": "6205",
        "tolerance": "2 %",
        "bearing": {"catalog": "6205"},
        "operation": {"axial_load": "730 N", "inner_speed": "410 rpm"},
        "lubricant": {"name": "ISO VG 46", **keys},
        "surface": {"finish": "ground and honed"},
    }
    found = scene_of(document, origin="scene").lubricant
    assert found is not None
    return found


def test_a_share_and_a_length_say_the_same() -> None:
    share = oil_of(reach={"ahead": 0.62}).reach
    length = oil_of(reach={"ahead": f"{0.62e3 * BALL_RADIUS} mm"}).reach
    assert share == Reach(ahead=0.62, behind=0.9)
    assert length.ahead == pytest.approx(share.ahead, rel=1e-3)  # the catalog rounds the ball to 0.01 mm
    assert oil_of(reach={"behind": "70 %"}).reach == Reach(ahead=0.9, behind=0.7)


def test_the_other_choices_reach_the_model() -> None:
    found = oil_of(
        cavitation_pressure="-0.1 MPa", compressible=False, film_formula="nijenbanning", rolling_formula="houpert"
    )
    assert found.cavitation_pressure == -1e5
    assert (found.compressible, found.film_formula, found.rolling_formula) == (False, "nijenbanning", "houpert")


@pytest.mark.parametrize(
    ("keys", "key", "value"),
    [
        ({"reach": {"ahead": "-2 mm"}}, "lubricant.reach.ahead", "mm"),
        ({"reach": {"ahead": "12 mm"}}, "lubricant.reach.ahead", "3.9"),
        ({"reach": 0.7}, "lubricant.reach", "ahead = 0.9"),
    ],
)
def test_mistakes_of_the_reach_are_one_line(keys: dict[str, object], key: str, value: str) -> None:
    refused(lambda: oil_of(**keys), key, value)


def test_a_length_needs_a_ball() -> None:
    refused(lambda: lubricant("ISO VG 46", reach={"ahead": "3 mm"}), "lubricant.reach")  # pyright: ignore


def test_a_spread_is_a_share_of_the_value_or_its_standard_deviation() -> None:
    lines = 'lubricant.viscosity = "6 %"\nlubricant.temperature = "3 K"\nbearing.clearance = "4 um"\n'
    found = {each.key: each for each in uncertain_inputs(scene(f"{OILED}[uncertainty]\n{lines}"))}
    viscosity = found["lubricant.viscosity"]
    assert viscosity.deviation == pytest.approx(0.06 * viscosity.value, rel=1e-12)
    assert found["lubricant.temperature"].deviation == 3
    assert found["bearing.clearance"].deviation == pytest.approx(4e-6, rel=1e-12)


@pytest.mark.parametrize(
    ("lines", "complaint"),
    [
        ('lubricant.viscosity = "-6 %"', r"uncertainty.lubricant.viscosity = '-6 %' must be at least 0 %; give"),
        ('lubricant.viscosity = "301 %"', r"must be at most 300 %; give"),
        ('lubricant.viscosity = "9 Pa s"', r"is more than 300 % of the value, 0.\d+ Pa s"),
        ("lubricant.viscosity = 0.1", r"has no unit; give for example"),
        ('lubricant.viscocity = "6 %"', r"lubricant.viscocity = '6 %' is an unknown key; did you mean visc"),
        ('lubricant.temperature = "2 degC"', r"must be at most 100 K; give for example \"2 K\""),
        ('bearing.clearance = "3 %"', r"is a share, but this input needs the standard deviation itself"),
        ('friction.coefficient = "3 %"', r"is of an input that this scene lacks"),
        # The 6205 has inner grooves of 0.519 times its balls, 0.019 above the tightest groove.
        ("bearing.inner.conformity = 0.07", r"= 0.07 is more than 300 % of the value above 0.5, 0.0\d+; an input that"),
    ],
)
def test_a_wrong_spread_gives_one_line(lines: str, complaint: str) -> None:
    assert says(f"{OILED}[uncertainty]\n{lines}\n", complaint).count("uncertainty.") == 1


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
    says(f"{OILED}[assumed]\n{line}\n", *map(re.escape, words))


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


SIGNED = MINE + '[report]\nauthor = "A. <b>Noether</b>"\nchecker = "E. B."\nrevision = "C"\ndate = "2026-03-01"\n'


def test_names_are_kept_as_they_are_written() -> None:
    assert scene(SIGNED).report == ReportDetails(
        author="A. <b>Noether</b>", checker="E. B.", revision="C", date="2026-03-01"
    )
    assert scene(MINE).report == ReportDetails()
    assert scene(MINE + '[report]\nunits = "inch"\n').report == ReportDetails(units="inch")


def test_a_signature_changes_neither_torque_nor_hash() -> None:
    signed, blank = scene(SIGNED), scene(MINE)
    assert friction_torque(signed).torque.total == friction_torque(blank).torque.total
    first, second = provenance_of(signed), provenance_of(blank)
    assert first.scene_sha256 == second.scene_sha256
    assert "report" not in first.scene_content
