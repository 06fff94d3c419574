"""A torque as one small HTML page: table, figure, effects, and what to know of them. It needs no other file."""

from fembearing.provenance import provenance_of
from fembearing.report.figures.page_plots import embedded
from fembearing.report.page.template import filled
from fembearing.report.phrases import numerical_words
from fembearing.report.tables.inputs import effects_table
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.torque import pair_table, torque_table
from fembearing.report.tables.verdicts import physical_table
from fembearing.report.torque import torque_record
from fembearing.verify.torque.scene_torque import SceneTorque


def torque_page(result: SceneTorque, figure: bytes) -> str:
    """The page;  figure : SVG."""
    friction, verdicts = result.friction, result.verdicts
    assert verdicts.numerical is not None
    torque = torque_record(result)
    tables = [torque_table(torque, result.scene.bearing.name, range(len(torque.points)))]
    tables += [] if torque.pair is None else [pair_table(torque.pair, torque.computed)]
    return filled(
        "torque_alone.html",
        name=result.scene.name,
        bearing=result.scene.bearing.name,
        tables=[*tables, *prediction_tables(torque, torque.computed)],
        figure=embedded(figure, "svg+xml"),
        notes=result.notes,
        verdict=verdicts.overall,
        numerical=numerical_words(verdicts.numerical),
        physical=physical_table(verdicts.physical),
        warnings=friction.warnings,
        effects=effects_table(friction.shares),
        versions=friction.provenance,
        fingerprint=provenance_of(result.scene).scene_sha256,
    )
