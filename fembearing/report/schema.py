"""JSON Schemas of results, from the types that they are written from."""

from dataclasses import make_dataclass
from typing import Any, Literal

from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema
from pydantic_core.core_schema import FloatSchema

from analytic.prediction.duty import DutyCycle
from analytic.standing import WorstStanding
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.plain_types import FORMAT, written_fields
from fembearing.report.report import Report
from fembearing.report.torque import TorqueContent

Kind = Literal["validation", "torque", "compare", "duty"]
TYPES = {"validation": Report, "torque": TorqueContent, "compare": MeasuredComparison, "duty": DutyCycle}
BESIDE = {"duty": {"standing": WorstStanding}}  # other tables of a file


class NumberOrNull(GenerateJsonSchema):
    """Numbers are null at an operating point that has no torque."""

    def float_schema(self, schema: FloatSchema) -> dict[str, Any]:
        """A number, or null."""
        return {"anyOf": [super().float_schema(schema), {"type": "null"}]}


def schema_of(kind: Kind) -> dict[str, Any]:
    """Of what the commands print with --json, and of their files."""
    parts = [(part.name, part.type, part) for part in written_fields(TYPES[kind])]
    kept = {"__pydantic_config__": {"extra": "forbid"}, "__doc__": TYPES[kind].__doc__}
    written = make_dataclass(TYPES[kind].__name__, parts, kw_only=True, namespace=kept)
    schema = TypeAdapter(written).json_schema(schema_generator=NumberOrNull)
    for name, of in BESIDE.get(kind, {}).items():
        inner = TypeAdapter(of).json_schema(schema_generator=NumberOrNull)
        schema.setdefault("$defs", {}).update(inner.pop("$defs", {}))
        schema["properties"][name] = inner
    schema["properties"] |= {"kind": {"const": f"fembearing {kind}"}, "format": {"const": FORMAT}}
    schema["required"] = [*schema["required"], "kind", "format"]
    return schema
