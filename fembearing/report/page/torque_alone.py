"""A torque as one small HTML page: table, figure, effects, and what to know of them. It needs no other file."""

from analytic.result import COORDINATES
from fembearing.provenance import provenance_of
from fembearing.report.figures.page_plots import embedded
from fembearing.report.figures.torque import PARTS
from fembearing.report.page.template import filled
from fembearing.report.phrases import (
    LOADS,
    SHARES,
    capital,
    numerical_words,
    uncertainty_of,
)
from fembearing.report.tables.inputs import effects_table
from fembearing.report.tables.verdicts import physical_table
from fembearing.report.torque_table import shown_columns
from fembearing.verify.torque.scene_torque import SceneTorque

HEADS = {  # of the table, from the left
    "inner_speed": "speed",
    **{name: COORDINATES[name].meaning for name in LOADS},
    **{f"torque_{name}": name for name in PARTS},
    "torque_total": "total",
    "uncertainty_numerical": "± numerical",
    "uncertainty_model": "± formulas",
    "interval_low": "95 % from",
    "interval_high": "95 % to",
    "catalogue_low": "catalogue from",
    "catalogue_high": "catalogue to",
}


def torque_page(result: SceneTorque, figure: bytes) -> str:
    """The page;  figure : PNG."""
    friction, verdicts = result.friction, result.verdicts
    assert verdicts.numerical is not None
    model = None if friction.model_uncertainty is None else float(friction.model_uncertainty.max())
    varied = {name: float(part.max()) for name, part in (friction.model_parts or {}).items()}
    known = shown_columns(result)
    shown = {name: known[name] for name in HEADS if name in known and (name not in LOADS or any(known[name].values))}
    return filled(
        "torque_alone.html",
        name=result.scene.name,
        bearing=result.scene.bearing.name,
        heads=[f"{HEADS[name]}, {each.unit.name}" for name, each in shown.items()],
        rows=list(zip(*(each.values.tolist() for each in shown.values()), strict=True)),
        figure=embedded(figure),
        notes=[uncertainty_of(model, varied), f"{capital(result.catalogue.note)}.", *result.notes],
        verdict=verdicts.overall,
        numerical=numerical_words(verdicts.numerical),
        physical=physical_table(verdicts.physical),
        failures=dict.fromkeys(check.note for check in verdicts.physical if check.verdict != "pass"),
        warnings=friction.warnings,
        effects=effects_table(friction.shares),
        shares=SHARES,
        versions=friction.provenance,
        fingerprint=provenance_of(result.scene).scene_sha256,
    )
