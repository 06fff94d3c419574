"""A torque as one small HTML page: headline, figure, tables, verdicts and effects. It needs no other file."""

from analytic.scene_torque import SceneTorque
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS
from fembearing.report.figures.page_plots import embedded
from fembearing.report.headline import film_words, headline_table, makers_words
from fembearing.report.page.template import filled
from fembearing.report.phrases import numerical_words
from fembearing.report.tables.inputs import effects_table
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.torque import pair_table, torque_table
from fembearing.report.tables.verdicts import physical_table


def torque_page(result: SceneTorque, figure: bytes) -> str:
    """The page;  figure : SVG."""
    friction, verdicts = result.friction, result.verdicts
    assert verdicts.numerical is not None
    units, computed = SYSTEMS[result.scene.report.units], result.places.computed
    tables = [torque_table(result, result.scene.bearing.name, range(len(result.points)), units)]
    tables += [] if friction.pair is None else [pair_table(friction.pair, range(len(computed)), units)]
    return filled(
        "torque_alone.html",
        name=result.scene.name,
        bearing=result.scene.bearing.name,
        headline=headline_table(result, units),
        said=[line for line in (film_words(result), makers_words(result, units)) if line is not None],
        standing=result.standing,
        tables=[*tables, *prediction_tables(result, computed, units)],
        figure=embedded(figure, "svg+xml"),
        notes=result.notes,
        verdict=verdicts.overall,
        numerical=numerical_words(verdicts.numerical),
        physical=physical_table(verdicts.physical, units),
        warnings=friction.warnings,
        effects=effects_table(friction.effects, friction.effects.among(computed).points),
        versions=friction.provenance,
        fingerprint=provenance_of(result.scene).scene_sha256,
    )
