"""JSON Schemas of results, from the types that they are written from."""

from dataclasses import make_dataclass
from typing import Any

from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema
from pydantic_core.core_schema import FloatSchema

from fembearing.plain_types import written_fields
from fembearing.report.duty_folder import DutyFile
from fembearing.report.measured_folder import ComparisonFile
from fembearing.report.report import Report
from fembearing.report.torque import TorqueFile


class NumberOrNull(GenerateJsonSchema):
    """Numbers are null at an operating point that has no torque."""

    def float_schema(self, schema: FloatSchema) -> dict[str, Any]:
        """A number, or null."""
        return {"anyOf": [super().float_schema(schema), {"type": "null"}]}


def report_schema() -> dict[str, Any]:
    """Of report.json and `validate --json`."""
    parts = [(part.name, part.type, part) for part in written_fields(Report)]
    kept = {"__pydantic_config__": {"extra": "forbid"}, "__doc__": Report.__doc__}
    return TypeAdapter(make_dataclass("Report", parts, kw_only=True, namespace=kept)).json_schema()


def torque_schema() -> dict[str, Any]:
    """Of `torque --json`."""
    return TypeAdapter(TorqueFile).json_schema(schema_generator=NumberOrNull)


def comparison_schema() -> dict[str, Any]:
    """Of `compare --json`."""
    return TypeAdapter(ComparisonFile).json_schema()


def duty_schema() -> dict[str, Any]:
    """Of `duty --json`."""
    return TypeAdapter(DutyFile).json_schema()
