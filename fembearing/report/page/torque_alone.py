"""A torque as one small HTML page: table, figure, effects, and what to know of them. It needs no other file."""

from jinja2 import Environment, PackageLoader, StrictUndefined

from fembearing.compare.torque.scene_torque import SceneTorque
from fembearing.provenance import provenance_of
from fembearing.report.figures.page_plots import embedded
from fembearing.report.phrases import SHARES, capital, share_of, uncertainty_of
from fembearing.report.torque_table import shown_columns

SHOWN = ("inner_speed", "axial_load", "radial_load", "moment", "torque_", "uncertainty_", "interval_", "catalogue_")


def torque_page(result: SceneTorque, figure: bytes) -> str:
    """The page;  figure : PNG."""
    environment = Environment(
        loader=PackageLoader("fembearing.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    friction = result.friction
    model = None if friction.model_uncertainty is None else float(friction.model_uncertainty.max())
    varied = {name: float(part.max()) for name, part in (friction.model_parts or {}).items()}
    columns = [each for name, each in shown_columns(result).items() if name.startswith(SHOWN)]
    return environment.get_template("torque_alone.html").render(
        name=result.scene.name,
        bearing=result.scene.bearing.name,
        heads=[each.heading for each in columns],
        rows=list(zip(*(each.values.tolist() for each in columns), strict=True)),
        figure=embedded(figure),
        notes=[uncertainty_of(model, varied), f"{capital(result.catalogue.note)}.", *result.doubts],
        warnings=friction.warnings,
        effects=friction.effects_to_json(),
        share_of=share_of,
        shares=SHARES,
        versions=friction.provenance,
        fingerprint=provenance_of(result.scene)["scene_sha256"],
    )
